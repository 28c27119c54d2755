#!/usr/bin/python3
"""Sentences of Sec. 3 are judged as the records deserve, and asymmetry is measured where it is."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
POSTPROCESS = HERE.parents[1] / "postprocess"
sys.path[:0] = [str(HERE), str(POSTPROCESS)]
sys.dont_write_bytecode = True

try:
    import h5py  # noqa: F401
    import numpy as np
    import matplotlib  # noqa: F401
except ImportError as missing:
    print(f"SKIPPED: {missing}; install python3-h5py and python3-matplotlib, run with /usr/bin/python3")
    sys.exit(77)

import asymmetry  # noqa: E402
import claims  # noqa: E402
import claims_beside  # noqa: E402
import claims_slender  # noqa: E402
import record  # noqa: E402
import synthetic  # noqa: E402


def to_metres_and_pascals(path, limit="yield_stress = 5e6"):
    """Rewrites a record in units W0, tau0, sigma_Y as one with W0 = 1e-6 m and sigma_Y = 5 MPa (tau0 = 1 s)."""

    def rescale(name, item):
        last = name.split("/")[-1]
        if isinstance(item, h5py.Dataset) and (last in ("x", "y", "vertex") or name == "tables/tip/values"):
            item[...] = 1e-6 * item[...]
        if last == "displacement_y":
            item[...] = 1e-6 * item[...]
        if name == "tables/melt/values":  # compression, wall_top_position
            item[:, 1] = 1e-6 * item[:, 1]
        if last == "von_mises":
            item[...] = 5e6 * item[...]

    with h5py.File(path, "r+") as file:
        file.visititems(rescale)
        text = file["provenance/scene"].asstr()[()]
        text = text.replace('system = "W0-tau0-sigmaY"', 'system = "SI"').replace("yield_stress  = 1.0", limit).replace("width = 1.0", "width = 1e-6")
        for one in ("[240.0, 160.0]", "[480.0, 320.0]", "[-240.0, -160.0]"):
            text = text.replace(one, str([1e-6 * x for x in json.loads(one)]))
        del file["provenance/scene"]
        file["provenance/scene"] = text


class Verdicts(unittest.TestCase):
    """Of invented dendrites whose stress grows with compression and height, and whose plastic strain is at the walls."""

    def of(self, measure, **dendrite):
        with tempfile.TemporaryDirectory() as folder:
            synthetic.compressed(folder, **dendrite)
            self.claims = measure(record.Results(folder))
        return {claim.sentence: claim.found for claim in self.claims}

    def test_have_three_words(self):
        self.assertEqual(claims.judge("", True, "", "of a reason").found, "seen")
        self.assertEqual(claims.judge("", False, "").found, "not seen")
        self.assertEqual(claims.judge("", False, "", "it is so").found, "differs because it is so")
        self.assertEqual(claims.judge("", False, "", "it is so", applies=False).found, "not seen")

    def test_of_a_dendrite_whose_core_stays_elastic(self):
        found = self.of(claims.of_figure12)
        self.assertEqual(len(found), 11)
        self.assertEqual(found["the shape of the horizontal arms is unaffected"], "seen")
        self.assertEqual(found["the stresses in the centre continually increase"], "seen")
        self.assertEqual(found["in the centre the yield stress is not reached at 15 %"], "seen")
        self.assertEqual(found["the deformation for small compressive strains is limited to the vertical arms near the walls"], "seen")
        self.assertEqual(found["the centres of the vertical arms do not turn, by symmetry"], "seen")

    def test_of_a_layer_that_yields_give_no_reason(self):
        found = self.of(claims.of_figure12)  # its stress is highest at the wall: no reason of the list applies
        self.assertEqual(found["a thin layer of solid directly adjacent to the walls stays below the yield stress"], "not seen")

    def test_of_a_core_that_yields_say_why_the_stress_rises_no_more(self):
        found = self.of(claims.of_figure12, yields=11)
        self.assertEqual(
            found["the stresses in the centre continually increase"],
            "differs because they rise until the core yields, and no further",
        )
        self.assertNotEqual(found["in the centre the yield stress is not reached at 15 %"], "seen")

    def test_of_tips_that_the_melt_carries_along(self):
        sentence = "the shape of the horizontal arms is unaffected"
        self.assertEqual(self.of(claims.of_figure12, carried=1.0)[sentence], "seen")  # 0.1 W0 at 10 %, a twentieth of a cell
        self.assertIn("carries the tips along", self.of(claims.of_figure12, carried=30.0)[sentence])

    def test_of_the_slender_dendrite(self):
        found = self.of(claims_slender.of_figures13_to_15, yields=4)
        self.assertEqual(len(found), 11)
        self.assertEqual(found["at 30 % elastic stresses propagate into the horizontal arms"], "seen")
        self.assertEqual(found["at 20 % the centre is starting to yield"], "not seen")  # 0.8 sigma_Y
        self.assertIn("all of it", self.of(claims_slender.of_figures13_to_15, yields=6)["at 20 % the centre is starting to yield"])
        self.assertIn(  # the invented strain goes with the compression: twice at 30 % what it is at 15 %
            "times as large, at twice the compression", found["plastic strains and angle changes are much larger than in Fig. 12"]
        )

    def test_do_not_depend_on_the_units_of_the_record(self):
        for measure in (claims.of_figure12, claims_slender.of_figures13_to_15):
            with tempfile.TemporaryDirectory() as folder:
                synthetic.compressed(folder, carried=30.0)
                dimensionless = measure(record.Results(folder))
                for path in pathlib.Path(folder).rglob("*.h5"):
                    to_metres_and_pascals(path)
                self.assertEqual([c.found for c in measure(record.Results(folder))], [c.found for c in dimensionless])
                self.assertEqual([c.measured for c in measure(record.Results(folder))], [c.measured for c in dimensionless])

    def test_are_refused_without_a_yield_stress(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic.compressed(folder)
            to_metres_and_pascals(pathlib.Path(folder) / "compress_dendrite" / "scene" / "mpm_pf.h5", "")
            with self.assertRaisesRegex(record.Missing, "yield_stress"):
                claims.of_figure12(record.Results(folder))

    def test_are_printed_as_the_table_of_a_readme(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic.compressed(folder)
            said = subprocess.run(
                [sys.executable, POSTPROCESS / "claims_table.py", folder], capture_output=True, text=True, check=True
            ).stdout
        rows = [line for line in said.splitlines() if line.startswith("| ")]
        self.assertEqual(len(rows), 2 * 2 + 11 + 11 + 2 + 7)
        self.assertTrue(all(row.count(" | ") == 2 for row in rows[:-9]), said)
        self.assertTrue(rows[-9].startswith("|  | resolved, 5 % | resolved, 10 %"), said)
        self.assertIn("| mean von Mises stress near the centre, sigma_Y | 0.15 | 0.30 | 0.30 | 0.60 |", rows)  # three times the compression


class InPassing(unittest.TestCase):
    """What Sec. 3 quotes of the first author's thesis."""

    def test_a_contour_beside_a_moving_wall_is_moved_back_by_its_way(self):
        scene = synthetic.scene_text("wall_galilean")  # dx = 0.2 W0
        for off, found in ((0.02, "seen"), (0.2, "not seen")):
            with tempfile.TemporaryDirectory() as folder:
                for run, moved in (("mpm_pf", 8.0), ("at_rest", 0.0)):
                    with synthetic.Invented(folder, "wall_galilean", run, scene) as out:
                        out.table("melt", [0.0, 80.2], wall_left_position=np.array([0.0, moved]))
                        out.outline("contour", 80.2, [synthetic.crystal(40) + [moved + (off if moved else 0.0), 0.0]])
                (claim,) = claims_beside.of_wall(record.Results(folder))
            self.assertEqual(claim.found.split(":")[0], found)
            self.assertIn(f"after 40 cells: {off / 0.2:.2f} dx at most", claim.measured)

    def test_viscosity_is_judged_by_its_group_and_the_walls_work(self):
        quarter = synthetic.scene_text("compress_dendrite")
        grid = np.linspace(0, 240, 61), np.linspace(0, 160, 41)
        with tempfile.TemporaryDirectory() as folder:
            for run, group, work in (("mpm_pf", None, 2.0), ("De_0.01", 0.01, 2.1), ("De_1", 1.0, 5.0)):
                scene = quarter if group is None else quarter.replace("[solid]", f"[solid]\nviscosity = {group * 160 / 0.0878}")
                with synthetic.Invented(folder, "compress_dendrite_viscous", run, scene) as out:
                    out.table("melt", [900.0, 1000.0, 1001.0, 1150.0], compression=np.array([0, 0, 0.001, 0.15]), external_work=work * np.array([0, 0, 0.01, 1]))
                    for share, at in synthetic.STEPS[:4]:
                        synthetic.compressed_state(out, at, *grid, share, 3, 0.0)
            (claim,) = claims_beside.of_viscous(record.Results(folder))
        self.assertTrue(claim.found.startswith("seen at De = 0.01; beyond"), claim.found)
        self.assertIn("to 15 % at De = 0.01, 1: the walls' work is 1.05, 2.5 times", claim.measured)


class Flanks(unittest.TestCase):
    def test_turn_where_the_swing_is_large_enough(self):
        flank = np.array([5.0, 3.0, 3.2, 6.0, np.nan, 5.8, 4.0, 4.5, 4.1, 7.0])
        self.assertEqual(claims_slender.turns(flank, 1.5), ([1, 6], [3]))
        self.assertEqual(claims_slender.turns(flank, 10.0), ([], []))

    def test_reach_to_the_outermost_crossing_of_their_quarter(self):
        diamond = np.array([[3.0, 0.0], [0.0, 6.0], [-2.0, 0.0], [0.0, -6.0]])
        inner = np.array([[1.0, 0.0], [0.0, 2.0], [-1.0, 0.0], [0.0, -2.0]])
        widths = {signs: claims_slender.half_widths([diamond, inner], [2.0, 7.0], signs) for signs in claims_slender.QUARTERS}
        for (x, _), found in widths.items():
            np.testing.assert_allclose(found, [2.0 if x > 0 else 4.0 / 3.0, np.nan])


class Necks(unittest.TestCase):
    def test_are_told_apart_by_where_they_yield(self):
        """An hourglass of half-width 20 at y = 50, of 40 at y = 10 and 90: its rim yields, or its inside does."""
        y = np.linspace(1.0, 120.0, 240)
        width = 20.0 + np.abs(y - 50.0) / 2
        outline = np.vstack([np.column_stack([width, y]), np.column_stack([-width, y])[::-1]])
        vertex = synthetic.lattice((0, 0), (70, 120), 0.5)
        vertex = vertex[vertex[:, 0] < np.interp(vertex[:, 1], y, width)]
        depth = np.interp(vertex[:, 1], y, width) - vertex[:, 0]

        def measured(von_mises):
            state = claims.Compressed.__new__(claims.Compressed)
            state.vertex, state.von_mises, state.wall = vertex, von_mises, 120.0
            arms = claims_slender.Arms.__new__(claims_slender.Arms)
            arms.curves, arms.quarters = [outline], [(1, 1)]
            return claims_slender.around_neck(arms, state, (1, 1))

        near_neck = np.abs(vertex[:, 1] - 50.0) < 6.0
        rim, inner, mean, beside = measured(np.where(near_neck & (depth < 6.0), 1.0, 0.3))
        self.assertEqual((rim, inner, mean), (1.0, 0.0, 1.0))
        self.assertAlmostEqual(beside, 0.3)
        rim, inner, _, _ = measured(np.where(depth > 10.0, 1.0, 0.3))
        self.assertEqual((rim, inner), (0.0, 1.0))


class Asymmetry(unittest.TestCase):
    def test_is_the_distance_to_the_nearest_edge(self):
        square = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
        points = np.array([[1.0, 0.3], [3.0, 1.0], [3.0, 3.0], [2.0, 2.0]])
        np.testing.assert_allclose(asymmetry.distances(points, [square], chunk=3), [0.3, 1.0, np.sqrt(2), 0.0], atol=1e-15)

    def test_of_a_swirl_shows_in_the_mirrors_and_not_after_half_a_turn(self):
        with tempfile.TemporaryDirectory() as folder:
            synthetic.compressed(folder, swirl=0.02)
            run = record.Results(folder).record("compress_dendrite", "whole")
            contour = asymmetry.of_contour(run, 1000.0)
            run.file.close()
        self.assertLess(contour["turned by half"], 1e-10)
        for image in ("mirrored in x", "mirrored in y"):
            # The flank turns by 0.02 and its image by -0.02: some 0.04 of 100 W0, in cells of 2 W0.
            self.assertGreater(contour[image], 0.5)
            self.assertLess(contour[image], 5.0)

    def test_of_stress_is_a_root_mean_square_over_the_yield_stress(self):
        half = np.random.default_rng(1).uniform((-200, 0), (200, 150), (4000, 2))
        vertex = np.vstack([half, -half])
        scene = synthetic.scene_text("compress_dendrite").replace("yield_stress  = 1.0", "yield_stress  = 2.0")
        scene = scene.replace("[domain]", "[domain]\norigin = [-240.0, -160.0]").replace("[240.0, 160.0]", "[480.0, 320.0]")
        with tempfile.TemporaryDirectory() as folder:
            with synthetic.Invented(folder, "case", "whole", scene) as out:  # higher where x and y have one sign
                out.points("solid", 1.0, vertex, von_mises=1.0 + 0.1 * np.sign(vertex.prod(axis=1)))
            run = record.Results(folder).record("case", "whole")
            stress = asymmetry.of_stress(run, 1.0)
            run.file.close()
        self.assertLess(stress["turned by half"], 1e-14)
        self.assertAlmostEqual(stress["mirrored in x"], 0.1, delta=1e-12)
        self.assertAlmostEqual(stress["mirrored in y"], 0.1, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
