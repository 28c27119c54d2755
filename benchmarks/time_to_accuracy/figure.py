"""Tip velocity against time for several spacings, its error, and what each run cost."""

import numpy as np
from matplotlib import pyplot

import panels
import record
import style

RUNS = ("dx_0.48", "mpm_pf", "dx_0.2133", "five_point", "float", "half_step")
WINDOW = 10.0  # time over which a velocity is a least-squares slope


def spacing(run):
    return run.scene["domain"]["size"][0] / run.scene["domain"]["cells"][0]


def velocity(run):
    """Slope of the tip's position over windows of time: (middles of the windows, slopes)."""
    table = run.table("tip east")
    time, position = table.time, table["position"]
    middles = np.arange(30.0, time[-1] - WINDOW / 2 + 1e-9, 5.0)
    slopes = []
    for middle in middles:
        near = np.abs(time - middle) <= WINDOW / 2 + 1e-9
        slopes.append(np.polyfit(time[near], position[near], 1)[0])
    return middles, np.array(slopes)


def label(name, run):
    text = f"dx = {spacing(run):.2f} $W_0$"
    return text if name in ("mpm_pf",) or name.startswith("dx") else f"{text}, {name.replace('_', ' ')}"


def figure16(results):
    runs = {}
    for name in RUNS:
        try:
            runs[name] = results.record("time_to_accuracy", name)
        except record.Missing:
            if name in RUNS[:2]:
                raise
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.9), layout="constrained")
    tracks = {name: velocity(run) for name, run in runs.items()}
    fine, coarse = ("dx_0.2133", "mpm_pf") if "dx_0.2133" in runs else ("mpm_pf", "dx_0.48")
    ratio = (spacing(runs[coarse]) / spacing(runs[fine])) ** 2
    limit = tracks[fine][1] + (tracks[fine][1] - tracks[coarse][1]) / (ratio - 1)
    middles = tracks[fine][0]
    curves = panels.line_overlay(
        left, "velocity", [("dx, dt $\\to$ 0", middles, limit, {"color": style.THEORY, "lw": 2.2, "alpha": 0.35})]
    )
    for colour, (name, (time, slope)) in zip(style.SEQUENCE, tracks.items()):
        options = {"color": colour, "lw": 1.0, "ls": "--" if name in ("float", "half_step") else "-"}
        cost = f"{label(name, runs[name])}: {runs[name].number('cpu_s'):.1f} CPU s"
        curves += panels.line_overlay(left, "velocity", [(label(name, runs[name]), time, slope, options)])
        error = 100 * np.abs(slope / limit - 1)
        curves += panels.line_overlay(right, "error", [(cost, time, error, options)])
    right.axhline(1.0, color=style.GREY, lw=0.7, ls=":")
    left.set(xlabel=r"$t/\tau_0$", ylabel=r"tip velocity  $V\tau_0/W_0$")
    right.set(xlabel=r"$t/\tau_0$", ylabel="deviation from dx, dt $\\to$ 0 (%)", yscale="log", ylim=(0.02, 60))
    left.legend(loc="upper center", fontsize=6.5)
    right.legend(loc="upper left", fontsize=6.5)
    panels.lettered((left, right))
    return figure, curves


FIGURES = {"fig16": figure16}
