#!/usr/bin/python3
"""mpm_pf/record/README.md names all that stands in a record of either solver, and its Python runs.

usage: readme_test.py [unittest options], programs in MPM_PF_BIN. Exit code 77: a module or fe_reference is missing.
"""

import contextlib
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
except ImportError as missing:
    print(f"SKIPPED: {missing}; install python3-h5py, run with /usr/bin/python3")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(os.environ.get("MPM_PF_BIN", ROOT / "build/release/bin"))
PAGE = (ROOT / "mpm_pf/record/README.md").read_text()
NAMES = set(re.findall(r"`([^`\n]+)`", re.sub(r"```.*?```", "", PAGE, flags=re.S)))
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
# every module of the solvers once, on meshes that take a second
RUNS = [
    ("mpm_pf", "shear", ["domain.cells=[50,24]"]),
    ("fe_reference", "shear", []),
    ("mpm_pf", "compress_dendrite", []),
    ("mpm_pf", "free_growth", ["domain.size=[32.0,32.0]", "domain.cells=[80,80]", "clock.end=5.0", "probe.contour.every=5.0"]),
    ("mpm_pf", "advect_circle", []),
    ("mpm_pf", "noise", []),
]


def general(name):
    """Names that a scene makes, as the page writes them."""
    name = re.sub(r"^wall_(left|right|bottom|top)_position$", "wall_SIDE_position", name)
    return re.sub(r"^bytes .*", "bytes MODULE", name)


def names_in(record):
    """All names that the layout knows, without those of probes: {name: where it was seen}."""
    found = {name: "/" for name in [*record.attrs, *record]}
    for kind in ("tables", "lines"):
        for probe, group in record.get(kind, {}).items():
            found |= {name: f"{kind}/{probe}" for name in [*group, *group.attrs, *group.attrs["columns"]]}
    for kind in ("outlines", "snapshots"):
        for probe, numbered in record.get(kind, {}).items():
            for group in numbered.values():
                found |= {name: f"{kind}/{probe}" for name in [*group, *group.attrs, *group.get("fields", {})]}
                if "kind" in group.attrs:
                    found[group.attrs["kind"]] = f"{kind}/{probe}"
    for group in ("provenance", "profile"):
        found |= {name: group for name in [*record[group], *record[group].attrs]}
    return found


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        for program, case, settings in RUNS:
            call = [BIN / program, ROOT / f"benchmarks/{case}/smoke.toml", "--output", cls.folder / "results" / case]
            for setting in settings:
                call += ["--set", setting]
            subprocess.run([str(word) for word in call], env=ENVIRONMENT, check=True, capture_output=True)

    def test_names_all_that_stands_in_a_record(self):
        headings = {"tables": "tables/NAME", "lines": "lines/NAME", "outlines": "outlines/NAME/0, 1, ...", "snapshots": "snapshots/NAME/0, 1, ..."}
        for program, case, _ in RUNS:
            with h5py.File(self.folder / "results" / case / f"{program}.h5") as record:
                for name, where in names_in(record).items():
                    self.assertIn(headings.get(name, general(name)) if where == "/" else general(name), NAMES, f"{program}, {case}: {where}")

    def test_tells_of_the_seed_where_there_is_noise(self):
        for case, there in (("noise", True), ("free_growth", False)):
            with h5py.File(self.folder / "results" / case / "mpm_pf.h5") as record:
                self.assertEqual("seed" in record["provenance"].attrs, there, case)

    def test_has_the_units_that_stand_there(self):
        with h5py.File(self.folder / "results/compress_dendrite/mpm_pf.h5") as record:
            group = record["tables/melt"]
            units = dict(zip(group.attrs["columns"], group.attrs["units"]))
        for line in PAGE.split("### History of mpm_pf")[1:]:
            for names, unit in re.findall(r"^\| (`[^|]*) \| `([^`|]*)` \|", line.split("### History of fe")[0], re.M):
                for name in re.findall(r"`(\w+)`", names):
                    if name in units:
                        self.assertEqual(units[name], unit, name)

    def test_python_runs(self):
        snippets = re.findall(r"```python\n(.*?)```", PAGE, re.S)
        self.assertEqual(len(snippets), 4)
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        for snippet in snippets:
            with contextlib.redirect_stdout(io.StringIO()) as said:
                exec(compile(snippet, "README.md", "exec"), {})
            self.assertTrue(said.getvalue())
            self.assertNotIn("nan", said.getvalue())


if __name__ == "__main__":
    if not (BIN / "fe_reference").exists():
        print("SKIPPED: fe_reference is not built; install deal.II")
        sys.exit(77)
    unittest.main()
