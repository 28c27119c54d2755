"""Counts are stored with their tool chain and compared on no other; a run without a count is told of. Nothing is counted here."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import instructions

HERE = {"compiler": "GNU 12", "flags": "-O3", "eigen": "3.4.0", "libc": "glibc 2.36", "valgrind": "valgrind-3.19.0"}
OTHER = {**HERE, "compiler": "GNU 13"}


class Accepting(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.file = Path(scratch.name) / "runs.json"

    def call(self, chain, *arguments):
        """Exit code, what was said, and the file afterwards, where each run takes 7 instructions."""
        runs = [{"name": name, "scene": "s.toml", "set": [], "instructions": count} for name, count in (("a", 5), ("b", None))]
        self.file.write_text(json.dumps({"tool_chain": chain, "runs": runs}))
        with (
            mock.patch.multiple(instructions, RUNS=self.file, tool_chain=lambda _: HERE, counted=lambda _: 7),
            contextlib.redirect_stdout(io.StringIO()) as said,
            contextlib.redirect_stderr(said),
        ):
            code = instructions.main(list(arguments))
        return code, said.getvalue(), json.loads(self.file.read_text())

    def test_a_run_without_a_count_is_told_of(self):
        said = instructions.not_accepted([{"name": "a", "instructions": 5}, {"name": "b", "instructions": None}, {"name": "c"}])
        self.assertEqual([line.split(":")[0] for line in said], ["b", "c"])
        self.assertIn("not accepted yet", said[0])

    def test_a_tool_chain_is_told_apart_by_each_of_its_parts(self):
        self.assertEqual(instructions.differences(HERE, HERE), [])
        for part in HERE:
            self.assertEqual(len(instructions.differences({**HERE, part: "another"}, HERE)), 1)
        self.assertEqual(len(instructions.differences(None, HERE)), len(HERE))

    def test_looking_changes_nothing(self):
        code, said, kept = self.call(HERE)
        self.assertEqual(code, 0)
        self.assertIn("+40.00 %", said)
        self.assertEqual([run["instructions"] for run in kept["runs"]], [5, None])

    def test_some_are_accepted_on_the_same_tool_chain_only(self):
        self.assertEqual([run["instructions"] for run in self.call(HERE, "--accept", "b")[2]["runs"]], [5, 7])
        code, said, kept = self.call(OTHER, "--accept", "b")
        self.assertEqual(code, 2)
        self.assertIn("compiler: counts are of 'GNU 13', here is 'GNU 12'", said)
        self.assertEqual([run["instructions"] for run in kept["runs"]], [5, None])

    def test_all_are_accepted_with_their_tool_chain(self):
        code, _, kept = self.call(OTHER, "--accept")
        self.assertEqual((code, kept["tool_chain"]), (0, HERE))
        self.assertEqual([run["instructions"] for run in kept["runs"]], [7, 7])

    def test_an_unknown_name_is_refused(self):
        self.assertEqual(self.call(HERE, "--accept", "nobody")[0], 2)


class Scenes(unittest.TestCase):
    def test_of_all_runs_are_there(self):
        runs = json.loads(instructions.RUNS.read_text())["runs"]
        self.assertEqual([run["scene"] for run in runs if not (instructions.ROOT / "benchmarks" / run["scene"]).is_file()], [])
        self.assertEqual(len({run["name"] for run in runs}), len(runs))


if __name__ == "__main__":
    unittest.main()
