"""Only what a scene requires, from campaign.json: which modules each case has switched on, what each of them holds and costs, and what the
solver had foretold of it.

    postprocess/report_modules.py RESULTS_DIR      prints the table as Markdown
"""

import json
import re
import sys
from html import escape
from pathlib import Path

MARKS = {"met": "✓", "missed": "✗", "not measured": "–"}


def modules(text):
    """Names without their lines: "solid (line 15), growth (line 20)" -> ["solid", "growth"]."""
    return [re.sub(r" \(line \d+\)", "", part).strip() for part in text.split(",") if part.strip()]


def megabytes(value):
    return "–" if value is None else f"{value / 1e6:.3g}"


def held(run):
    """Bytes by module as measured by the run itself."""
    return {name[6:]: value for name, value in run.get("profile", {}).items() if name.startswith("bytes ") and value}


def memory_text(run):
    """"solid points 1.2/1.2, ..." in MB, foretold over measured, module by module."""
    foretold, measured = run["forecast"].get("bytes") or {}, held(run)
    names = [name for name in dict.fromkeys([*foretold, *measured]) if foretold.get(name) or measured.get(name)]
    return ", ".join(f"{name} {megabytes(foretold.get(name))}/{megabytes(measured.get(name))}" for name in names)


def time_text(run):
    parts = run.get("parts", {})
    shown = sorted(((name, part["cpu_s"]) for name, part in parts.items() if part["cpu_s"] > 0), key=lambda p: -p[1])
    return ", ".join(f"{name} {seconds:.2g}" for name, seconds in shown)


def rows(campaign):
    """One row a case and solver: its first run that came to an end and was foretold."""
    for case in campaign["cases"]:
        seen = set()
        for run in case["runs"]:
            if run.get("forecast") and run["solver"] not in seen:
                seen.add(run["solver"])
                yield case["case"], run


def cells(case, run):
    forecast = run["forecast"]
    time = f'{forecast["cpu_s"]:.2g}/{run["cpu_s"]:.2g} {MARKS[forecast["time"]]}'
    solver = f'{megabytes(forecast["solver_bytes"])}/{megabytes(forecast["measured_solver_bytes"])} {MARKS[forecast["memory"]]}'
    resident = f'{megabytes(forecast["resident_bytes"])}/{megabytes(run["peak_rss_bytes"])} {MARKS[forecast["resident"]]}'
    return [case, run["solver"], ", ".join(modules(forecast["on"])), ", ".join(modules(forecast["off"])), memory_text(run), solver, resident, time, time_text(run)]


HEAD = ["case", "solver", "on", "off", "MB by module, foretold/measured", "solver MB", "resident MB", "CPU s", "CPU s by part"]


def page(campaign):
    """HTML of the table, empty where nothing was foretold."""
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells(case, run)) + "</tr>" for case, run in rows(campaign))
    if not body:
        return ""
    sums = campaign.get("forecasts", {})
    said = "; ".join(
        f'{what}: {count["met"]} met, {count["missed"]} missed' for what, count in sums.items()
    )
    head = "".join(f"<th>{escape(name)}</th>" for name in HEAD)
    note = (
        "Every number foretold by --plan over the number measured. Met: the solver's memory within 10 %, resident memory within 10 % + 50 MB, "
        f"CPU time within a factor 2 (3 where finite elements choose their steps or points are sown). All runs: {escape(said)}."
    )
    return f'<p class="quiet">{note}</p><div class="scroll"><table><tr>{head}</tr>{body}</table></div>'


def markdown(campaign):
    head = HEAD[:3] + HEAD[5:8]
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for case, run in rows(campaign):
        line = cells(case, run)
        lines.append("| " + " | ".join(line[:3] + line[5:8]) + " |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: report_modules.py RESULTS_DIR")
    print(markdown(json.loads((Path(sys.argv[1]) / "campaign.json").read_text())), end="")
