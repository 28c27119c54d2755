"""The stability maps of the report, from DIR/stability/<case>.json as `verify stability` writes it.

Each map is a grid of cells coloured by class; the title of a cell says why and holds the command that repeats it. Black bars: the edge of
stability found by bisection; hollow bars: the theoretical limit.

    postprocess/report_extremes.py RESULTS_DIR CASE N FILE.svg      the N-th map of the case (from 1), by itself
"""

import json
import sys
from html import escape
from pathlib import Path

from svgplot import standalone

CLASSES = {
    "accurate": "#2e8b57",
    "bounded but wrong": "#e3c34c",
    "growing energy": "#e07b39",
    "diverged": "#b03030",
    "out of time": "#7a4b8c",
    "refused": "#5f7f9f",
    "not judged": "#b8bcbf",
}
CELL_WIDTH, CELL_HEIGHT, LEFT, TOP = 74, 30, 170, 26


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


def bar(values, row, wanted, style):
    at = span_position(values, wanted) if wanted is not None else None
    if at is None:
        return ""
    x, y = LEFT + at * CELL_WIDTH, TOP + row * CELL_HEIGHT
    return f'<path d="M{x:.1f} {y + 2}v{CELL_HEIGHT - 4}" {style}/>'


def picture(stability_map):
    xs, ys = stability_map["x"]["values"], stability_map["y"]["values"] or [""]
    width, height = LEFT + CELL_WIDTH * len(xs) + 10, TOP + CELL_HEIGHT * len(ys) + 30
    parts = [f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="sans-serif" font-size="11" role="img">']
    for k, value in enumerate(xs):
        parts.append(f'<text x="{LEFT + (k + 0.5) * CELL_WIDTH}" y="{TOP - 8}" text-anchor="middle" fill="currentColor">{escape(str(value))}</text>')
    for j, value in enumerate(ys):
        parts.append(
            f'<text x="{LEFT - 8}" y="{TOP + (j + 0.65) * CELL_HEIGHT}" text-anchor="end" fill="currentColor">{escape(str(value))}</text>'
        )
    for cell in stability_map["cells"]:
        x, y = LEFT + cell["column"] * CELL_WIDTH, TOP + cell["row"] * CELL_HEIGHT
        title = escape(f"{cell['class']}: {cell['why']}\n{cell['repeat']}")
        parts.append(
            f'<rect x="{x + 1}" y="{y + 1}" width="{CELL_WIDTH - 2}" height="{CELL_HEIGHT - 2}" rx="3" fill="{CLASSES.get(cell["class"], "#999")}"><title>{title}</title></rect>'
        )
    for edge in stability_map["edges"]:
        parts.append(bar(xs, edge["row"], edge.get("edge"), 'stroke="#000" stroke-width="4"'))
        parts.append(bar(xs, edge["row"], edge.get("theory"), 'stroke="#fff" stroke-width="3" stroke-dasharray="3 3"'))
    label = f'{stability_map["x"]["label"]} →   (rows: {stability_map["y"]["label"]})'
    parts.append(f'<text x="{LEFT}" y="{height - 10}" fill="currentColor">{escape(label)}</text></svg>')
    return "".join(parts)


def legend():
    return " ".join(
        f'<span class="badge" style="background:{colour}">{escape(name)}</span>' for name, colour in CLASSES.items()
    )


def edges(stability_map):
    rows = []
    for edge in stability_map["edges"]:
        value = stability_map["y"]["values"][edge["row"]] if stability_map["y"]["values"] else ""
        theory = "–" if edge.get("theory") is None else f"{edge['theory']:.4g}"
        rows.append(f"<tr><td>{escape(str(value))}</td><td class='n'>{edge['stable']:.4g}</td><td class='n'>{edge['unstable']:.4g}</td><td class='n'>{theory}</td></tr>")
    if not rows:
        return ""
    head = f"<tr><th>{escape(stability_map['y']['label'])}</th><th>last stable</th><th>first unstable</th><th>theory</th></tr>"
    return f"<table>{head}{''.join(rows)}</table>"


def commands(stability_map):
    lines = "".join(
        f"<tr><td>{escape(str(c['x']))}</td><td>{escape(str(c['y']))}</td><td>{escape(c['class'])}</td><td>{escape(c['why'])}</td><td><code>{escape(c['repeat'])}</code></td></tr>"
        for c in stability_map["cells"]
    )
    return f"<details><summary>every cell is a command</summary><div class='scroll'><table>{lines}</table></div></details>"


def page(stability):
    parts = [f"<p>{legend()}</p>"]
    for stability_map in stability["maps"]:
        parts.append(f"<h3>{escape(stability_map['name'])}</h3><div class='scroll'>{picture(stability_map)}</div>")
        parts.append(edges(stability_map) + commands(stability_map))
    return "".join(parts)


def pages(folder):
    """[{case, html}] of all maps made under `folder`."""
    found = sorted((folder / "stability").glob("*.json")) if (folder / "stability").is_dir() else []
    maps = [json.loads(path.read_text()) for path in found]
    return [dict(case=entry["case"], html=page(entry)) for entry in maps]


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit("usage: report_extremes.py RESULTS_DIR CASE N FILE.svg")
    made = json.loads((Path(sys.argv[1]) / "stability" / f"{sys.argv[2]}.json").read_text())
    Path(sys.argv[4]).write_text(standalone(picture(made["maps"][int(sys.argv[3]) - 1])))
