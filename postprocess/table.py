#!/usr/bin/python3
"""The result table of a campaign as Markdown, for the README.

    postprocess/table.py RESULTS_DIR [CASE ...]     prints one row a check: case, check, value, limit, status
"""
import json
import sys
from pathlib import Path


def number(value):
    return "-" if value is None else f"{value:.3g}"


def limit_text(limit):
    if isinstance(limit, list):
        return f"{number(limit[1])}" if limit[0] == 0 else f"{number(limit[0])} ... {number(limit[1])}"
    return number(limit)


def unit_of(check):
    """The unit of a check's value; an order of convergence and a relative norm have none, whatever they are taken of."""
    unit = check.get("unit") or "-"
    return "-" if "order" in check or check["norm"].startswith("relative") else unit


def rows(folder):
    verdict = json.loads((folder / "verdict.json").read_text())
    for check in verdict["checks"]:
        yield (folder.name, check["name"], number(check["value"]), limit_text(check["limit"]),
               unit_of(check), check["status"])


def main(arguments):
    if not arguments:
        print(__doc__)
        return 2
    results = Path(arguments[0])
    cases = arguments[1:] or sorted(p.parent.name for p in results.glob("*/verdict.json"))
    print("| case | check | value | limit | unit | |")
    print("|---|---|---|---|---|---|")
    for case in cases:
        for row in rows(results / case):
            print("| " + " | ".join(row) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
