#!/usr/bin/python3
"""The table of presets, error and cost per preset and case, from DIR/tradeoff/*.json: printed, or written between the marks of a text file.

    postprocess/presets.py RESULTS_DIR [README]

The marks are lines `<!-- presets: begin -->` and `<!-- presets: end -->`; what stands between them is replaced. The rows are those that were
measured with `accuracy = ...`: nothing is computed here that was not run. An error below the uncertainty U of what it is held against cannot be
told from none: it stands as `< U`. Where a reference is one run without grids its uncertainty is unknown, and a `?` says so.
"""

from between_marks import table_program, tell_origin
from written import folder_of, program, read_shaped

LEVELS = ["draft", "standard", "fine"]


def level(row):
    """The preset of a row, or nothing."""
    word = row["settings"].get("accuracy", "").strip("\"'")
    return word if word in LEVELS else None


def percent(error):
    return f"{100 * error:.2g} %" if error < 0.995 else f"{100 * error:.0f} %"


def cell(row, measure, uncertainty):
    if row is None:
        return "–"
    error = row["errors"].get(measure)
    if error is None:
        text = row["status"] if row["status"] != "complete" else "not measured"
    else:
        text = f"< {percent(uncertainty)}" if uncertainty and error < uncertainty else percent(error)
    return f'{text}, {row["cpu_s"]:.2g} s, {row["peak_rss_bytes"] / 1e6:.0f} MB'


def measure_of(trade):
    """The first measure is what the case is about."""
    return trade["measures"][0]


def against(trade, measure):
    """What the errors are distances from, with its uncertainty, or `?` where that is unknown."""
    reference = trade["reference"]
    what = reference.get("against", {}).get(measure, "not said")
    known = reference["uncertainty"]
    if measure not in known:
        return what
    return f"{what} (?)" if known[measure] is None else f"{what} (± {percent(known[measure])})"


def lines(trades):
    yield "| case | error of | against | solver | " + " | ".join(f'`"{name}"`' for name in LEVELS) + " |"
    yield "|---|---|---|---|" + "---|" * len(LEVELS)
    for trade in trades:
        measure = measure_of(trade)
        rows = [row for row in trade["rows"] if level(row)]
        for solver in dict.fromkeys(row["solver"] for row in rows):
            found = {level(row): row for row in rows if row["solver"] == solver}
            uncertainty = trade["reference"]["uncertainty"].get(measure)
            cells = " | ".join(cell(found.get(name), measure, uncertainty) for name in LEVELS)
            yield f'| {trade["case"]} | {measure} | {against(trade, measure)} | {solver} | {cells} |'


def table(folder):
    files = sorted((folder_of(folder) / "tradeoff").glob("*.json"))
    trades = [read_shaped(path, "case", "measures", "rows", "reference", "provenance") for path in files]
    trades = [trade for trade in trades if any(level(row) for row in trade["rows"])]
    for made in {trade["provenance"].get("commit"): trade["provenance"] for trade in trades}.values():
        tell_origin(made)
    return "\n".join(lines(trades)) + "\n" if trades else ""


def main(arguments):
    missing = f"presets: {arguments[0] if arguments else ''}/tradeoff holds no row that was measured with `accuracy`; run `verify tradeoff CASE` first"
    return table_program(arguments, __doc__, "presets", table, missing)


if __name__ == "__main__":
    program("presets", main)
