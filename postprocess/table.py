#!/usr/bin/python3
"""The checks of a campaign as Markdown, one row a check: case, check, value, limit, unit, status.

    postprocess/table.py RESULTS_DIR [CASE ...]       prints the rows of these cases (of all)
    postprocess/table.py RESULTS_DIR --refresh FILE   writes the values of today into the rows that FILE already has

A page may have tables of two suites: below a line `<!-- checks: full -->` rows are refreshed from a campaign of the full suite alone, until the
next such line; the columns "taken" and "against" may be added to their head. Between the marks `<!-- campaign full: begin -->` and `<!-- campaign full: end -->` stands what the campaign came to, between
`<!-- runs full: begin -->` and its end, on the page of a case, what each run of it took.

Exit codes: 0 printed or written, 2 bad input, 4 the folder holds no verdict.
"""

import re
import sys
from pathlib import Path

import costs
from between_marks import write_between_marks
from written import Unusable, folder_of, program, read_json, read_shaped, write_whole

COLUMNS = ("case", "check", "value", "limit", "unit", "")  # those of a whole table; "" is the status
MORE = ("taken", "against")  # a page may ask for these, too: what was taken and what it was held against, where each is one number


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def limit_text(check):
    """One number for a norm that cannot be negative, else both ends of the interval."""
    low, high = check["limit"]
    interval = low != 0 or check["norm"] == "value" or "order" in check
    return f"{number(low)} ... {number(high)}" if interval else number(high)


def unit_of(check):
    """The unit of a check's value; an order of convergence and a relative norm have none, whatever they are taken of."""
    unit = check.get("unit") or "-"
    return "-" if "order" in check or check["norm"].startswith("relative") else unit


def rows(folder):
    verdict = read_json(folder / "verdict.json", folder.parent.glob("*/verdict.json"))
    for check in verdict["checks"]:
        yield {
            "case": folder.name,
            "check": check["name"],
            "value": number(check["value"]),
            "limit": limit_text(check),
            "unit": unit_of(check),
            "": check["status"],
            "taken": number(check.get("taken"), 4),
            "against": number(check.get("reference"), 4),
        }


def line(row, columns=COLUMNS):
    return "| " + " | ".join(row[name] for name in columns) + " |"


def columns_of(text):
    """The columns that a head of a table of checks names; None where the line is no such head."""
    cells = tuple(cell.strip() for cell in text.split("|")[1:-1])
    return cells if cells[:2] == COLUMNS[:2] and set(cells) <= set(COLUMNS + MORE) else None


def refreshed(text, found, suite):
    """`text` with its rows of checks (below their heads) as `found`, rows by (case, check) of a campaign of `suite`, has them; their choice and order stay."""
    lines, columns, wanted = text.split("\n"), None, None
    for i, old in enumerate(lines):
        named = re.fullmatch(r"<!-- checks: (\w+) -->", old)
        wanted = named[1] if named else wanted
        if head := columns_of(old):
            columns = head
            continue
        columns = columns if old.startswith("|") else None
        if not columns or re.match(r"\|-", old) or wanted not in (None, suite):
            continue
        case, check = (cell.strip() for cell in old.split("|")[1:3])
        if (case, check) not in found:
            raise Unusable(f"the campaign has no check \"{check}\" of {case}; take its row out, or run that case")
        lines[i] = line(found[case, check], columns)
    return "\n".join(lines)


def refresh(page, results, found):
    """Writes rows of checks, what the campaign came to and the runs of the page's case into a page that has places for them."""
    try:
        old = page.read_text(encoding="utf-8")
    except OSError as error:
        raise Unusable(f"{page} cannot be read ({error.strerror})") from None
    marks = re.findall(r"<!-- (campaign|runs) (\w+): begin -->", old)
    campaign = read_shaped(results / "campaign.json", "suite", "cases") if marks or "<!-- checks: " in old else {"suite": None}
    write_whole(page, refreshed(old, found, campaign["suite"]))
    for kind, suite in marks:
        if suite == campaign["suite"]:
            case = page.resolve().parent.name
            lines = costs.sentence(campaign) if kind == "campaign" else costs.of_runs(read_shaped(results / case / "verdict.json", "case", "suite", "runs"))
            write_between_marks(page, f"{kind} {suite}", "\n".join(lines) + "\n")


def main(arguments):
    file = None
    if "--refresh" in arguments:
        at = arguments.index("--refresh")
        if at != 1 or len(arguments) != 3:
            print(__doc__)
            return 2
        file, arguments = Path(arguments[2]), arguments[:1]
    if not arguments:
        print(__doc__)
        return 2
    results = folder_of(arguments[0])
    cases = arguments[1:] or sorted(p.parent.name for p in results.glob("*/verdict.json"))
    if not cases:
        print(f"table: {results} holds no <case>/verdict.json: no campaign was run there", file=sys.stderr)
        return 4
    lines = [row for case in cases for row in rows(results / case)]  # all of them before the first is printed
    if file is None:
        print("\n".join(["| case | check | value | limit | unit | |", "|---|---|---|---|---|---|", *map(line, lines)]))
        return 0
    refresh(file, results, {(row["case"], row["check"]): row for row in lines})
    return 0


if __name__ == "__main__":
    program("table", main)
