#!/usr/bin/python3
"""Records are read as they were written, every figure is drawn from them, and what is missing is said."""

import contextlib
import csv
import io
import pathlib
import subprocess
import sys
import tempfile
import types
import unittest

HERE = pathlib.Path(__file__).resolve().parent
POSTPROCESS = HERE.parents[1] / "postprocess"
sys.path[:0] = [str(HERE), str(POSTPROCESS)]
sys.dont_write_bytecode = True

try:
    import h5py  # noqa: F401
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError as missing:
    print(f"SKIPPED: {missing}; install python3-h5py and python3-matplotlib, run with /usr/bin/python3")
    sys.exit(77)

import figures  # noqa: E402
import panels  # noqa: E402
import record  # noqa: E402
import synthetic  # noqa: E402

WRITE_SAMPLES = sys.argv.pop(1) if len(sys.argv) > 1 else None


def run(*arguments):
    """Exit code and output of figures.py in this process."""
    said = io.StringIO()
    old, sys.argv = sys.argv, ["figures.py", *map(str, arguments)]
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = figures.main()
    finally:
        sys.argv = old
    return code, said.getvalue()


class Scratch(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)


class Figures(Scratch):
    def test_cover_the_paper(self):
        wanted = [f"fig{k}" for k in range(1, 7)] + ["fig7a", "fig7b"] + [f"fig{k}" for k in range(8, 13)]
        wanted += ["fig12_asymmetry", "fig12_claims", "fig13", "fig14", "fig15", "fig15_claims", "fig16", "fig17"]
        drawn = figures.all_figures(HERE.parents[1] / "benchmarks")
        self.assertEqual([name for name in drawn if name.startswith("fig")], wanted)  # cases beside the paper have names of their own

    def test_are_drawn_with_their_curves_and_always_with_the_same_bytes(self):
        synthetic.cantilever(self.folder)
        synthetic.shear(self.folder)
        names = ("fig5", "fig9")
        for place in ("a", "b"):
            code, said = run(self.folder, "--output", self.folder / place, "--only", *names)
            self.assertEqual(code, 0, said)
        for name in names:
            for kind in ("pdf", "svg", "png", "csv"):
                first, second = ((self.folder / place / f"{name}.{kind}").read_bytes() for place in ("a", "b"))
                self.assertGreater(len(first), 1000)
                self.assertEqual(first, second, f"{name}.{kind}")
        for kind in ("pdf", "svg", "png", "csv"):
            self.assertIn(b"commit 0123456789 with changes", (self.folder / "a" / f"fig5.{kind}").read_bytes(), kind)
        with open(self.folder / "a" / "fig5.csv", encoding="utf-8") as file:
            rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        tip = {row["curve"]: float(row["y"]) for row in rows if float(row["x"]) == 8.0}
        # P/(6 E' I) ((4 + 5 nu') h^2 L/4 + 2 L^3), E' = E/(1 - nu^2), nu' = nu/(1 - nu)
        exact = 100 / (6 * 3e7 / 0.91 / 12) * ((4 + 15 / 7) * 2 + 16 * 64)
        self.assertAlmostEqual(tip["Timoshenko, plane strain"], exact, delta=1e-9 * exact)
        self.assertAlmostEqual(tip["material points"], 1.01 * exact, delta=1e-6 * exact)

    def test_of_the_crystal_are_drawn(self):
        synthetic.melt(self.folder)
        synthetic.compressed(self.folder)
        synthetic.squeezed(self.folder)
        names = ["fig3", "fig11", "fig12", "fig12_asymmetry", "fig12_claims", "fig13", "fig14", "fig15", "fig15_claims"]
        names += ["slender", "squeeze_mach"]
        code, said = run(self.folder, "--only", *names)
        self.assertEqual(code, 0, said)
        self.assertNotIn("skipped", said)
        for name in names:
            self.assertGreater((self.folder / f"figures/{name}.png").stat().st_size, 10000, name)

    def test_say_what_they_skip_and_why(self):
        synthetic.cantilever(self.folder)
        (self.folder / "cantilever/scene/fe_reference.h5").rename(self.folder / "cantilever/scene/fe_reference.h5.part")
        code, said = run(self.folder, "--only", "fig4", "fig5", "fig7a")
        self.assertEqual(code, 0, said)
        self.assertIn("fig4: drawn", said)
        self.assertIn("fig5: skipped: cantilever/scene/fe_reference: the run is unfinished", said)
        self.assertIn("fig7a: skipped: tension_compression", said)
        self.assertFalse((self.folder / "figures/fig5.pdf").exists())

    def test_of_others_are_drawn_where_one_fails(self):
        draws = "from matplotlib import pyplot\ndef draw(results):\n    return pyplot.figure(), []\nFIGURES = {'fig2': draw}\n"
        fails = "def draw(results):\n    return 1 / 0\nFIGURES = {'fig1': draw}\n"
        cases = self.folder / "cases"
        for case, text in (("a", fails), ("b", draws), ("c", "import a_module_that_is_not_there\n")):
            (cases / case).mkdir(parents=True)
            (cases / case / "figure.py").write_text(text)
        code, said = run(self.folder, "--cases", cases)
        self.assertEqual(code, 1, said)
        for line in ("fig1: failed: ZeroDivisionError", "fig2: drawn", "c: failed: ModuleNotFoundError"):
            self.assertIn(line, said)
        self.assertTrue((self.folder / "figures/fig2.pdf").exists())
        self.assertEqual(run(self.folder, "--cases", cases, "--only", "fig2")[0], 0)

    def test_have_exit_codes(self):
        self.assertEqual(run(self.folder, "--only", "fig5")[0], 4)
        self.assertEqual(run(self.folder / "nowhere")[0], 2)
        code, said = run(self.folder, "--only", "fig99")
        self.assertEqual(code, 2)
        self.assertIn("fig7a", said)


class ShearRate(unittest.TestCase):
    def test_is_a_number_or_a_fraction(self):
        module = figures.all_figures(HERE.parents[1] / "benchmarks")["fig3"].__globals__
        rate, missing = module["shear_rate"], module["record"].Missing

        def run_with(velocity):
            return types.SimpleNamespace(label="run", scene={"imposed": {"velocity": ["0", velocity]}})

        for velocity in ("-0.002*x", "-1/500*x", "-2e-3 * x", "-0.2/100*x"):
            self.assertAlmostEqual(rate(run_with(velocity)), 0.002, delta=1e-15, msg=velocity)
        for velocity in ("-a/b*x", "-1/0*x", "0.002*x", 0.0, "-1/2/3*x", "-x"):
            with self.assertRaisesRegex(missing, "is not -g[*]x", msg=velocity):
                rate(run_with(velocity))
        with self.assertRaises(missing):
            rate(types.SimpleNamespace(label="run", scene={}))


class Records(Scratch):
    def test_of_the_best_suite_that_has_all_runs_are_taken(self):
        for suite, runs in (("scene", ["a"]), ("quick", ["a", "b"]), ("smoke", ["a", "b"])):
            for name in runs:
                with synthetic.Invented(self.folder, "case", name, "", suite):
                    pass
        results = record.Results(self.folder)
        self.assertEqual(results.record("case", "a").label, "case/scene/a")
        self.assertEqual([r.label for r in results.records("case", ["a", "b"])], ["case/quick/a", "case/quick/b"])

    def test_that_failed_are_not_drawn(self):
        with synthetic.Invented(self.folder, "case", "a", "") as out:
            out.file.attrs["status"] = "failed: step 3 diverged"
        with self.assertRaisesRegex(record.Missing, "step 3 diverged"):
            record.Results(self.folder).record("case", "a")

    @unittest.skipUnless(WRITE_SAMPLES, "needs the path of write_samples")
    def test_of_the_solvers_own_writer_are_read(self):
        subprocess.run([WRITE_SAMPLES, str(self.folder)], check=True)
        run_ = record.Record(self.folder / "all.h5")
        self.assertEqual(run_.scene["title"], "Samples")
        self.assertEqual(run_.number("steps"), 12)
        self.assertEqual(run_.table("energy")["kinetic"][3], 0.1 * 3)
        self.assertEqual(len(run_.outline("contour", 1.1)), 2)
        self.assertTrue(np.isnan(run_.line("line", 0.5)["phi"][1]))
        self.assertEqual(run_.snapshot_of("phi", 0.2, "grid").fields["phi"].shape, (3, 4))
        self.assertEqual(run_.snapshot("mesh").connectivity.shape, (2, 4))
        with self.assertRaisesRegex(record.Missing, "was not recorded at t = 0.55"):
            run_.outline("contour", 0.55)
        with self.assertRaisesRegex(record.Missing, "energy"):
            run_.table("nonsense")


class Panels(unittest.TestCase):
    def test_point_means_are_cell_means(self):
        vertex = np.array([[0.1, 0.1], [0.9, 0.9], [1.5, 0.5]])
        means = panels.point_means(vertex, np.array([1.0, 3.0, 7.0]), (0, 0), (1, 1), (2, 2))
        np.testing.assert_array_equal(means, [[2, 7], [np.nan, np.nan]])

    def test_holes_turn_the_other_way(self):
        square = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
        hole = 1 + square / 2
        path = panels.closed_path([square, hole])
        self.assertGreater(panels.signed_area(path.vertices[:4]), 0)
        self.assertLess(panels.signed_area(path.vertices[5:9]), 0)


if __name__ == "__main__":
    unittest.main()
