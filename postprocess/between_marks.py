"""Puts text that a program made between two marks of a text file, `<!-- NAME: begin -->` and `<!-- NAME: end -->`."""

import re
import sys


def write_between_marks(path, name, text):
    """Replaces what stands between the marks called `name`; ends the program if the file has none."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    old = path.read_text()
    if begin not in old or end not in old:
        sys.exit(f"{path} has no lines {begin} and {end}")
    path.write_text(re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: f"{begin}\n{text}{end}", old, count=1, flags=re.S))
