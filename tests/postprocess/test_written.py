"""The programs that read what `verify` wrote say what is not there, in a sentence and with exit code 2 or 4: no empty table, no traceback."""

import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

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
        more = "| case | check | taken | against | value | |\n|---|---|---|---|---|---|\n| bar | {} | {} | 0.5 | pass |\n"
        self.write("bar/verdict.json", {"checks": [{**CHECK, "taken": 1.23456, "reference": 2.0}]})
        self.write("page.md", more.format("tip", "0 | 0"))
        self.assertEqual(program("table.py", self.folder, "--refresh", page), (0, "", ""))
        self.assertEqual(page.read_text(), more.format("tip", "1.235 | 2"))
        self.write("page.md", head + "| bar | end | 0.7 | 1 | - | pass |\n")
        self.refused(2, 'no check "end" of bar', "table.py", self.folder, "--refresh", page)
        self.assertIn("| 0.7 |", page.read_text())
        self.refused(2, "none.md cannot be read", "table.py", self.folder, "--refresh", self.folder / "none.md")

    def test_of_the_table_tell_suites_apart_and_write_what_a_campaign_came_to(self):
        made = {"commit": "0123456789", "dirty": "no"}
        run = {"name": "mpm_pf", "solver": "mpm_pf", "scene": "scene.toml", "set": ["mpm.transfer='flip'"], "cpu_s": 12.5, "wall_s": 7.0, "peak_rss_bytes": 3e7}
        runs = [{**run, "provenance": made, "reused": False}, {**run, "name": "refused", "set": [], "cpu_s": 0.5}]
        case = {"case": "bar", "suite": "full", "checks": [CHECK, {**CHECK, "name": "forecast, mpm_pf", "status": "fail"}], "runs": runs}
        self.write("results/campaign.json", {"suite": "full", "cases": [case], "wall_s": 9.0, "cores": 2})
        self.write("results/bar/verdict.json", case)
        head = "| case | check | value | limit | unit | |\n|---|---|---|---|---|---|\n| bar | tip | 0.7 | 1 | - | pass |\n\n"
        marks = "".join(f"<!-- {name}: begin -->\n<!-- {name}: end -->\n" for name in ("campaign full", "campaign quick", "runs full"))
        self.write("bar/page.md", f"<!-- checks: quick -->\n{head}<!-- checks: full -->\n{head}{marks}")
        self.assertEqual(program("table.py", self.folder / "results", "--refresh", self.folder / "bar/page.md"), (0, "", ""))
        page = (self.folder / "bar/page.md").read_text()
        self.assertEqual((page.count("tip | 0.7 |"), page.count("tip | 0.5 |")), (1, 1))
        self.assertLess(page.index("tip | 0.7 |"), page.index("tip | 0.5 |"))
        self.assertIn("commit 0123456: 1 cases, 2 runs, 13 s of CPU in 9 s of wall on 2 cores;\n", page)
        self.assertIn("2 checks (1 of them forecasts of runs), 1 passed, not these: bar, forecast, mpm_pf (fail).\n", page)
        self.assertIn('| mpm_pf | mpm_pf | scene.toml `--set "mpm.transfer=\'flip\'"` | – | – | 12.5 | 7 | 30 |\n| refused |', page)
        self.assertIn("<!-- campaign quick: begin -->\n<!-- campaign quick: end -->", page)
        runs[0]["reused"] = True  # then nothing says what the campaign takes of wall time
        self.write("results/campaign.json", {"suite": "full", "cases": [case], "wall_s": 9.0, "cores": 2})
        program("table.py", self.folder / "results", "--refresh", self.folder / "bar/page.md")
        self.assertIn("13 s of CPU;\n", (self.folder / "bar/page.md").read_text())

    def test_of_the_table_of_modules_say_of_what_programs_it_is(self):
        sums = {"cpu_s": 2.0, "solver_bytes": 1e6, "resident_bytes": 2e7, "measured_solver_bytes": 1e6, "time": "met", "memory": "met", "resident": "met"}
        run = {"name": "mpm_pf", "solver": "mpm_pf", "cpu_s": 2.5, "peak_rss_bytes": 3e7, "forecast": {"on": "solid (line 3)", "off": "", **sums}}
        runs = [{**run, "provenance": {"commit": "0123456789", "dirty": "yes"}}]
        self.write("campaign.json", {"suite": "quick", "cases": [{"case": "bar", "runs": runs}]})
        code, printed, _ = program("report_modules.py", self.folder)
        self.assertEqual(code, 0)
        self.assertTrue(printed.startswith("From 1 cases of the quick suite, commit 0123456 with changes:\n\n| case |"), printed)
        self.assertIn("| bar | mpm_pf | solid | 1 / 1 ✓ | 20 / 30 ✓ | 2 / 2.5 ✓ |", printed)

    def test_of_tables_know_a_file_without_marks_and_one_that_is_broken(self):
        row = {"solver": "mpm_pf", "status": "complete", "cpu_s": 1.0, "peak_rss_bytes": 3e7, "settings": {"accuracy": "draft"}, "errors": {"tip": 0.1}}
        trade = {"case": "bar", "measures": ["tip"], "rows": [row], "reference": {"uncertainty": {}}, "provenance": {}}
        self.write("tradeoff/bar.json", trade)
        begin, end = "<!-- presets: begin -->", "<!-- presets: end -->"
        for text in (None, "no marks", f"{end}\n{begin}\n"):
            if text:
                self.write("page.md", text)
            code, printed, said = program("presets.py", self.folder, self.folder / "page.md")
            self.assertEqual((code, printed), (2, ""), said)
            self.assertIn(begin, said.splitlines()[-1])
        self.write("page.md", f"{begin}\nold\n{end}\n")
        self.assertEqual(program("presets.py", self.folder, self.folder / "page.md")[0], 0)
        self.assertIn("| bar | tip |", (self.folder / "page.md").read_text())
        self.write("tradeoff/bar.json", json.dumps(trade)[:40])
        self.refused(2, "bar.json cannot be read", "presets.py", self.folder)
        self.write("tradeoff/bar.json", {"case": "bar"})
        self.refused(2, "bar.json has no measures", "presets.py", self.folder)

    def test_of_the_report_know_another_shape_and_a_folder_that_takes_nothing(self):
        self.write("campaign.json", [1, 2])
        self.refused(2, "campaign.json has no suite", "report.py", self.folder)
        (self.folder / "campaign.json").unlink()
        (self.folder / "index.html.part").mkdir()  # stands in the way, for whom no folder is read-only, too
        self.refused(2, "index.html cannot be written", "report.py", self.folder)

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
        self.assertIn("t = 1 s,", drawn["title"])
        self.assertIn("rms 0, largest 0 Pa", drawn["title"])
        self.assertEqual(said, "")

    def test_are_as_coarse_as_the_coarser_mesh(self):
        # Cell means of x on 4 x 4 cells against points that lie on x itself: 36 samples a cell must not hide how large the cells are.
        x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, 81), np.linspace(0, 1, 81)))
        corner = np.arange(25).reshape(5, 5)
        quads = np.stack([corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]], axis=-1).reshape(-1, 4)
        vertex = np.stack(np.meshgrid(np.linspace(0, 1, 5), np.linspace(0, 1, 5)), axis=-1).reshape(-1, 2)
        sizes = []
        original = error_map.raster

        def seen(places, values, box, cells):
            sizes.append(cells)
            return original(places, values, box, cells)

        with synthetic.Invented(self.folder, "bar", "mpm_pf", '[units]\nsystem = "W0-tau0-sigmaY"\n') as out:
            out.points("fields", 1.0, np.column_stack([x, y]), von_mises=x)
        with synthetic.Invented(self.folder, "bar", "fe_reference", "") as out:
            out.cells("fields", 1.0, vertex, quads, von_mises=vertex[quads].mean(axis=1)[:, 0])
        with mock.patch.object(error_map, "raster", seen):
            (drawn,), _ = self.maps()
        self.assertLessEqual(max(max(cells) for cells in sizes), 4)
        self.assertIn("sigma_Y)", drawn["title"])
        self.assertIn("t = 1 tau0,", drawn["title"])

    def test_are_not_drawn_where_no_time_is_the_same(self):
        self.record("mpm_pf", {0.0: 0.0, 2.0: 9.0})
        self.record("fe_reference", {0.0: 0.0, 1.0: 5.0})
        drawn, said = self.maps()
        self.assertEqual(drawn, [])
        self.assertIn("mpm_pf at t = 2 and fe_reference at t = 1", said)


if __name__ == "__main__":
    unittest.main()
