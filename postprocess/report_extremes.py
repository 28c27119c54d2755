#!/usr/bin/python3
"""The stability maps of the report, from DIR/stability/<case>.json as `verify stability` writes it.

Each map is a grid of cells coloured by class; the title of a cell says why and holds the command that repeats it. Black bars: the edge of
stability, refined by bisection where the map asks for it; white triangles: the theoretical limit. The legend names what the map holds and nothing else.

    postprocess/report_extremes.py RESULTS_DIR CASE N FILE.svg      the N-th map of the case (from 1), by itself
"""

from html import escape
from pathlib import Path

from svgplot import standalone
from written import Unusable, folder_of, program, read_json

CLASSES = {
    "accurate": "#2e8b57",
    "bounded but wrong": "#e3c34c",
    "growing energy": "#e07b39",
    "diverged": "#b03030",
    "out of time": "#7a4b8c",
    "refused": "#5f7f9f",
    "not judged": "#b8bcbf",
}
CELL_WIDTH, CELL_HEIGHT, TOP = 74, 30, 44  # a cell is at least so wide
LETTER = 6.2  # pixels of a letter of the font below, on average: enough to keep text inside the picture
MARKS = {"edge": "edge of stability", "theory": "theoretical limit"}


def span_position(values, wanted):
    """Where `wanted` lies on the row of cells, in cells from the left; None outside or where values are no numbers."""
    try:
        numbers = [float(v) for v in values]
    except (TypeError, ValueError):
        return None
    for k in range(len(numbers) - 1):
        low, high = sorted(numbers[k : k + 2])
        if low <= wanted <= high and high > low:
            return k + 0.5 + (wanted - numbers[k]) / (numbers[k + 1] - numbers[k])
    return None


def short_value(value, most=9):
    """The value of an axis as the command has it, or as 6e+12 where that would not fit."""
    words = str(value)
    try:
        return words if len(words) <= most else f"{float(words):g}"
    except ValueError:
        return words


def reason(cell):
    """Why a cell has its class; of a run that stopped, from its trouble on and without the command, which stands beside it."""
    why = cell["why"]
    for sign in ("numerical trouble", "[error]"):
        why = why[max(0, why.find(sign)) :]
    return why.split("The record keeps what came before")[0].strip().rstrip(";")


def mark(x, y, kind):
    """An edge is a bar over the height of a row, a theoretical limit a white triangle at its top: they often lie side by side."""
    if kind == "edge":
        return f'<path d="M{x:.1f} {y}v{CELL_HEIGHT - 4}" stroke="#000" stroke-width="4"/>'
    return f'<path d="M{x - 6:.1f} {y - 2}h12l-6 10z" fill="#fff" stroke="#000" stroke-width="1.2"/>'


def bar(values, row, wanted, kind, left, cell_width):
    at = span_position(values, wanted) if wanted is not None else None
    return "" if at is None else mark(left + at * cell_width, TOP + row * CELL_HEIGHT + 2, kind)


def text(x, y, words, anchor="start"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="currentColor">{escape(str(words))}</text>'


def legend(stability_map, bars, y):
    """(SVG, its width): classes and bars that occur in this map."""
    parts, x = [], 8
    present = {cell["class"] for cell in stability_map["cells"]}
    for name in [name for name in CLASSES if name in present]:
        parts.append(f'<rect x="{x}" y="{y}" width="16" height="16" rx="3" fill="{CLASSES[name]}"/>' + text(x + 21, y + 12, name))
        x += 36 + LETTER * len(name)
    for kind in [kind for kind in MARKS if kind in bars]:
        parts.append(f'<g transform="translate({x + 4:.1f} {y + (4 if kind == "theory" else 0)}) scale(1 .6)">{mark(0, 0, kind)}</g>' + text(x + 14, y + 12, MARKS[kind]))
        x += 28 + LETTER * len(MARKS[kind])
    return "".join(parts), x


def picture(stability_map, commands_too=True):
    """SVG; a figure by itself leaves the commands out, for they name the folder of one campaign."""
    xs, ys = stability_map["x"]["values"], stability_map["y"]["values"] or [""]
    x_label, y_label = f'{stability_map["x"]["label"]} →', f'{stability_map["y"]["label"]} ↓' if stability_map["y"]["values"] else ""
    left = 24 + LETTER * max(len(str(words)) for words in (*map(short_value, ys), y_label))
    wide = max(CELL_WIDTH, 8 + LETTER * max(len(short_value(value)) for value in xs))
    parts, bars = [], {}
    for cell in stability_map["cells"]:
        x, y = left + cell["column"] * wide, TOP + cell["row"] * CELL_HEIGHT
        title = escape(f"{cell['class']}: {reason(cell)}" + (f"\n{cell['repeat']}" if commands_too else ""))
        colour = CLASSES.get(cell["class"], "#999")
        parts.append(f'<rect x="{x + 1:.1f}" y="{y + 1}" width="{wide - 2:.1f}" height="{CELL_HEIGHT - 2}" rx="3" fill="{colour}"><title>{title}</title></rect>')
    for edge in stability_map["edges"]:
        for kind in MARKS:
            drawn = bar(xs, edge["row"], edge.get(kind), kind, left, wide)
            bars.update({kind: True} if drawn else {})
            parts.append(drawn)
    parts += [text(left + (k + 0.5) * wide, TOP - 8, short_value(value), "middle") for k, value in enumerate(xs)]
    parts += [text(left - 8, TOP + (j + 0.65) * CELL_HEIGHT, short_value(value), "end") for j, value in enumerate(ys)]
    below = TOP + CELL_HEIGHT * len(ys) + 14
    signs, reach = legend(stability_map, bars, below)
    parts.append(text(left, TOP - 28, x_label) + text(left - 8, TOP - 8, y_label, "end") + signs)
    width, height = max(left + wide * len(xs) + 10, left + LETTER * len(x_label), reach), below + 26
    head = f'<svg viewBox="0 0 {width:.0f} {height}" width="{width:.0f}" height="{height}" font-family="sans-serif" font-size="11" role="img">'
    return head + "".join(parts) + "</svg>"


def number_or_dash(value):
    return "–" if value is None else f"{value:.4g}"


def edges(stability_map):
    """Table of the edges of stability, and what of them lies outside the bounds that the map sets."""
    rows = []
    for edge in stability_map["edges"]:
        value = stability_map["y"]["values"][edge["row"]] if stability_map["y"]["values"] else ""
        numbers = "".join(f"<td class='n'>{number_or_dash(edge.get(key))}</td>" for key in ("stable", "unstable", "theory", "ratio"))
        rows.append(f"<tr><td>{escape(str(value))}</td>{numbers}</tr>")
    broken = "".join(f"<p><b>outside its bounds: {escape(sentence)}</b></p>" for sentence in stability_map.get("broken", []))
    if not rows:
        return broken
    bounds = stability_map.get("edge_bounds")
    within = f" ({bounds[0]:g} – {bounds[1]:g})" if bounds else ""
    words = ("stable at", "unstable at", "theory", f"edge over theory{within}")
    head = f"<tr><th>{escape(stability_map['y']['label'])}</th>" + "".join(f"<th class='n'>{word}</th>" for word in words) + "</tr>"
    return f"<table class='narrow'>{head}{''.join(rows)}</table>{broken}"


def commands(stability_map):
    lines = "".join(
        f"<tr><td>{escape(str(c['x']))}</td><td>{escape(str(c['y']))}</td><td>{escape(c['class'])}</td><td>{escape(reason(c))}</td><td class='command'><code>{escape(c['repeat'])}</code></td></tr>"
        for c in stability_map["cells"] + stability_map.get("bisected", [])
    )
    head = "".join(f"<th>{escape(name)}</th>" for name in (stability_map["x"]["label"], stability_map["y"]["label"] or "", "class", "why", "repeat with"))
    between = ", also those between two that the edge was found by" if stability_map.get("bisected") else ""
    return f"<details><summary>every cell is a command{between}</summary><div class='scroll'><table><tr>{head}</tr>{lines}</table></div></details>"


def page(stability):
    made = stability.get("provenance", {})
    parts = [
        f"<p class='quiet'>Suite {escape(stability.get('suite', ''))}; a cell's title says why it has its class. {escape(made.get('start', ''))}, "
        f"commit <code>{escape(made.get('commit', ''))}</code>{', with uncommitted changes' if made.get('dirty') in ('yes', 'true', '1') else ''}.</p>"
    ]
    for stability_map in stability["maps"]:
        parts.append(f"<h3>{escape(stability_map['name'])}</h3><div class='scroll'>{picture(stability_map)}</div>")
        parts.append(edges(stability_map) + commands(stability_map))
    return "".join(parts)


def pages(folder):
    """[{case, html}] of all maps made under `folder`."""
    found = sorted((folder / "stability").glob("*.json")) if (folder / "stability").is_dir() else []
    maps = [read_json(path) for path in found]
    return [dict(case=entry["case"], html=page(entry)) for entry in maps]


def main(arguments):
    if len(arguments) != 4:
        raise Unusable("usage: report_extremes.py RESULTS_DIR CASE N FILE.svg")
    folder = folder_of(arguments[0]) / "stability"
    maps = read_json(folder / f"{arguments[1]}.json", folder.glob("*.json"))["maps"]
    number = int(arguments[2]) if arguments[2].isdecimal() else 0
    if not 1 <= number <= len(maps):
        raise Unusable(f"{arguments[1]} has no map {arguments[2]}: N counts from 1 to {len(maps)}")
    Path(arguments[3]).write_text(standalone(picture(maps[number - 1], commands_too=False)))
    return 0


if __name__ == "__main__":
    program("report_extremes", main)
