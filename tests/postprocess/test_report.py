"""The report's words and numbers: what stands on an axis, which unit a value has, what a page holds where nothing was judged."""

import json
import pathlib
import tempfile
import unittest

import recorded_units
import report
import report_extremes
import report_modules
import report_trade
import svgplot
import table

ROW = {"family": "cells", "solver": "mpm_pf", "settings": {}, "status": "complete", "cpu_s": 1.0, "wall_s": 1.0, "peak_rss_bytes": 1e6, "repeat": "again"}
TRADE = {"case": "a", "suite": "quick", "measures": ["tip, relative"], "reference": {"text": "zero"}, "provenance": {"commit": "abc"}}
MAP = {
    "name": "map",
    "x": {"label": "step", "values": [6e12, 7e12]},
    "y": {"label": "scheme", "values": ["cip"]},
    "cells": [{"row": 0, "column": k, "x": "", "y": "", "class": c, "why": "", "repeat": "again"} for k, c in enumerate(("accurate", "diverged"))],
    "edges": [{"row": 0, "stable": 6e12, "unstable": 7e12, "edge": 6.5e12, "theory": None}],
}


class Words(unittest.TestCase):
    def test_numbers_have_no_exponent_that_digits_can_do_without(self):
        self.assertEqual([report.significant(v, 2) for v in (649.0, 1.5e8, 2.3e-13, 0.5, None)], ["649", "1.5e8", "2.3e-13", "0.5", "–"])
        self.assertEqual([report_modules.seconds(v) for v in (649.0, 8.44, 0.00312)], ["649", "8.4", "0.0031"])
        self.assertEqual([report_modules.percent(v) for v in (0.97, 0.004)], ["97 %", "< 1 %"])

    def test_what_a_run_estimated_at_contact_stands_beside_its_plan(self):
        run = {"cpu_s": 11.0, "peak_rss_bytes": 1e7, "forecast": {"cpu_s": 25.0, "solver_bytes": 2e6, "measured_solver_bytes": 2e6, "resident_bytes": 1e7, "memory": "met", "resident": "met", "time": "met"}}
        self.assertEqual(report_modules.sums_text(run)[2], "25 / 11 ✓")
        run["forecast"] |= {"at_contact_cpu_s": 23.0, "contact": "missed"}
        self.assertEqual(report_modules.sums_text(run)[2], "25 / 11 ✓; at contact 23 ✗")

    def test_axes_are_named_after_what_was_taken(self):
        names = {
            'mpm_pf: line "arm" von_mises': ("distance along the line", "von_mises"),
            'mpm_pf: table "top" "bottom" top_force_y + bottom_force_y': ("time", "top_force_y + bottom_force_y"),
            'mpm_pf: line "radius" stress_yy/sigma_y over x from 0.105 to 0.195 at t = done': ("x", "stress_yy/sigma_y"),
            'mean of mpm_pf: line "axis" u at the end': ("distance along the line", "u"),
            "something else": ("abscissa", "value"),
        }
        self.assertEqual({label: report.axis_names(label) for label in names}, names)

    def test_axes_have_the_units_of_the_record(self):
        units = recorded_units.Units(columns={"top": {"force_y": "N/m", "count": "1"}, "arm": {"von_mises": "Pa"}})
        names = {
            'mpm_pf: table "top" force_y': ("time (s)", "force_y (N/m)"),
            'mpm_pf: table "top" count over force_y at the end': ("force_y (N/m)", "count"),
            'mpm_pf: line "arm" von_mises at t = 1': ("distance along the line (m)", "von_mises (Pa)"),
            'mpm_pf: line "arm" von_mises/2 over x': ("x (m)", "von_mises/2"),
        }
        self.assertEqual({label: report.axis_names(label, units) for label in names}, names)
        square = {"label": "mpm_pf: outline", "outline": [{"x": [0, 1, 1], "y": [0, 0, 1]}]}
        self.assertIn("x (m)", report.overlay({"taken": square, "reference": square}, units))

    def test_an_interval_shows_both_its_ends(self):
        checks = ({"norm": "value", "limit": [0, 5]}, {"norm": "max", "limit": [0, 5]}, {"norm": "max", "limit": [0, 5], "order": {}}, {"norm": "max", "limit": [1, 5]})
        self.assertEqual([table.limit_text(check) for check in checks], ["0 ... 5", "5", "0 ... 5", "1 ... 5"])

    def test_a_relative_value_and_an_order_have_no_unit(self):
        checks = ({"norm": "relative", "unit": "N/m"}, {"norm": "absolute", "unit": "m", "order": {}}, {"norm": "absolute", "unit": "m"}, {"norm": "max"})
        self.assertEqual([table.unit_of(check) for check in checks], ["-", "-", "m", "-"])


class Pictures(unittest.TestCase):
    def test_the_legend_stands_above_the_frame(self):
        plot = svgplot.Plot("x", "y")
        plot.line([0, 1], [0, 1], "first")
        plot.line([0, 1], [1, 0], "second")
        drawn = plot.svg()
        frame = float(drawn.split('<rect x="62" y="')[1].split('"')[0])
        legend = [float(part.split('y="')[-1]) for part in drawn.split('" fill="currentColor">first')[0:1]]
        self.assertLess(legend[0], frame)
        self.assertEqual(drawn, plot.svg())  # drawn twice it has not grown

    def test_a_narrow_logarithmic_axis_has_two_ticks(self):
        self.assertGreaterEqual(len(svgplot.log_ticks(0.0023, 0.0047)), 2)

    def test_a_map_names_what_it_holds(self):
        drawn = report_extremes.picture(MAP)
        for words in ("accurate", "diverged", "edge of stability", "6e+12", "step →", "scheme ↓"):
            self.assertIn(words, drawn)
        for words in ("refused", "theoretical limit", "6000000000000"):
            self.assertNotIn(words, drawn)

    def test_a_cell_says_its_trouble_and_not_the_whole_log(self):
        why = "mpm_pf: bar\n  on: solid\nmpm_pf: numerical trouble in step 9: left the mesh\nThe record keeps what came before; repeat with:\n  mpm_pf"
        self.assertEqual(report_extremes.reason({"why": why}), "numerical trouble in step 9: left the mesh")
        self.assertEqual(report_extremes.reason({"why": "energy kept 0.97; "}), "energy kept 0.97")

    def test_no_plot_where_all_errors_are_zero(self):
        self.assertIn("exactly zero", report_trade.page({**TRADE, "rows": [{**ROW, "errors": {"tip, relative": 0.0}}]}))
        self.assertIn("<svg", report_trade.page({**TRADE, "rows": [{**ROW, "errors": {"tip, relative": 0.1}}]}))

    def test_a_refused_row_is_drawn_and_says_why(self):
        good = {**ROW, "errors": {"tip, relative": 0.1}}
        refused = {**ROW, "family": "no such key", "status": "bad input", "why": ["no key advection.every"], "errors": {"tip, relative": None}}
        page = report_trade.page({**TRADE, "rows": [good, refused]})
        self.assertIn("no such key: as in the scene; error no answer: bad input", page)
        self.assertIn('<td title="no key advection.every">bad input</td>', page)

    def test_an_edge_is_held_against_theory_and_its_cells_are_commands(self):
        edge = {**MAP["edges"][0], "theory": 6e12, "ratio": 1.0833}
        between = {**MAP["cells"][0], "x": "6.5e12", "class": "accurate", "repeat": "once more"}
        page = report_extremes.page({"maps": [{**MAP, "edges": [edge], "edge_bounds": [0.9, 1.05], "broken": ["row 0: too far"], "bisected": [between]}]})
        for words in ("edge over theory (0.9 – 1.05)", "1.083", "outside its bounds: row 0: too far", "<code>once more</code>"):
            self.assertIn(words, page)
        self.assertNotIn("outside", report_extremes.page({"maps": [MAP]}))


CHECK = {"name": "c", "status": "pass", "take": "t", "against": "", "norm": "value", "value": 1.0, "limit": [0, 2], "unit": "-", "source": "s", "reason": "r"}
CHECK |= {"why": "", "uncertainty": None, "uncertainty_text": "", "taken": None, "reference": None, "drift": {"status": "none", "accepted": None}}


def page_of(case):
    """The report of a campaign of this one case."""
    campaign = {"suite": "quick", "started": "", "wall_s": 1.0, "exit_code": 0, "cores": 1, "jobs": 1, "cases": [case], "provenance": {}}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "campaign.json").write_text(json.dumps(campaign))
        report.write(folder)
        return (folder / "index.html").read_text()


class Page(unittest.TestCase):
    def test_what_failed_is_named_case_by_case(self):
        checks = [{"name": name, "status": "missing"} for name in "abcde"] + [{"name": "f", "status": "pass"}]
        cases = [{"case": "bar", "checks": checks}, {"case": "disc", "checks": checks[5:]}]
        self.assertEqual(report.not_passed({"cases": cases}, 2), [("bar", "a (missing), b (missing) and 3 more")])

    def test_names_the_cases_of_earlier_campaigns(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for case in ("old", "new"):
                (folder / case).mkdir()
                (folder / case / "verdict.json").write_text(json.dumps({"case": case, "checks": [{"status": "pass"}, {"status": "fail"}]}))
            self.assertEqual(report.left_over(folder, {"cases": [{"case": "new"}]}), [("old", 1, 2)])

    def test_a_run_says_under_the_runs_whether_its_inertia_shows(self):
        run = {"name": "pressed", "status": "complete", "wall_s": 1.0, "cpu_s": 1.0, "peak_rss_bytes": 1e6, "steps": 1, "cells": 1, "points": 1, "build_type": "Release"}
        run |= {"solver": "mpm_pf", "repeat": "again", "inertia": "inertia alone takes 2 % of compression to stop an arm: not quasi-static"}
        case = {"case": "bar", "title": "", "about": "", "scene": "quick.toml", "checks": [CHECK], "runs": [run, {**run, "name": "free", "inertia": ""}]}
        page = page_of(case)
        self.assertIn("<b>pressed</b>: inertia alone takes 2 % of compression to stop an arm: not quasi-static", page)
        self.assertNotIn("<b>free</b>", page)

    def test_says_which_check_has_nothing_to_drift_from(self):
        case = {"case": "bar", "title": "", "about": "", "scene": "quick.toml", "checks": [CHECK], "runs": []}
        self.assertNotIn("no accepted value", page_of(case))
        new = {**CHECK, "drift": {"status": "no accepted value", "accepted": None}}
        self.assertIn("no accepted value", page_of({**case, "checks": [new]}))
        self.assertNotIn("no accepted value", page_of({**case, "checks": [{**new, "status": "fail"}]}))

    def test_says_nothing_of_a_verdict_where_nothing_was_judged(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "tradeoff").mkdir()
            (folder / "tradeoff" / "a.json").write_text(json.dumps({**TRADE, "rows": [{**ROW, "errors": {"tip, relative": 0.1}}]}))
            report.write(folder)
            page = (folder / "index.html").read_text()
        self.assertNotIn("all right", page)
        self.assertIn('href="#trade-a"', page)
        self.assertIn('id="trade-a"', page)


if __name__ == "__main__":
    unittest.main()
