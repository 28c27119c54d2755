#!/usr/bin/python3
"""The program fe_reference from outside: interrupted and resumed, on two processes, in trouble.

usage: programs_test.py FE_REFERENCE [unittest options]. Exit code 77: a Python module is missing.
"""

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import h5py
    import numpy
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

PROGRAM = ""
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMP_NUM_THREADS="1")

SCENE = """
title = "bar"
[domain]
size  = [5.0, 2.4]
cells = [50, 24]
[[body]]
shape  = "rectangle"
corner = [2.0, 0.2]
size   = [1.0, 2.0]
[solid]
young_modulus = 2e11
poisson_ratio = 0.3
density       = 7800.0
yield_stress  = 4e8
[[support]]
on           = "top"
displacement = ["DRIVEN_X", "DRIVEN_Y"]
[[support]]
on           = "bottom"
displacement = ["0", "0"]
[[probe]]
name   = "line"
line   = [[1.5, 1.2], [3.5, 1.2]]
points = 11
of     = ["von_mises", "plastic_strain"]
times  = [0.5, 1.0]
[[probe]]
name    = "outline"
outline = "material"
times   = [0.5, 1.0]
[[probe]]
name     = "fields"
snapshot = true
times    = [0.5, 1.0]
[clock]
end = 1.0
[fe]
cells      = [CELLS]
load_steps = STEPS
"""


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def scene(self, driven=("0.1*t", "0"), cells="4, 8", steps=20):
        path = os.path.join(self.folder, "bar.toml")
        text = SCENE.replace("DRIVEN_X", driven[0]).replace("DRIVEN_Y", driven[1])
        with open(path, "w") as file:
            file.write(text.replace("CELLS", cells).replace("STEPS", str(steps)))
        return path

    def command(self, scene, output, *options):
        return [PROGRAM, scene, "--output", os.path.join(self.folder, output), *options]

    def path(self, output, name="fe_reference.h5"):
        return os.path.join(self.folder, output, name)

    def run_to_end(self, command):
        done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=600)
        return done.returncode, done.stdout + done.stderr

    def interrupt(self, scene, output, number=signal.SIGTERM, code=130):
        """A new run, sent the signal `number` a moment after it has opened its record."""
        part = self.path(output, "fe_reference.h5.part")
        before = os.stat(part).st_mtime_ns if os.path.exists(part) else None
        process = subprocess.Popen(self.command(scene, output), env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and (not os.path.exists(part) or os.stat(part).st_mtime_ns == before):
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(number)
        self.assertEqual(process.wait(timeout=600), code, "the run was over before the signal came")

    def calls(self, output):
        """What the profile counts, by part."""
        with h5py.File(self.path(output)) as file:
            profile = file["profile"]
            return dict(zip(profile["part"].asstr()[:], profile["calls"][:].tolist()))

    def observed(self, output):
        """Everything that was observed: path -> array; neither provenance nor timings."""
        found = {}

        def collect(name, item):
            if isinstance(item, h5py.Dataset) and not name.startswith(("provenance", "profile")):
                found[name] = item[()]

        with h5py.File(self.path(output)) as file:
            file.visititems(collect)
        return found

    def test_probes_of_the_melt_are_named_as_skipped(self):
        scene = self.scene()
        with open(scene, "a") as file:
            file.write('[phase_field]\nwidth = 0.1\n[[probe]]\nname = "both"\nline = [[1.5, 1.2], [3.5, 1.2]]\npoints = 3\nof = ["phi", "von_mises"]\n')
            file.write('[[probe]]\nname = "front"\noutline = "phase"\n')
        code, text = self.run_to_end(self.command(scene, "melt", "--plan"))
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r'skipped  phi of \[\[probe\]\] "both" \(.*bar.toml:[0-9]+\)')
        self.assertIn('skipped  the contour of phi of [[probe]] "front"', text)
        self.assertNotIn('"outline"', text)

    def test_resumed_run_is_the_uninterrupted_one_to_the_bit(self):
        scene = self.scene(steps=3000)  # seconds, so that the signal finds it running
        code, text = self.run_to_end(self.command(scene, "whole"))
        self.assertEqual(code, 0, text)

        self.interrupt(scene, "halves")
        self.assertFalse(os.path.exists(self.path("halves")), "an unfinished record has the final name")
        self.assertTrue(os.path.exists(self.path("halves", "fe_reference.checkpoint.h5")))

        code, text = self.run_to_end(self.command(scene, "halves", "--resume"))
        self.assertEqual(code, 0, text)
        whole, halves = self.observed("whole"), self.observed("halves")
        self.assertEqual(sorted(whole), sorted(halves))
        for name, values in whole.items():
            self.assertEqual(values.shape, halves[name].shape, name)
            self.assertEqual(values.tobytes(), halves[name].tobytes(), name)
        self.assertFalse(os.path.exists(self.path("halves", "fe_reference.checkpoint.h5")))
        # It cost what both starts did.
        calls = [self.calls(output) for output in ("whole", "halves")]
        self.assertEqual([parts.pop("set-up") for parts in calls], [1, 2])
        self.assertEqual([parts.pop("output") for parts in calls], [1, 2])
        self.assertGreater(calls[0]["factorisations"], 3000)
        self.assertEqual(*calls)

    def test_a_new_run_never_goes_on_from_the_checkpoint_of_an_earlier_one(self):
        scene = self.scene(steps=3000)
        self.interrupt(scene, "twice")
        self.interrupt(scene, "twice", signal.SIGKILL, -signal.SIGKILL)  # before its first checkpoint
        code, text = self.run_to_end(self.command(scene, "twice", "--resume"))
        self.assertEqual(code, 2, text)
        self.assertIn("no checkpoint", text)

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun here")
    def test_two_processes_give_the_answer_of_one(self):
        scene = self.scene()
        code, text = self.run_to_end(self.command(scene, "one"))
        self.assertEqual(code, 0, text)
        code, text = self.run_to_end(["mpirun", "--oversubscribe", "--bind-to", "none", "-np", "2",
                                      *self.command(scene, "two")])
        self.assertEqual(code, 0, text)
        one, two = self.observed("one"), self.observed("two")
        compared = 0
        for name, values in one.items():
            # What counts iterations may differ; cells of a snapshot may be in another order.
            if not name.endswith("values") or name.startswith("tables/energy"):
                continue
            scale = numpy.nanmax(numpy.abs(values.reshape(-1, values.shape[-1])), axis=0) + 1e-300
            difference = numpy.abs(two[name] - values) / scale
            significant = scale > 1e-12  # a displacement that is held at zero has no relative error
            self.assertLess(numpy.nanmax(difference[..., significant]), 1e-8, name)
            compared += 1
        self.assertGreaterEqual(compared, 3)
        for index in ("0", "1"):
            mean = [record[f"snapshots/fields/{index}/fields/von_mises"].mean() for record in (one, two)]
            self.assertLess(abs(mean[1] / mean[0] - 1.), 1e-8)

    def test_trouble_ends_with_three_and_keeps_what_was_found(self):
        # The ends are driven through each other.
        scene = self.scene(driven=("0", "-3*t"), cells="1, 2")
        code, text = self.run_to_end(self.command(scene, "crushed"))
        self.assertEqual(code, 3, text)
        self.assertIn("no equilibrium beyond t = ", text)
        self.assertIn("Remedy", text)
        with h5py.File(self.path("crushed")) as file:
            load = file.attrs["largest_load_factor"]
            self.assertGreater(load, 0.1)
            self.assertLess(load, 2. / 3.)  # there the bar would have no height left
            self.assertTrue(file.attrs["status"].startswith("failed"))
            self.assertGreater(file.attrs["smallest_jacobian"], 0.)
            self.assertAlmostEqual(file["tables/energy/time"][-1], load, places=9)
        self.assertEqual([n for n in os.listdir(os.path.join(self.folder, "crushed")) if n.endswith(".part")], [])

    def test_trouble_under_way_is_no_bad_input(self):
        # Its checkpoint cannot be written: a folder stands there.
        scene = self.scene(steps=3000)
        os.makedirs(self.path("stuck", "fe_reference.checkpoint.h5.part"))
        process = subprocess.Popen(self.command(scene, "stuck"), env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not os.path.exists(self.path("stuck", "fe_reference.h5.part")):
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        text = process.communicate(timeout=600)[1]
        self.assertEqual(process.returncode, 6, text)
        self.assertIn("repeat with", text)

    def test_a_full_disk_is_no_bad_input_and_no_crash(self):
        # As if the disk got full under way: MPI could not even start under such a limit.
        scene = self.scene(cells="16, 32", steps=400)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # so that a write fails instead; inherited
        process = subprocess.Popen(self.command(scene, "full"), env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True, restore_signals=False)
        while process.poll() is None and not os.path.exists(self.path("full", "fe_reference.h5.part")):
            time.sleep(0.01)
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (60000, 60000))
        text = process.communicate(timeout=600)[1]
        self.assertEqual(process.returncode, 6, text)
        self.assertIn("disk full?", text)
        self.assertIn("repeat with", text)
        self.assertFalse(os.path.exists(self.path("full")), "an unfinished record has the final name")

    def test_record_names_the_libraries_that_it_used(self):
        rectangle = self.scene(cells="2, 4", steps=2)
        disc = os.path.join(self.folder, "disc.toml")
        with open(rectangle) as source, open(disc, "w") as file:
            text = source.read().replace('shape  = "rectangle"', 'shape  = "polygon"')
            corners = "vertices = [[2.0, 0.2], [3.0, 0.2], [3.0, 2.2], [2.0, 2.2]]"
            file.write(text.replace("corner = [2.0, 0.2]", corners).replace("size   = [1.0, 2.0]", ""))
        for scene, output, gmsh in ((rectangle, "structured", False), (disc, "unstructured", True)):
            code, text = self.run_to_end(self.command(scene, output))
            self.assertEqual(code, 0, text)
            with h5py.File(self.path(output)) as file:
                named = dict(file["provenance"].attrs)
            for library in ("deal.II", "trilinos", "hdf5", "eigen") + (("gmsh",) if gmsh else ()):
                self.assertRegex(named.get(library, ""), r"^[0-9]+\.[0-9]+", library)
            self.assertEqual("gmsh" in named, gmsh)

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun here")
    def test_trouble_of_the_process_that_writes_ends_both(self):
        # The folder is taken away before a snapshot is due.
        scene = self.scene(steps=3000)
        process = subprocess.Popen(["mpirun", "--oversubscribe", "--bind-to", "none", "-np", "2",
                                    *self.command(scene, "gone")], env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        try:
            while process.poll() is None and not os.path.exists(self.path("gone", "fe_reference.h5.part")):
                time.sleep(0.01)
            time.sleep(1.0)  # until the file is not only made but opened: before that it would be bad input
            shutil.rmtree(os.path.join(self.folder, "gone"))
            text = process.communicate(timeout=600)[1]
        finally:
            process.kill()
        self.assertEqual(process.returncode, 6, text)
        self.assertIn("fe_reference.h5.part", text)

    def test_a_plan_in_trouble_ends_with_three(self):
        # However short the first step is cut, the ends are driven through each other: no clock ends the plan before that.
        code, text = self.run_to_end(self.command(self.scene(driven=("0", "-9*ramp(t, 1e-12)"), cells="1, 2", steps=2), "crushed", "--plan"))
        self.assertEqual(code, 3, text)
        self.assertIn("no equilibrium beyond t = ", text)
        self.assertIn("repeat with", text)

    def test_a_plan_stays_within_the_clock(self):
        # Beyond the end the support has no displacement.
        code, text = self.run_to_end(self.command(self.scene(driven=("0.001*(1 - sqrt(1 - t))", "0"), steps=1), "plan", "--plan"))
        self.assertEqual(code, 0, text)
        self.assertIn("forecast cpu_s=", text)

    def test_going_on_needs_a_checkpoint(self):
        code, text = self.run_to_end(self.command(self.scene(), "fresh", "--resume"))
        self.assertEqual(code, 2, text)
        self.assertIn("no checkpoint", text)
        self.assertIn("without --resume", text)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "fresh")))

    def test_bad_scene_ends_with_two_and_leaves_no_record(self):
        scene = self.scene(cells="-4, 8")
        code, text = self.run_to_end(self.command(scene, "bad"))
        self.assertEqual(code, 2, text)
        self.assertIn("cells", text)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "bad")))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
