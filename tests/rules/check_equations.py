"""Each of the paper's Eqs. (1) to (6) is cited, as `Eq. (n)` in a comment, on a line of mpm_pf that computes it.

The comment stands behind code that does arithmetic, or above a paragraph of code that does. What opens a file or
describes a declaration does not count, nor do scene and record, which compute nothing.
"""

import itertools
import re

import tree

TEXT = re.compile(r'"(?:\\.|[^"\\])*"')
CITATION = re.compile(r"Eqs?\. \((\d)\)(?:\s*(?:-|to|and)\s*\((\d)\))?")
ARITHMETIC = re.compile(r"[\w)\]}] [-+*/]=? [-\w({]")  # binary, as clang-format spaces it; not `Type *name`


def computes(code):
    return ARITHMETIC.search(code) is not None


def citations_in(path):
    """(number of the equation, line) of each citation that stands where something is computed."""
    lines = [TEXT.sub('""', line).partition("//") for line in tree.read(path).split("\n")]
    for number, (code, _, comment) in enumerate(lines, 1):
        if not code.strip():  # the paragraph that the comment stands above
            code = "\n".join(below for below, *_ in itertools.takewhile(any, lines[number:]))
        if computes(code):
            for first, last in CITATION.findall(comment):
                yield from ((equation, number) for equation in range(int(first), int(last or first) + 1))


def cited():
    """Numbers of the equations that mpm_pf computes and cites there."""
    rooms = (p for p in tree.sources() if p.parts[0] == "mpm_pf" and p.parts[1] not in ("scene", "record"))
    return {equation for path in rooms for equation, _ in citations_in(path)}


if __name__ == "__main__":
    found = cited()
    tree.finish("equations", [f"no line of mpm_pf that computes Eq. ({n}) cites it" for n in range(1, 7) if n not in found])
