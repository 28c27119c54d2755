"""Writes DIR/index.html, self-contained, from what a campaign left in DIR: python3 report.py DIR

Reads campaign.json, <case>/curves.json and, where there are any, tradeoff/*.json, stability/*.json and figures/*.png. Called by
`verify run` and `verify report`.
"""

import base64
import json
import sys
from pathlib import Path

try:
    import jinja2
except ImportError as error:
    sys.exit(f"report: the Python module {error.name} is missing; install python3-jinja2 (Debian) for {sys.executable}")

import report_extremes
import report_modules
import report_trade
from svgplot import Plot

MEANING = {
    0: "all right",
    1: "a comparison failed",
    2: "bad input",
    3: "a run diverged or ran out of time",
    4: "a reference is missing",
    5: "drift only",
    130: "interrupted",
}


def read_json(path):
    return json.loads(path.read_text()) if path.is_file() else None


def significant(value, digits=4):
    """A number for people; a dash where there is none."""
    if value is None:
        return "–"
    return f"{value:.{digits}g}"


def size(value):
    """Bytes as MB."""
    return "–" if value is None else f"{value / 1e6:.0f} MB"


def short(label, length=58):
    return label if len(label) <= length else label[: length - 1] + "…"


def overlay(curves):
    """The picture of one check: what was taken over what it is held against. Empty where both are numbers."""
    taken, reference = curves["taken"], curves["reference"]
    if "outline" in taken:
        plot = Plot("x", "y", equal=True)
        for part, colour, dash in ((reference, "#2c6fbb", ""), (taken, "#c0392b", "5 3")):
            for k, line in enumerate(part.get("outline", [])):
                label = short(part["label"]) if k == 0 else ""
                plot.line(line["x"] + line["x"][:1], line["y"] + line["y"][:1], label, colour, dash)
        return plot.svg()
    if "x" not in taken:
        return ""
    plot = Plot("abscissa", "value")
    if "x" in reference:
        plot.line(reference["x"], reference["y"], short(reference["label"]), "#2c6fbb", width=2.6)
    plot.line(taken["x"], taken["y"], short(taken["label"]), "#c0392b", "5 3")
    return plot.svg()


def order_plot(order):
    """Error against mesh size, with the slope of first and second order beside it."""
    pairs = sorted(zip(order["h"], order["error"]))
    h, error = [p[0] for p in pairs], [p[1] for p in pairs]
    plot = Plot("mesh size", "error", log_x=True, log_y=True)
    plot.line(h, error, "measured", "#c0392b")
    plot.points(h, error, colour="#c0392b")
    for slope, dash in ((1, "2 3"), (2, "6 3")):
        plot.line(h, [error[-1] * (v / h[-1]) ** slope for v in h], f"order {slope}", "#8a8f94", dash, 1.2)
    return plot.svg()


def add_pictures(folder, case):
    """Puts an SVG into each check that has curves, an outline or an order."""
    curves = {c["check"]: c for c in read_json(folder / case["case"] / "curves.json") or []}
    for check in case["checks"]:
        check["picture"] = ""
        if "order" in check:
            check["picture"] = order_plot(check["order"])
        elif check["name"] in curves:
            check["picture"] = overlay(curves[check["name"]])


def error_maps(folder, case):
    """Side-by-side fields of the two solvers and their difference; nothing where one of them has no snapshot."""
    try:
        import error_map
    except ImportError as error:
        print(f"report: no error maps, the Python module {error.name} is missing", file=sys.stderr)
        return []
    return error_map.of_case(folder, case)


def images(folder):
    """PNG files of the figures, embedded."""
    found = sorted((folder / "figures").glob("*.png")) if (folder / "figures").is_dir() else []
    return [(p.stem, base64.b64encode(p.read_bytes()).decode()) for p in found]


def write(folder):
    campaign = read_json(folder / "campaign.json")
    if campaign is None:  # a trade or a map was measured without a campaign
        campaign = dict(suite="trade and extremes", started="", wall_s=None, exit_code=0, cores=0, jobs=0, cases=[], provenance={})
    for case in campaign["cases"]:
        add_pictures(folder, case)
        case["maps"] = error_maps(folder, case)
        case["cpu_s"] = sum(run["cpu_s"] for run in case["runs"])
        case["wall_s"] = sum(run["wall_s"] for run in case["runs"])
    here = Path(__file__).resolve().parent
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(here), autoescape=True, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(sig=significant, mb=size, parts=report_modules.parts_table)
    page = environment.get_template("report.html").render(
        campaign=campaign,
        meaning=MEANING.get(campaign["exit_code"], ""),
        images=images(folder),
        trades=report_trade.pages(folder),
        extremes=report_extremes.pages(folder),
        modules=report_modules.page(campaign),
    )
    target = folder / "index.html"
    target.with_suffix(".part").write_text(page)
    target.with_suffix(".part").replace(target)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: report.py DIR")
    write(Path(sys.argv[1]))
