"""Writes DIR/index.html, self-contained, from what a campaign left in DIR: python3 report.py DIR

Reads campaign.json, <case>/curves.json and, where there are any, tradeoff/*.json, stability/*.json and figures/*.png. Called by
`verify run` and `verify report`.
"""

import base64
import re
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
from table import limit_text, unit_of
from written import Unusable, folder_of, program, read_json, read_shaped, write_whole

MEANING = {
    0: "all right",
    1: "a comparison failed",
    2: "bad input",
    3: "a run diverged or ran out of time",
    4: "a reference is missing",
    5: "drift only",
    6: "a record could not be written",
    130: "interrupted",
}


def read_if_there(path):
    return read_json(path) if path.is_file() else None


def significant(value, digits=4):
    """A number for people; a dash where there is none."""
    if value is None:
        return "–"
    text = f"{value:.{digits}g}"
    if "e+" in text and abs(value) < 1e6:
        return f"{value:.0f}"
    return re.sub(r"e([+-])0*", lambda m: "e" + m[1].replace("+", ""), text)


def size(value):
    """Bytes as MB."""
    return "–" if value is None else f"{value / 1e6:.0f} MB"


def short(label, length=58):
    return label if len(label) <= length else label[: length - 1] + "…"


def axis_names(label, units=None):
    """What a curve is drawn over, and what it is: from its description, such as 'mpm_pf: line "arm" von_mises over x at t = 1'; each with
    its unit where `units` of the record tell it."""
    found = re.search(r'\b(table|line)((?: "[^"]*")+) (.+?)(?: over (.+?))?(?: from .+ to .+?)?(?: at (?:the end|t = .+))?$', label)
    if not found:
        return "abscissa", "value"
    table, probes = found[1] == "table", re.findall('"([^"]*)"', found[2])
    unit = [units.of(probes[0], column) if units else "" for column in (found[4] or ("time" if table else "s"), found[3])]
    names = found[4] or ("time" if table else "distance along the line"), short(found[3], 34)
    return tuple(name + (f" ({of_it})" if of_it else "") for name, of_it in zip(names, unit))


def overlay(curves, units=None):
    """The picture of one check: what was taken over what it is held against, with the units of the record. Empty where both are numbers."""
    taken, reference = curves["taken"], curves["reference"]
    if "outline" in taken:
        length = f" ({units.length})" if units else ""
        plot = Plot("x" + length, "y" + length, equal=True)
        for part, colour, dash in ((reference, "#2c6fbb", ""), (taken, "#c0392b", "5 3")):
            for k, line in enumerate(part.get("outline", [])):
                label = short(part["label"]) if k == 0 else ""
                plot.line(line["x"] + line["x"][:1], line["y"] + line["y"][:1], label, colour, dash)
        return plot.svg()
    if "x" not in taken:
        return ""
    plot = Plot(*axis_names(taken["label"], units))
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


def units_of_runs(folder, case):
    """{run: units of its record}; nothing of a record that is gone or cannot be read."""
    try:
        import recorded_units
    except ImportError:  # without h5py there are no units, as there are no maps
        return {}
    found, stem = {}, "scene" if case.get("suite") == "full" else case.get("suite", "")
    for run in case["runs"]:
        try:
            found[run["name"]] = recorded_units.of_record(folder / case["case"] / stem / f'{run["name"]}.h5')
        except (OSError, KeyError):
            pass
    return found


def add_pictures(folder, case):
    """Puts an SVG into each check that has curves, an outline or an order."""
    units = units_of_runs(folder, case)
    curves = {c["check"]: c for c in read_if_there(folder / case["case"] / "curves.json") or []}
    for check in case["checks"]:
        check["picture"], check["value_unit"], check["limits"] = "", unit_of(check), limit_text(check)
        if "order" in check:
            check["picture"] = order_plot(check["order"])
        elif check["name"] in curves:
            drawn = curves[check["name"]]
            run = re.match(r"(?:\w+ of )?([^:]+): ", drawn["taken"]["label"])
            check["picture"] = overlay(drawn, units.get(run[1]) if run else None)


def split_forecasts(case):
    """Forecasts of runs are checks like any other, but of the plan and not of physics: they are shown apart."""
    for check in case["checks"]:
        check["forecast"] = check["name"].startswith("forecast, ")
    case["forecasts"] = [check for check in case["checks"] if check["forecast"]]
    case["physics"] = [check for check in case["checks"] if not check["forecast"]]


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


def not_passed(campaign, most=3):
    """(case, which of its checks did not pass); their names where they are few."""
    found = []
    for case in campaign["cases"]:
        lost = [check for check in case["checks"] if check["status"] != "pass"]
        names = ", ".join(f'{check["name"]} ({check["status"]})' for check in lost[:most])
        if lost:
            found.append((case["case"], names + (f" and {len(lost) - most} more" if len(lost) > most else "")))
    return found


def left_over(folder, campaign):
    """Cases that an earlier campaign left in the folder: name, checks passed, checks. They are no part of this one."""
    known = {case["case"] for case in campaign["cases"]}
    found = [read_json(path) for path in sorted(folder.glob("*/verdict.json")) if path.parent.name not in known]
    return [(case["case"], sum(check["status"] == "pass" for check in case["checks"]), len(case["checks"])) for case in found]


def heading(campaign):
    """What the report is of, and how it ended where anything was judged."""
    if not campaign["cases"]:
        return "verify: what speed costs, where it breaks"
    return f'verify {campaign["suite"]}: {MEANING.get(campaign["exit_code"], "")}'


def write(folder):
    path = folder / "campaign.json"
    campaign = read_shaped(path, "suite", "started", "wall_s", "exit_code", "cores", "jobs", "cases", "provenance") if path.is_file() else None
    if campaign is None:  # a trade or a map was measured without a campaign
        campaign = dict(suite="", started="", wall_s=None, exit_code=0, cores=0, jobs=0, cases=[], provenance={})
    for case in campaign["cases"]:
        add_pictures(folder, case)
        split_forecasts(case)
        case["maps"] = error_maps(folder, case)
        case["cpu_s"] = sum(run["cpu_s"] for run in case["runs"])
        case["wall_s"] = sum(run["wall_s"] for run in case["runs"])
    checks = [check for case in campaign["cases"] for check in case["checks"]]
    here = Path(__file__).resolve().parent
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(here), autoescape=True, trim_blocks=True, lstrip_blocks=True)
    environment.filters.update(sig=significant, mb=size, parts=report_modules.parts_table)
    page = environment.get_template("report.html").render(
        campaign=campaign,
        heading=heading(campaign),
        left_over=left_over(folder, campaign),
        not_passed=not_passed(campaign),
        checks=checks,
        passed=sum(check["status"] == "pass" for check in checks),
        images=images(folder),
        trades=report_trade.pages(folder),
        extremes=report_extremes.pages(folder),
        modules=report_modules.page(campaign),
    )
    write_whole(folder / "index.html", page)


def main(arguments):
    if len(arguments) != 1:
        raise Unusable("usage: report.py DIR")
    write(folder_of(arguments[0]))
    return 0


if __name__ == "__main__":
    program("report", main)
