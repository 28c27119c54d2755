#!/usr/bin/python3
"""The table of presets, error and cost per preset and case, from DIR/tradeoff/*.json: printed, or written between the marks of a text file.

    postprocess/presets.py RESULTS_DIR [README]

The marks are lines `<!-- presets: begin -->` and `<!-- presets: end -->`; what stands between them is replaced. The rows are those that were
measured with `accuracy = ...`: nothing is computed here that was not run.
"""

import json
import sys

from between_marks import table_program

LEVELS = ["draft", "standard", "fine"]


def level(row):
    """The preset of a row, or nothing."""
    word = row["settings"].get("accuracy", "").strip("\"'")
    return word if word in LEVELS else None


def cell(row, measure):
    if row is None:
        return "–"
    error = row["errors"].get(measure)
    text = row["status"] if error is None else f"{100 * error:.2g} %" if error < 0.995 else f"{100 * error:.0f} %"
    return f'{text}, {row["cpu_s"]:.2g} s, {row["peak_rss_bytes"] / 1e6:.0f} MB'


def measure_of(trade):
    """The first measure is what the case is about."""
    return trade["measures"][0]


def lines(trades):
    yield "| case | error of | solver | " + " | ".join(f'`"{name}"`' for name in LEVELS) + " |"
    yield "|---|---|---|" + "---|" * len(LEVELS)
    for trade in trades:
        measure = measure_of(trade)
        rows = [row for row in trade["rows"] if level(row)]
        for solver in dict.fromkeys(row["solver"] for row in rows):
            found = {level(row): row for row in rows if row["solver"] == solver}
            yield f'| {trade["case"]} | {measure} | {solver} | ' + " | ".join(cell(found.get(name), measure) for name in LEVELS) + " |"


def table(folder):
    trades = [json.loads(path.read_text()) for path in sorted((folder / "tradeoff").glob("*.json"))]
    trades = [trade for trade in trades if any(level(row) for row in trade["rows"])]
    return "\n".join(lines(trades)) + "\n" if trades else ""


def main(arguments):
    missing = f"presets: {arguments[0] if arguments else ''}/tradeoff holds no row that was measured with `accuracy`; run `verify tradeoff CASE` first"
    return table_program(arguments, __doc__, "presets", table, missing)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
