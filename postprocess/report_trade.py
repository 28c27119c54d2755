"""The work-precision pages of the report, from DIR/tradeoff/<case>.json as `verify tradeoff` writes it.

One plot per quantity and norm, chosen with a menu: error against CPU seconds, one colour per family, what is dominated pale, the Pareto
front as a line; runs that diverged or ran out of time stand as crosses at the upper edge, at the cost they had.
"""

import json
from html import escape

from svgplot import COLOURS, Plot


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


def plot(trade, measure):
    """SVG of one measure ("quantity, norm")."""
    families = list(dict.fromkeys(row["family"] for row in trade["rows"]))
    good = [(row, row["errors"][measure]) for row in trade["rows"] if row["errors"].get(measure)]
    bad = [row for row in trade["rows"] if row["errors"].get(measure) is None]
    picture = Plot("CPU seconds", f"error: {measure}", log_x=True, log_y=True, size=(720, 420))
    costs = [max(row["cpu_s"], 1e-3) for row, _ in good]
    errors = [error for _, error in good]
    front = pareto_front(list(zip(costs, errors)))
    picture.line([costs[k] for k in front], [errors[k] for k in front], "Pareto front", "#8a8f94", "5 3")
    uncertainty = trade["reference"].get("uncertainty", {}).get(measure)
    if uncertainty and costs:
        picture.line([min(costs), max(costs)], [uncertainty] * 2, "uncertainty of the reference", "#8a8f94", "2 3", 1.2)
    for k, family in enumerate(families):
        colour = COLOURS[k % len(COLOURS)]
        for pale in (True, False):
            chosen = [j for j, (row, _) in enumerate(good) if row["family"] == family and (j in front) != pale]
            named = family if not pale or not any(good[j][0]["family"] == family for j in front) else ""
            picture.points(
                [costs[j] for j in chosen],
                [errors[j] for j in chosen],
                named if chosen else "",
                colour,
                pale,
                [title(good[j][0], errors[j]) for j in chosen],
            )
        lost = [row for row in bad if row["family"] == family]
        if lost and errors:
            picture.points(
                [max(row["cpu_s"], 1e-3) for row in lost], [2.0 * max(errors)] * len(lost), "", colour,
                titles=[title(row, None) for row in lost], shape="cross",
            )
    return picture.svg()


def table(trade):
    measures = trade["measures"]
    head = "".join(f"<th>{escape(m)}</th>" for m in measures)
    lines = []
    for row in sorted(trade["rows"], key=lambda r: r["cpu_s"]):
        cells = "".join(
            f'<td class="n">{row["errors"][m]:.3g}</td>' if row["errors"].get(m) is not None else "<td>–</td>" for m in measures
        )
        memory = row["peak_rss_bytes"] / 1e6
        spread = f' ± {row["cpu_spread_s"]:.2g}' if row.get("cpu_spread_s") else ""
        lines.append(
            f'<tr><td>{escape(row["family"])}</td><td>{escape(settings(row))}</td><td>{escape(row["status"])}</td>'
            f'<td class="n">{row["cpu_s"]:.3g}{spread}</td><td class="n">{row["wall_s"]:.3g}</td><td class="n">{memory:.0f}</td>{cells}'
            f'<td><details><summary>repeat</summary><code>{escape(row["repeat"])}</code></details></td></tr>'
        )
    return (
        '<div class="scroll"><table><tr><th>family</th><th>settings</th><th>status</th><th>CPU s</th><th>wall s</th><th>MB</th>'
        f"{head}<th></th></tr>{''.join(lines)}</table></div>"
    )


def page(trade):
    case = trade["case"]
    options = "".join(f'<option value="{k}">{escape(m)}</option>' for k, m in enumerate(trade["measures"]))
    shown = f"this.parentNode.querySelectorAll('figure').forEach((f, k) => f.hidden = k != this.value)"
    figures = "".join(
        f'<figure{"" if k == 0 else " hidden"}>{plot(trade, m)}</figure>' for k, m in enumerate(trade["measures"])
    )
    note = (
        f'Suite {escape(trade["suite"])}; reference: {escape(trade["reference"]["text"])}. Filled: on the front; pale: dominated; '
        f'crosses: diverged or out of time. Commit <code>{escape(trade["provenance"].get("commit", ""))}</code>.'
    )
    return f'<p class="quiet">{note}</p><div>error in <select aria-label="norm, {escape(case)}" onchange="{escape(shown)}">{options}</select>{figures}</div>{table(trade)}'


def pages(folder):
    """[{case, html}] of all trades measured under `folder`."""
    found = sorted((folder / "tradeoff").glob("*.json")) if (folder / "tradeoff").is_dir() else []
    trades = [json.loads(path.read_text()) for path in found]
    return [dict(case=trade["case"], html=page(trade)) for trade in trades]
