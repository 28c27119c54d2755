"""A scene does not get dearer because another module was added to the program, and work follows the scene, not the domain.

On another tool chain than that of the stored counts these are not compared, and the test says so; MPM_PF_INSTRUCTIONS=1 compares them all the same.
"""

import json
import os
import shutil
import unittest

import instructions

TOLERANCE = 0.02


def with_domain(name, scene, settings, size, cells, **more):
    return dict(name=name, scene=scene, set=[*settings, f"domain.size={list(size)}", f"domain.cells={list(cells)}"], **more)


class Instructions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not shutil.which("valgrind"):
            raise AssertionError("valgrind is not installed")
        stored = json.loads(instructions.RUNS.read_text())
        cls.stored = stored["runs"]
        for program in sorted({run.get("program", "mpm_pf") for run in cls.stored}):
            if not (instructions.PROGRAMS / program).is_file():
                build = f"cmake --preset instructions && cmake --build --preset instructions --target {program}"
                raise AssertionError(f"{instructions.PROGRAMS / program} is not built: {build}")
        cls.foreign = instructions.differences(stored.get("tool_chain"), instructions.tool_chain(cls.stored[0]))
        if os.environ.get("MPM_PF_INSTRUCTIONS"):
            cls.foreign = []
        cls.compared = [] if cls.foreign else [run for run in cls.stored if run.get("instructions")]
        # the same body in the corner of domains of 1, 2 and 4 times the size
        bar = ["clock.end=0.01", "probe.outline.times=[0.01]", "probe.fields.times=[0.01]"]
        bars = [with_domain(f"bar {n}", "shear/smoke.toml", bar, (5.0 * n, 2.4 * n), (50 * n, 24 * n)) for n in (1, 2, 4)]
        # a seed in the corner of two domains, and one of four times the radius
        end = ["clock.end=0.8", "probe.melt.every=0.8", "probe.contour.every=0.8", 'probe."tip east".every=0.8', 'probe."tip north".every=0.8']
        seeds = [with_domain(f"seed {n}", "free_growth/smoke.toml", end, (64.0 * n, 64.0 * n), (160 * n, 160 * n), inside="grow(*") for n in (1, 2, 4)]
        large = with_domain("large seed", "free_growth/smoke.toml", [*end, "body.seed.radius=32.0"], (256.0, 256.0), (640, 640), inside="grow(*")
        # a wall that waits 20 W0 before the tip, over domains 1 and 4 times as wide and as high
        waiting = ["clock.end=12.0", "wall.1.start_distance=20.0", *(f"probe.{name}.compressions=[0.0]" for name in ("fields", "contour", "arm"))]
        walls = [
            with_domain(f"{inside} {x} {y}", "compress_dendrite/smoke.toml", waiting, (60.0 * x, 40.0 * y), (75 * x, 50 * y), inside=inside)
            for inside in ("move_walls(*", "medium::update_cuts(*")
            for x, y in ((1, 1), (4, 1), (1, 4), (4, 4))
        ]
        cls.others = [*bars, *seeds, large, *walls]
        cls.numbers = instructions.count_all(cls.compared + cls.others)

    def test_every_run_has_an_accepted_count(self):
        self.assertEqual(instructions.not_accepted(self.stored), [])

    def test_no_run_got_dearer(self):
        if self.foreign:
            self.skipTest("another tool chain than that of the stored counts (MPM_PF_INSTRUCTIONS=1 compares all the same): " + "; ".join(self.foreign))
        for run in self.compared:
            with self.subTest(run["name"]):
                now = self.numbers[run["name"]]
                self.assertLess(
                    abs(now / run["instructions"] - 1),
                    TOLERANCE,
                    f'{now} instructions, {run["instructions"]} stored; if the change is meant: tests/instructions/instructions.py --accept "{run["name"]}"',
                )

    def test_mechanics_cost_follows_the_body_not_the_domain(self):
        first = self.numbers["bar 1"]
        for n in (2, 4):
            self.assertLess(abs(self.numbers[f"bar {n}"] / first - 1), 0.10, self.numbers)

    def test_growth_cost_follows_interface_and_heat_more_than_the_domain(self):
        # judging the tiles, every 16th step, looks at every node: sixteen times the domain costs twice as much, not sixteen times
        first = self.numbers["seed 1"]
        self.assertLess(self.numbers["seed 2"] / first, 1.5, self.numbers)
        self.assertLess(self.numbers["seed 4"] / first, 2.5, self.numbers)
        self.assertGreater(self.numbers["large seed"] / self.numbers["seed 4"], 1.5, "four times the interface")

    def test_walls_cost_follows_their_length(self):
        first = self.numbers["move_walls(* 1 1"]
        self.assertLess(abs(self.numbers["move_walls(* 1 4"] / first - 1), 0.02, self.numbers)
        self.assertLess(abs(self.numbers["move_walls(* 4 1"] / first / 4 - 1), 0.10, self.numbers)
        # fields end at all four sides: sixteen times the domain has four times the sides
        self.assertLess(self.numbers["medium::update_cuts(* 4 4"] / self.numbers["medium::update_cuts(* 1 1"], 4.2, self.numbers)


if __name__ == "__main__":
    unittest.main()
