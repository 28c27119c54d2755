"""Every header opens with a paragraph that says what it is, and has its include guard; nothing in the sources is
marked as left to do."""

import re

import tree

LEFTOVERS = re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X)\b")


def offenders_in(path):
    source = tree.read(path)
    if path.suffix == ".h":
        if not re.match(r"\s*//\s*\S+(\s+\S+){3}|\s*/\*", source):
            yield f"{path}:1: opens without a comment that says what it is"
        if "#pragma once" not in source:
            yield f"{path}: has no #pragma once"
    if path.suffix == ".py" and not re.match(r'(#!.*\n)?\s*(r?"""|r?\'\'\')', source):
        yield f"{path}:1: opens without a docstring"
    for number, line in enumerate(source.split("\n"), 1):
        if LEFTOVERS.search(line):
            yield f"{path}:{number}: left undone by its own words"


if __name__ == "__main__":
    tree.finish("headers", [o for path in tree.sources() for o in offenders_in(path)])
