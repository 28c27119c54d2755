#!/usr/bin/python3
"""The program mpm_pf from outside where it cannot write: no room on the disk, a folder in the way.

usage: programs_test.py MPM_PF [unittest options]. Exit code 77: a Python module is missing.
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
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

PROGRAM = ""
ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1")

SCENE = """
title = "block"
[domain]
size  = [3.0, 3.0]
cells = [30, 30]
[[body]]
shape    = "rectangle"
corner   = [0.5, 1.0]
size     = [1.0, 1.0]
velocity = ["SPEED", "0"]
[solid]
young_modulus = 1000.0
poisson_ratio = 0.3
density       = 1.0
[[probe]]
name    = "energy"
history = true
every   = 0.01
[[probe]]
name     = "fields"
snapshot = true
every    = 0.2
[clock]
end = END
"""


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def command(self, output, end, *options, speed=0.5):
        with open(self.path("block.toml"), "w") as file:
            file.write(SCENE.replace("END", str(end)).replace("SPEED", str(speed)))
        return [PROGRAM, self.path("block.toml"), "--output", self.path(output), *options]

    def run_within(self, command, most_bytes=None):
        """No file may grow beyond most_bytes, as if the disk were full; SIGXFSZ must be ignored for a write to fail instead."""

        def limit():
            if most_bytes:
                resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

        done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, timeout=600, preexec_fn=limit, restore_signals=False)
        return done.returncode, done.stdout + done.stderr

    def test_a_full_disk_is_no_bad_input_and_never_passes_unseen(self):
        code, text = self.run_within(self.command("whole", 1.0))
        self.assertEqual(code, 0, text)
        size = os.path.getsize(self.path("whole", "mpm_pf.h5"))
        # The head and some rows fit; all but the last bytes do.
        for part in (0.3, 0.6, 0.9, 0.99):
            output = f"full{part}"
            code, text = self.run_within(self.command(output, 1.0), int(part * size))
            self.assertEqual(code, 6, f"{part}: {text}")
            self.assertRegex(text, "stopped after step [0-9]+ at time ", part)
            self.assertIn("repeat with", text)
            self.assertFalse(os.path.exists(self.path(output, "mpm_pf.h5")), "an unfinished record has the final name")
            again = "--resume" if os.path.exists(self.path(output, "mpm_pf.checkpoint.h5")) else "--force"
            code, text = self.run_within(self.command(output, 1.0, again))
            self.assertEqual(code, 0, f"{part}: {text}")
            with h5py.File(self.path(output, "mpm_pf.h5")) as file:
                self.assertEqual(len(file["tables/energy/time"]), 101)

    def test_trouble_under_way_is_no_bad_input(self):
        # Its checkpoint cannot be written: a folder stands there.
        os.makedirs(self.path("stuck", "mpm_pf.checkpoint.h5.part"))
        process = subprocess.Popen(self.command("stuck", 2000.0, speed=1e-5), env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not os.path.exists(self.path("stuck", "mpm_pf.h5.part")):
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        text = process.communicate(timeout=600)[1]
        self.assertEqual(process.returncode, 6, text)
        self.assertIn("stopped after step", text)
        self.assertIn("repeat with", text)

    def test_a_record_is_written_by_one_program_at_a_time(self):
        first = subprocess.Popen(self.command("race", 200.0, speed=1e-5), env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while first.poll() is None and not os.path.exists(self.path("race", "mpm_pf.h5.part")):
            time.sleep(0.01)
        second = self.command("race", 200.0, "--force", "--set", "solid.young_modulus=2e6", speed=1e-5)
        code, text = self.run_within(second)
        self.assertIsNone(first.poll(), "the first run was over before the second began")
        self.assertEqual(code, 2, text)
        self.assertIn(f"in use by process {first.pid}", text)
        first.send_signal(signal.SIGTERM)
        self.assertEqual(first.wait(timeout=600), 130)
        with h5py.File(self.path("race", "mpm_pf.h5.part")) as file:
            self.assertNotIn("2e6", file["provenance"].attrs["command"])
        self.assertFalse(os.path.exists(self.path("race", "mpm_pf.h5.lock")))

    def test_threads_sleep_at_barriers_unless_the_caller_wants_otherwise(self):
        for chosen, expected in ((None, b"passive"), ("active", b"active")):
            environment = {name: value for name, value in ENVIRONMENT.items() if name != "OMP_WAIT_POLICY"} | ({"OMP_WAIT_POLICY": chosen} if chosen else {})
            command = self.command(f"threads {chosen}", 200.0, "--threads", "2", speed=1e-5)
            process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                while process.poll() is None and not os.path.exists(self.path(f"threads {chosen}", "mpm_pf.h5.part")):
                    time.sleep(0.01)
                with open(f"/proc/{process.pid}/environ", "rb") as file:
                    found = file.read().split(b"\0")
                with open(f"/proc/{process.pid}/cmdline", "rb") as file:
                    self.assertEqual(file.read().decode().split("\0")[:-1], command)
            finally:
                process.kill()
                process.wait()
            self.assertIn(b"OMP_WAIT_POLICY=" + expected, found)

    def test_a_plan_in_trouble_ends_with_three(self):
        code, text = self.run_within(self.command("plan", 1.0, "--plan", speed=1e7))
        self.assertEqual(code, 3, text)
        self.assertIn("repeat with", text)

    def test_a_plan_stays_within_the_clock(self):
        # Beyond the end the support has no displacement; the run is shorter than one step of the solid.
        command = self.command("plan", 1e-3, "--plan", "--set", "probe.energy.every=1e-3", "--set", "probe.fields.every=1e-3", speed=0)
        with open(self.path("block.toml"), "a") as file:
            file.write('[[support]]\non = "bottom"\ndisplacement = ["0.001*(1 - sqrt(1 - 1000*t))", "0"]\n')
        code, text = self.run_within(command)
        self.assertEqual(code, 0, text)
        self.assertIn("forecast cpu_s=", text)

    def test_a_folder_that_cannot_be_made_is_bad_input(self):
        with open(self.path("taken"), "w") as file:
            file.write("no folder")
        code, text = self.run_within(self.command("taken", 1.0))
        self.assertEqual(code, 2, text)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
