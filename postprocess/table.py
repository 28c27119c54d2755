#!/usr/bin/python3
"""The result table of a campaign as Markdown, for the README.

    postprocess/table.py RESULTS_DIR [CASE ...]     prints one row a check: case, check, value, limit, status

Exit codes: 0 printed, 2 bad input, 4 the folder holds no verdict.
"""

import sys

from written import folder_of, program, read_json


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
    verdict = read_json(folder / "verdict.json", folder.parent.glob("*/verdict.json"))
    for check in verdict["checks"]:
        yield (folder.name, check["name"], number(check["value"]), limit_text(check["limit"]),
               unit_of(check), check["status"])


def main(arguments):
    if not arguments:
        print(__doc__)
        return 2
    results = folder_of(arguments[0])
    cases = arguments[1:] or sorted(p.parent.name for p in results.glob("*/verdict.json"))
    if not cases:
        print(f"table: {results} holds no <case>/verdict.json: no campaign was run there", file=sys.stderr)
        return 4
    lines = [row for case in cases for row in rows(results / case)]  # all of them before the first is printed
    print("| case | check | value | limit | unit | |")
    print("|---|---|---|---|---|---|")
    for row in lines:
        print("| " + " | ".join(row) + " |")
    return 0


if __name__ == "__main__":
    program("table", main)
