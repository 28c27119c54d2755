"""An advice, taken by its word with the real solver: the settings that `verify advise` prints are pasted into a scene, the scene is run again, and the error
that was asked for is met. The case is a small cantilever with a theory for its tip."""

import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from record import Record  # of postprocess

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("MPM_PF_BIN", ROOT / "build/release/bin"))
E, NU, P, L = 3e7, 0.3, 100.0, 8.0
# Timoshenko's beam in plane strain, unit height.
ES, NUS = E / (1 - NU**2), NU / (1 - NU)
TIP = P / (6 * ES / 12) * ((4 + 5 * NUS) * L / 4 + 2 * L**3)

TRADE = f"""
suite = "smoke"
time_limit_s = 300
[[quantity]]
name = "tip"
take = {{table = "tip", of = "displacement_y", reduce = "last"}}
against = {{number = {TIP}}}
norms = ["relative"]
[[family]]
name = "cells and points"
lists = {{"domain.cells" = [[10, 3], [20, 6], [40, 12]]}}
[[family]]
name = "linear"
set = ["mpm.shape_function='linear'"]
lists = {{"domain.cells" = [[20, 6]]}}
"""


def call(*arguments):
    return subprocess.run([str(a) for a in arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)


class Advice(unittest.TestCase):
    def test_its_rerun_meets_the_error_and_its_evidence_is_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            case = Path(folder) / "cases/beam"
            case.mkdir(parents=True)
            (case / "smoke.toml").write_text(f'include = "{ROOT}/benchmarks/cantilever/smoke.toml"\n')
            (case / "expect.toml").write_text('title = "beam"\n[[run]]\nsolver = "mpm_pf"\n')
            (case / "tradeoff.toml").write_text(TRADE)
            verify = [BIN / "verify", "--cases", case.parent]
            measured = call(*verify, "tradeoff", "beam", "--output", folder + "/out")
            self.assertEqual(measured.returncode, 0, measured.stdout + measured.stderr)

            asked = 0.05
            advice = call(*verify, "advise", "beam", "--quantity", "tip", "--error", f"{asked}", "--output", folder + "/out")
            self.assertEqual(advice.returncode, 0, advice.stdout + advice.stderr)
            fragment = re.search(r"^# [^\n]*\n(.*?)^evidence", advice.stdout, re.M | re.S).group(1)
            self.assertIn("cells", fragment)

            (case / "advised.toml").write_text(f'include = "smoke.toml"\n{fragment}')
            rerun = call(BIN / "mpm_pf", case / "advised.toml", "--output", folder, "--record", "rerun")
            self.assertEqual(rerun.returncode, 0, rerun.stderr)
            tip = Record(folder + "/rerun.h5").table("tip")["displacement_y"][-1]
            self.assertLess(abs(tip / TIP - 1), asked, advice.stdout)

            # what no row has met is not promised
            never = call(*verify, "advise", "beam", "--quantity", "tip", "--error", "1e-9", "--output", folder + "/out")
            self.assertEqual(never.returncode, 1, never.stdout)


if __name__ == "__main__":
    unittest.main()
