#!/usr/bin/python3
"""The work-precision pages of the report, from DIR/tradeoff/<case>.json as `verify tradeoff` writes it.

One plot per quantity and norm, chosen with a menu: error against CPU seconds, one colour per family, what is dominated pale, the Pareto
front of each solver dashed; runs that diverged, ran out of time or were refused stand as crosses at the upper edge, at the cost they had.

    postprocess/report_trade.py RESULTS_DIR CASE FILE.svg      the figure of the case's first measure, by itself
"""

from html import escape
from pathlib import Path

from svgplot import COLOURS, Plot, standalone
from written import Unusable, folder_of, program, read_json

LOST = ("diverged", "timed out", "failed", "bad input", "not written")  # runs that gave no answer


def pareto_front(rows):
    """Indices of the rows (cost, error) that no other row beats in both; sorted by cost."""
    front, best = [], float("inf")
    for index, (cost, error) in sorted(enumerate(rows), key=lambda entry: entry[1]):
        if error < best:
            front.append(index)
            best = error
    return front


def settings(row):
    return ", ".join(f"{key} = {value}" for key, value in row["settings"].items()) or "as in the scene"


def title(row, error):
    text = "no answer: " + row["status"] if error is None else f"{error:.3g}"
    return f"{row['family']}: {settings(row)}; error {text}, {row['cpu_s']:.3g} s CPU"


def cost(row):
    return max(row["cpu_s"], 1e-3)


def fronts(rows, measure):
    """Solver -> its rows on the Pareto front, cheapest first."""
    result = {}
    for solver in dict.fromkeys(row["solver"] for row in rows):
        own = [row for row in rows if row["solver"] == solver]
        result[solver] = [own[k] for k in pareto_front([(cost(row), row["errors"][measure]) for row in own])]
    return result


def plot(trade, measure):
    """SVG of one measure ("quantity, norm")."""
    good = [row for row in trade["rows"] if row["errors"].get(measure)]
    lost = [row for row in trade["rows"] if not row["errors"].get(measure) and row["status"] in LOST]
    picture = Plot("CPU seconds", f"error: {measure}", log_x=True, log_y=True, size=(860, 420), legend_width=230)
    best = fronts(good, measure)
    for solver, rows in best.items():
        x, y = [cost(row) for row in rows], [row["errors"][measure] for row in rows]
        picture.line(x, y, f"Pareto front, {solver}", "#8a8f94", "5 3" if solver == "mpm_pf" else "1 3", 2.5)
    uncertainty = trade["reference"].get("uncertainty", {}).get(measure)
    if uncertainty and good:
        costs = [cost(row) for row in good]
        picture.line([min(costs), max(costs)], [uncertainty] * 2, "uncertainty of the reference", "#8a8f94", "8 3 2 3", 1.2)
    top = max((row["errors"][measure] for row in good), default=1.0)
    for k, family in enumerate(dict.fromkeys(row["family"] for row in trade["rows"])):
        colour = COLOURS[k % len(COLOURS)]
        own = sorted((row for row in good if row["family"] == family), key=cost)
        elements = own and own[0]["solver"] == "fe_reference"  # dashed: colours come round again
        picture.line([cost(row) for row in own], [row["errors"][measure] for row in own], family, colour, "4 2" if elements else "", 0.8)
        for pale in (True, False):
            chosen = [row for row in own if (row in best[row["solver"]]) != pale]
            titles = [title(row, row["errors"][measure]) for row in chosen]
            picture.points([cost(row) for row in chosen], [row["errors"][measure] for row in chosen], "", colour, pale, titles)
        edge = [row for row in lost if row["family"] == family]
        titles = [title(row, None) for row in edge]
        picture.points([cost(row) for row in edge], [2.0 * top] * len(edge), "", colour, False, titles, "cross")
    return picture.svg()


def drawn(trade, measure):
    """The plot, or why there is none."""
    errors = [row["errors"].get(measure) for row in trade["rows"]]
    if any(errors):
        return plot(trade, measure)
    return f"<p>No plot: {'every error that was measured is exactly zero' if 0 in errors else 'nothing was measured'}.</p>"


def table(trade):
    measures = trade["measures"]
    head = "".join(f"<th class='n'>{escape(m)}</th>" for m in measures)
    lines = []
    for row in sorted(trade["rows"], key=lambda r: r["cpu_s"]):
        cells = "".join(
            f'<td class="n">{row["errors"][m]:.3g}</td>' if row["errors"].get(m) is not None else '<td class="n">–</td>' for m in measures
        )
        memory = row["peak_rss_bytes"] / 1e6
        spread = f' ± {row["cpu_spread_s"]:.2g}' if row.get("cpu_spread_s") else ""
        lines.append(
            f'<tr><td>{escape(row["family"])}</td><td>{escape(settings(row))}</td><td title="{escape(" ".join(row.get("why", [])))}">{escape(row["status"])}</td>'
            f'<td class="n">{row["cpu_s"]:.3g}{spread}</td><td class="n">{row["wall_s"]:.3g}</td><td class="n">{memory:.0f}</td>{cells}'
            f'<td><details><summary>repeat</summary><code>{escape(row["repeat"])}</code></details></td></tr>'
        )
    return (
        '<div class="scroll"><table><tr><th>family</th><th>settings</th><th>status</th><th class="n">CPU s</th><th class="n">wall s</th><th class="n">MB</th>'
        f"{head}<th></th></tr>{''.join(lines)}</table></div>"
    )


def page(trade):
    case = trade["case"]
    options = "".join(f'<option value="{k}">{escape(m)}</option>' for k, m in enumerate(trade["measures"]))
    shown = "this.parentNode.querySelectorAll('figure').forEach((f, k) => f.hidden = k != this.value)"
    figures = "".join(
        f'<figure{"" if k == 0 else " hidden"}>{drawn(trade, m)}</figure>' for k, m in enumerate(trade["measures"])
    )
    made = trade["provenance"]
    note = (
        f'Suite {escape(trade["suite"])}; reference: {escape(trade["reference"]["text"])}. Filled: on the front; pale: dominated; '
        f'crosses at the upper edge: diverged, out of time or refused. Errors below the line of the reference\'s uncertainty, where there is one, cannot be told '
        f'apart; an error of zero has no place on these axes. {escape(made.get("start", ""))}, commit <code>{escape(made.get("commit", ""))}</code>.'
    )
    return f'<p class="quiet">{note}</p><div>error in <select aria-label="norm, {escape(case)}" onchange="{escape(shown)}">{options}</select>{figures}</div>{table(trade)}'


def pages(folder):
    """[{case, html}] of all trades measured under `folder`."""
    found = sorted((folder / "tradeoff").glob("*.json")) if (folder / "tradeoff").is_dir() else []
    trades = [read_json(path) for path in found]
    return [dict(case=trade["case"], html=page(trade)) for trade in trades]


def main(arguments):
    if len(arguments) != 3:
        raise Unusable("usage: report_trade.py RESULTS_DIR CASE FILE.svg")
    folder = folder_of(arguments[0]) / "tradeoff"
    measured = read_json(folder / f"{arguments[1]}.json", folder.glob("*.json"))
    if not measured["measures"]:
        raise Unusable(f"the trade of {arguments[1]} has no measure")
    Path(arguments[2]).write_text(standalone(plot(measured, measured["measures"][0])))
    return 0


if __name__ == "__main__":
    program("report_trade", main)
