"""Puts text that a program made between two marks of a text file, `<!-- NAME: begin -->` and `<!-- NAME: end -->`, and tells of what program it is."""

import re
import subprocess
import sys
from pathlib import Path

from written import Unusable, write_whole


def write_between_marks(path, name, text):
    """Replaces what stands between the marks called `name`; raises Unusable if the file cannot be read or written or does not have them."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    try:
        old = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        raise Unusable(f"{path} cannot be read ({error}); name a text file with the lines {begin} and {end}") from None
    new, replaced = re.subn(re.escape(begin) + ".*?" + re.escape(end), lambda _: f"{begin}\n{text}{end}", old, count=1, flags=re.S)
    if not replaced:
        raise Unusable(f"{path} lacks the lines {begin} and, below it, {end}, between which the table goes; write them into it")
    write_whole(path, new)


def tell_origin(made, present=None):
    """Says on stderr when and with which commit (`made`: provenance of a result) something was measured, and warns if the repository is at
    another (`present`; default: what git says of this file's)."""
    if present is None:
        command = ["git", "-C", str(Path(__file__).parent), "rev-parse", "HEAD"]
        try:
            present = subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
        except OSError:
            present = ""
    commit = made.get("commit", "unknown")
    print(f"measured {made.get('start', 'at an unknown time')}, commit {commit}", file=sys.stderr)
    if present and commit != present:
        print(f"warning: the repository is at commit {present}; measure again to be sure", file=sys.stderr)


def table_program(arguments, usage, name, table, missing):
    """main() of a program that is given the folder of a campaign and perhaps a text file: prints table(folder), or writes it between the
    file's marks called `name`. Without a table it says what is `missing`. Returns the exit code."""
    if len(arguments) not in (1, 2):
        print(usage)
        return 2
    text = table(Path(arguments[0]))
    if not text:
        print(missing, file=sys.stderr)
        return 4
    if len(arguments) == 2:
        write_between_marks(Path(arguments[1]), name, text)
    else:
        print(text, end="")
    return 0
