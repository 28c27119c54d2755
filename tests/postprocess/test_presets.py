"""The table of presets: what an error is held against, and no error below the uncertainty of that."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import presets
from between_marks import tell_origin

ROW = {"solver": "mpm_pf", "status": "complete", "cpu_s": 1.0, "peak_rss_bytes": 3e7}


def table(errors, reference, solver="mpm_pf"):
    rows = [{**ROW, "solver": solver, "settings": {"accuracy": f'"{name}"'}, "errors": {"tip": error}} for name, error in zip(presets.LEVELS, errors)]
    trade = {"case": "beam", "measures": ["tip"], "rows": rows, "reference": reference, "provenance": {"commit": "abc", "start": "2026-01-02T03:04:05Z"}}
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "tradeoff").mkdir()
        (Path(folder) / "tradeoff/beam.json").write_text(json.dumps(trade))
        return presets.table(Path(folder))


class Presets(unittest.TestCase):
    def test_an_error_below_the_uncertainty_is_not_shown_as_one(self):
        text = table([0.09, 0.04, 0.003], {"uncertainty": {"tip": 0.034}, "against": {"tip": "finite elements"}})
        self.assertIn("| finite elements (± 3.4 %) |", text)
        self.assertIn("9 %, 1 s", text)
        self.assertIn("< 3.4 %, 1 s", text)
        self.assertNotIn("0.3 %", text)

    def test_a_lone_reference_is_marked_and_a_theory_is_not(self):
        lone = table([0.1, 0.1, None], {"uncertainty": {"tip": None}, "against": {"tip": "mpm_pf, finer"}})
        self.assertIn("| mpm_pf, finer (?) |", lone)
        self.assertIn("not measured, 1 s", lone)
        self.assertIn("| theory |", table([0.1, 0.1, 0.1], {"uncertainty": {}, "against": {"tip": "theory"}}))


class Origin(unittest.TestCase):
    def test_a_result_of_another_commit_is_warned_of(self):
        def said(present):
            with contextlib.redirect_stderr(io.StringIO()) as text:
                tell_origin({"commit": "abc", "start": "2026-01-02T03:04:05Z"}, present)
            return text.getvalue()

        self.assertIn("measured 2026-01-02T03:04:05Z, commit abc", said("abc"))
        self.assertNotIn("warning", said("abc"))
        self.assertIn("warning: the repository is at commit def", said("def"))


if __name__ == "__main__":
    unittest.main()
