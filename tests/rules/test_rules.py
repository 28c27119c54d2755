"""The rule checks can fail: each is shown an offender of its kind."""

import os
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_equations
import check_headers
import check_includes
import check_paths
import check_sizes
import tree


def offenders(check, path, text):
    with mock.patch.object(tree, "read", return_value=text):
        return list(check.offenders_in(Path(path)))


class Includes(unittest.TestCase):
    def test_solid_and_melt_have_no_door(self):
        self.assertTrue(offenders(check_includes, "mpm_pf/solid/a.cc", '#include "melt/growth.h"\n'))
        self.assertTrue(offenders(check_includes, "mpm_pf/melt/a.cc", '#include "solid/points.h"\n'))
        self.assertFalse(offenders(check_includes, "mpm_pf/solid/a.cc", '#include "medium/mesh.h"\n'))

    def test_the_reference_shares_no_physics(self):
        self.assertTrue(offenders(check_includes, "fe_reference/a.cc", '#include "solid/elastic.h"\n'))
        self.assertFalse(offenders(check_includes, "fe_reference/a.cc", "#include <deal.II/base/point.h>\n"))
        self.assertTrue(offenders(check_includes, "mpm_pf/world.cc", "#include <deal.II/base/point.h>\n"))


class Sizes(unittest.TestCase):
    def test_long_function_in_a_namespace(self):
        body = "\n".join("    a += 1;" for _ in range(70))
        source = "namespace n\n{\n  void f(const int a)\n  {\n" + body + "\n  }\n}\n"
        found = offenders(check_sizes, "a.cc", source)
        self.assertEqual(len(found), 1)
        self.assertIn("f has 72 lines", found[0])

    def test_many_short_functions_are_no_long_one(self):
        source = "namespace n\n{\n" + "  void f() {\n    g();\n  }\n" * 40 + "}\n"
        self.assertFalse(offenders(check_sizes, "a.cc", source))

    def test_long_files_and_python_functions(self):
        self.assertTrue(offenders(check_sizes, "a.cc", "\n" * 301))
        self.assertTrue(offenders(check_sizes, "a.py", "def f():\n" + "    pass\n" * 61))

    def test_braces_in_text_do_not_count(self):
        source = 'void f()\n{\n  g("{", \'{\'); // {\n}\nvoid h()\n{\n' + "  g();\n" * 70 + "}\n"
        found = offenders(check_sizes, "a.cc", source)
        self.assertEqual(len(found), 1)
        self.assertIn("h has 72 lines", found[0])


class PathsAndHeaders(unittest.TestCase):
    def test_paths_of_one_machine(self):
        self.assertTrue(offenders(check_paths, "a.md", "see /ho" + "me/somebody/data"))
        self.assertFalse(offenders(check_paths, "a.md", "see /usr/bin/python3"))

    def test_headers_open_with_words(self):
        self.assertTrue(offenders(check_headers, "a.h", "#pragma once\n"))
        self.assertFalse(offenders(check_headers, "a.h", "// What this file is about.\n#pragma once\n"))


class Equations(unittest.TestCase):
    def cited(self, text):
        with mock.patch.object(tree, "read", return_value=text):
            return [int(equation) for equation, _ in check_equations.citations_in(Path("mpm_pf/solid/a.cc"))]

    def test_count_where_they_are_computed(self):
        self.assertEqual(self.cited("  v += dt * force / mass; // Eq. (4)\n"), [4])
        self.assertEqual(self.cited("  // Eqs. (5) and (6), closed form\n  s *= 1. - g / q;\n"), [5, 6])
        self.assertEqual(self.cited("/// Eq. (3), spin\nstruct Spin\n{\n  double at() { return a * x; }\n};\n"), [3])

    def test_in_a_banner_or_beside_what_computes_nothing_do_not_count(self):
        for text in (
            "// The solid: Eqs. (4)-(6), a - b.\n#pragma once\n\nint i = a * b;\n",
            "/// The step of Eq. (4).\nvoid step(World &w, double *dt);\n",
            "  std::size_t active = 0; // these move by Eq. (4)\n",
            "  move(w, dt); // Eqs. (4)-(6), as a - b\n",
            '  say("a - b, Eq. (6)"); // no equation\n',
            '  say("a - b"); // Eq. (6)\n',
        ):
            self.assertEqual(self.cited(text), [], text)


class Skipping(unittest.TestCase):
    def test_is_a_failure_where_nothing_may_be_skipped(self):
        def code(script, **more):
            command = [str(Path(__file__).resolve().parents[1] / "python_test"), "-c", script]
            environment = {name: value for name, value in os.environ.items() if name != "CI"} | more
            return subprocess.run(command, env=environment, capture_output=True, stdin=subprocess.DEVNULL, check=False).returncode

        skip = "import sys; sys.exit(77)"
        self.assertEqual([code(skip), code(skip, CI="false"), code(skip, CI="true")], [77, 77, 1])
        self.assertEqual([code("pass", CI="true"), code("import sys; sys.exit(3)", CI="true")], [0, 3])


if __name__ == "__main__":
    unittest.main()
