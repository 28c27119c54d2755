#!/usr/bin/python3
"""Only what a scene requires, from campaign.json: which modules each case has switched on, what each of them holds and costs, and what the
solver had predicted of it.

    postprocess/report_modules.py RESULTS_DIR [README]

Prints the table as Markdown, or writes it between the lines `<!-- modules: begin -->` and `<!-- modules: end -->` of a text file.
"""

import re
from html import escape

import costs
from between_marks import table_program, tell_origin
from written import folder_of, program, read_shaped

MARKS = {"met": "✓", "missed": "✗", "not judged": "–"}
# The whole of a run, and what is counted within another part.
FRAME = ("set-up", "solve", "output")


def modules(text):
    """Names without their lines: "solid (line 15), growth (line 20)" -> ["solid", "growth"]."""
    return [re.sub(r" \(line \d+\)", "", part).strip() for part in text.split(",") if part.strip()]


def megabytes(value):
    """Three digits, without exponents; nothing below a kilobyte."""
    if value is None:
        return "–"
    mb = value / 1e6
    return f"{mb:.0f}" if mb >= 100 else f"{mb:.3g}" if mb >= 0.01 else f"{mb:.3f}"


def seconds(value):
    """Two digits, without exponents."""
    return "–" if value is None else f"{value:.0f}" if value >= 100 else f"{value:.2g}" if value >= 1e-4 else "0"


def percent(share):
    return f"{100 * share:.0f} %" if share >= 0.005 else "< 1 %"


def held(run):
    """Bytes by module as measured by the run itself."""
    return {name[6:]: value for name, value in run.get("profile", {}).items() if name.startswith("bytes ") and value}


def memory_rows(run):
    """(module, MB predicted, MB measured), largest first."""
    predicted, measured = run["forecast"].get("bytes") or {}, held(run)
    names = [name for name in dict.fromkeys([*predicted, *measured]) if predicted.get(name) or measured.get(name)]
    names.sort(key=lambda name: -(measured.get(name) or predicted.get(name)))
    return [(name, megabytes(predicted.get(name)), megabytes(measured.get(name))) for name in names]


def part_rows(run):
    """(part, CPU s, share of the run, calls), dearest first; parts that took nothing are left out."""
    parts = run.get("parts", {})
    whole = sum(parts[name]["cpu_s"] for name in FRAME if name in parts) or 1.0
    shown = sorted(((name, part) for name, part in parts.items() if name != "solve" and part["cpu_s"] > 0), key=lambda p: -p[1]["cpu_s"])
    return [(name, seconds(part["cpu_s"]), percent(part["cpu_s"] / whole), f'{part["calls"]:.0f}') for name, part in shown]


def rows(campaign):
    """One row a case and solver: its longest run that came to an end and was predicted."""
    for case in campaign["cases"]:
        longest = {}
        for run in case["runs"]:
            if run.get("forecast") and run["cpu_s"] > longest.get(run["solver"], {"cpu_s": -1})["cpu_s"]:
                longest[run["solver"]] = run
        for solver in sorted(longest, reverse=True):  # mpm_pf, then fe_reference
            yield case["case"], longest[solver]


def pair(predicted, measured, mark):
    return f"{predicted} / {measured} {MARKS[mark]}"


def sums_text(run):
    """Solver's memory, resident memory and CPU time, predicted / measured and whether that was met."""
    forecast = run["forecast"]
    return (
        pair(megabytes(forecast["solver_bytes"]), megabytes(forecast["measured_solver_bytes"]), forecast["memory"]),
        pair(megabytes(forecast["resident_bytes"]), megabytes(run["peak_rss_bytes"]), forecast["resident"]),
        pair(seconds(forecast["cpu_s"]), seconds(run["cpu_s"]), forecast["time"]) + at_contact(forecast),
    )


def at_contact(forecast):
    """What the run itself estimated when a wall had met its crystal, and whether that was met."""
    return f'; at contact {seconds(forecast["at_contact_cpu_s"])} {MARKS[forecast["contact"]]}' if "at_contact_cpu_s" in forecast else ""


def small_table(head, lines):
    cells = "".join("<tr>" + "".join(f"<td{' class=n' if k else ''}>{escape(cell)}</td>" for k, cell in enumerate(line)) + "</tr>" for line in lines)
    return "<table><tr>" + "".join(f"<th{' class=n' if k else ''}>{escape(name)}</th>" for k, name in enumerate(head)) + f"</tr>{cells}</table>" if lines else "–"


def parts_table(run):
    """HTML: the profile of one run by part, empty where its record has none."""
    lines = part_rows(run)
    return small_table(("part", "CPU s", "share", "calls"), lines) if lines else ""


def lines_of(texts):
    return "<br>".join(escape(text) for text in texts) or "–"


def line_of_page(case, run):
    forecast = run["forecast"]
    memory, resident, time = sums_text(run)
    off = ", ".join(modules(forecast["off"]))
    return (
        f'<tr><td><a href="#{escape(case)}">{escape(case)}</a><br><span class="quiet">{escape(run["name"])}</span></td>'
        f'<td class="wide">{escape(", ".join(modules(forecast["on"])))}' + (f'<br><span class="quiet">off: {escape(off)}</span>' if off else "") + "</td>"
        f'<td class="n">{memory}</td><td class="n">{resident}</td><td class="n">{time}</td>'
        f"<td class='close'>{lines_of(f'{name} {predicted} / {measured}' for name, predicted, measured in memory_rows(run))}</td>"
        f"<td class='close'>{lines_of(f'{name} {cpu_s} s, {share}' for name, cpu_s, share, _ in part_rows(run))}</td></tr>"
    )


def page(campaign):
    """HTML of the table, empty where nothing was predicted."""
    body = "".join(line_of_page(case, run) for case, run in rows(campaign))
    if not body:
        return ""
    said = "; ".join(f'{what}: {count["met"]} met, {count["missed"]} missed, {count["not judged"]} not judged' for what, count in campaign.get("forecasts", {}).items())
    heads = [("case and run", ""), ("modules", ""), ("solver MB", " class=n"), ("resident MB", " class=n"), ("CPU s", " class=n"), ("MB by module", ""), ("CPU time by part", "")]
    head = "".join(f"<th{kind}>{name}</th>" for name, kind in heads)
    note = (
        "Numbers are predicted by --plan / measured. ✓ met: the solver's memory within 10 %, resident memory within 10 % + 50 MB, CPU time within a "
        "factor 2 (3 where finite elements choose their steps or points are seeded; 2 of what such a run estimates at contact); – not judged: below 1 s of CPU. What is off holds no byte and is "
        f"never called. Parts may lie within others: points to nodes, nodes, nodes to points and sorting within solid, distance within extension, orientation within advection, factorisations within the solve. The longest run of each case and solver is shown; of all runs: {escape(said)}."
    )
    return f'<p class="quiet">{note}</p><div class="scroll"><table><tr>{head}</tr>{body}</table></div>'


def dearest(run, most=3):
    return ", ".join(f"{name} {share}" for name, _, share, _ in part_rows(run)[:most] if share != percent(0))


def markdown(campaign):
    yield "| case | solver | modules on | solver MB | resident MB | CPU s | where the CPU time goes |"
    yield "|---|---|---|---|---|---|---|"
    for case, run in rows(campaign):
        memory, resident, time = sums_text(run)
        yield f'| {case} | {run["solver"]} | {", ".join(modules(run["forecast"]["on"]))} | {memory} | {resident} | {time} | {dearest(run)} |'


def table(folder):
    path = folder_of(folder) / "campaign.json"
    campaign = read_shaped(path, "suite", "cases") if path.is_file() else None
    lines = list(markdown(campaign)) if campaign else []
    if len(lines) <= 2:
        return ""
    tell_origin(campaign.get("provenance", {}))
    made = costs.programs([run for _, run in rows(campaign)])
    return "\n".join([f"From {len(campaign['cases'])} cases of the {campaign['suite']} suite, {made}:", "", *lines]) + "\n"


def main(arguments):
    missing = f"report_modules: {arguments[0] if arguments else ''} holds no campaign with forecasts; run `verify run` first"
    return table_program(arguments, __doc__, "modules", table, missing)


if __name__ == "__main__":
    program("report_modules", main)
