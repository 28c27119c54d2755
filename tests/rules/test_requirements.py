"""What the build cannot do without is asked for while it is configured, and its absence is told in a sentence with a remedy."""

import subprocess
import tempfile
import unittest
from pathlib import Path

REQUIREMENTS = Path(__file__).resolve().parents[2] / "cmake/requirements.cmake"


def configured(then="", **changed):
    """Exit code and output of cmake/requirements.cmake, with `then` behind it."""
    values = {"CMAKE_SYSTEM_NAME": "Linux", "CMAKE_CXX_COMPILER_ID": "GNU", "CMAKE_CXX_COMPILER_VERSION": "12.2.0", "MPM_PF_GLIBC": "1"} | changed
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "script.cmake"
        script.write_text(f'include("{REQUIREMENTS}")\n{then}\nmessage(STATUS "known compiler: ${{MPM_PF_KNOWN_COMPILER}}")\n')
        command = ["cmake", *(f"-D{name}={value}" for name, value in values.items()), "-P", str(script)]
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    return done.returncode, " ".join((done.stdout + done.stderr).split())


class Requirements(unittest.TestCase):
    def test_are_met_here_and_warnings_are_errors_with_the_known_compiler_only(self):
        code, said = configured()
        self.assertEqual((code, "known compiler: ON" in said), (0, True), said)
        for other in ({"CMAKE_CXX_COMPILER_VERSION": "14.1"}, {"CMAKE_CXX_COMPILER_ID": "Clang"}):
            code, said = configured(**other)
            self.assertEqual((code, "known compiler: OFF" in said), (0, True), said)

    def test_name_the_system_and_the_compiler_that_will_not_do(self):
        for changed, words in (
            ({"CMAKE_SYSTEM_NAME": "Darwin"}, "not for Darwin"),
            ({"CMAKE_CXX_COMPILER_VERSION": "11.4"}, "GCC 11.4 is too old"),
        ):
            code, said = configured(**changed)
            self.assertEqual((code, words in said), (1, True), said)

    def test_warn_of_what_nobody_has_tried(self):
        for changed, words in (({"MPM_PF_GLIBC": ""}, "not glibc"), ({"CMAKE_CXX_COMPILER_ID": "Intel"}, "nobody has tried Intel")):
            code, said = configured(**changed)
            self.assertEqual((code, words in said), (0, True), said)

    def test_name_the_package_of_what_is_missing(self):
        code, said = configured("require_header(NOTHING no_such_header.hpp libnothing-dev)")
        self.assertEqual((code, "install libnothing-dev" in said), (1, True), said)
        code, said = configured("require_library(NOTHING no_such_library libnothing-dev)")
        self.assertEqual((code, "install libnothing-dev" in said), (1, True), said)

    def test_of_our_own_rooms_are_asked_for(self):
        root = REQUIREMENTS.parents[1]
        for room, header in (("mpm_pf/scene", "toml.hpp"), ("mpm_pf/scene", "muParser.h"), ("mpm_pf/record", "CLI/CLI.hpp"), ("benchmarks/verify", "toml.hpp")):
            self.assertIn(f" {header} lib", (root / room / "CMakeLists.txt").read_text(), room)


if __name__ == "__main__":
    unittest.main()
