"""The programs that read what `verify` wrote say what is not there, in a sentence and with exit code 2 or 4: no empty table, no traceback."""

import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import error_map
import numpy as np
import synthetic

POSTPROCESS = pathlib.Path(__file__).resolve().parents[2] / "postprocess"
CHECK = {"name": "tip", "value": 0.5, "limit": [0, 1], "norm": "max", "status": "pass"}


def program(name, *arguments):
    """Exit code, stdout and stderr."""
    command = [sys.executable, "-B", POSTPROCESS / name, *arguments]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    return done.returncode, done.stdout, done.stderr


class Folders(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, path, content):
        (self.folder / path).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / path).write_text(content if isinstance(content, str) else json.dumps(content))


class Programs(Folders):
    def refused(self, code, words, name, *arguments):
        """The program ends with this code, prints no result and says these words on one line of stderr."""
        ended, printed, said = program(name, *arguments)
        self.assertEqual((ended, printed), (code, ""), said)
        self.assertIn(words, said)
        self.assertEqual(said.count("\n"), 1, said)

    def test_know_a_folder_that_is_not_there(self):
        nowhere, picture = self.folder / "nowhere", self.folder / "a.svg"
        for call in (("table.py", nowhere), ("report.py", nowhere), ("report_modules.py", nowhere)):
            self.refused(2, "nowhere is no folder", *call)
        self.refused(2, "nowhere is no folder", "report_trade.py", nowhere, "a", picture)
        self.refused(2, "nowhere is no folder", "report_extremes.py", nowhere, "a", "1", picture)

    def test_of_the_table_know_what_was_judged(self):
        self.refused(4, "no campaign was run there", "table.py", self.folder)
        self.write("bar/verdict.json", {"checks": [CHECK]})
        self.assertIn("| bar | tip | 0.5 | 1 | - | pass |", program("table.py", self.folder)[1])
        self.refused(2, "bar/verdict.json", "table.py", self.folder, "bar", "disc")
        self.write("bar/verdict.json", "{half a fi")
        self.refused(2, "cannot be read", "table.py", self.folder)

    def test_of_the_table_refresh_the_rows_that_a_page_has_chosen(self):
        self.write("bar/verdict.json", {"checks": [CHECK, {**CHECK, "name": "middle"}]})
        head = "Words.\n\n| case | check | value | limit | unit | |\n|---|---|---|---|---|---|\n"
        other = "\n| bar | tip | of another table |\n"
        self.write("page.md", head + "| bar | tip | 0.7 | 1 | - | **fail** |\n" + other)
        page = self.folder / "page.md"
        self.assertEqual(program("table.py", self.folder, "--refresh", page), (0, "", ""))
        self.assertEqual(page.read_text(), head + "| bar | tip | 0.5 | 1 | - | pass |\n" + other)
        self.write("page.md", head + "| bar | end | 0.7 | 1 | - | pass |\n")
        self.refused(2, 'no check "end" of bar', "table.py", self.folder, "--refresh", page)
        self.assertIn("| 0.7 |", page.read_text())
        self.refused(2, "none.md cannot be read", "table.py", self.folder, "--refresh", self.folder / "none.md")

    def test_of_single_pictures_know_what_was_measured(self):
        picture = self.folder / "a.svg"
        self.write("tradeoff/bar.json", {"measures": []})
        self.refused(2, "bar.json", "report_trade.py", self.folder, "disc", picture)
        self.refused(2, "no measure", "report_trade.py", self.folder, "bar", picture)
        self.write("stability/bar.json", {"maps": []})
        self.refused(2, "bar.json", "report_extremes.py", self.folder, "disc", "1", picture)
        for number in ("1", "0", "first"):
            self.refused(2, f"no map {number}", "report_extremes.py", self.folder, "bar", number, picture)
        self.assertFalse(picture.exists())


class ErrorMaps(Folders):
    CASE = {"case": "bar", "suite": "full", "runs": [{"name": s, "solver": s, "scene": "scene.toml", "status": "complete"} for s in ("mpm_pf", "fe_reference")]}

    def record(self, solver, stresses):
        """Snapshots of a square with one stress at each time: {time: stress}."""
        x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 9)))
        with synthetic.Invented(self.folder, "bar", solver, "") as out:
            for time, stress in stresses.items():
                out.points("fields", time, np.column_stack([x, y]), von_mises=np.full(len(x), stress))

    def maps(self):
        with contextlib.redirect_stderr(io.StringIO()) as said:
            return error_map.of_case(self.folder, self.CASE), said.getvalue()

    def test_subtract_fields_of_one_time(self):
        self.record("mpm_pf", {0.0: 0.0, 1.0: 5.0, 2.0: 9.0})
        self.record("fe_reference", {0.0: 0.0, 1.0005: 5.0})  # ended early: its last is not that of the other
        (drawn,), said = self.maps()
        self.assertIn("t = 1,", drawn["title"])
        self.assertIn("rms 0,", drawn["title"])
        self.assertEqual(said, "")

    def test_are_not_drawn_where_no_time_is_the_same(self):
        self.record("mpm_pf", {0.0: 0.0, 2.0: 9.0})
        self.record("fe_reference", {0.0: 0.0, 1.0: 5.0})
        drawn, said = self.maps()
        self.assertEqual(drawn, [])
        self.assertIn("mpm_pf at t = 2 and fe_reference at t = 1", said)


if __name__ == "__main__":
    unittest.main()
