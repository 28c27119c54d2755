"""Free growth against solvability: velocity and radius along the way, and how they converge."""

import numpy as np
from matplotlib import pyplot

import panels
import record
import style

RUNS = ("dx_0.8", "dx_0.6", "mpm_pf", "dx_0.3", "W0_halved")
VELOCITY, RADIUS = 0.01703, 6.20  # V d0/D and rho/d0 of microscopic solvability
FROM, TO = 160.0, 200.0  # W0 of the first runs: the window in which the velocity is fitted


def groups(run):
    """d0/W0, D and the spacing, in the run's own units, and W0 in units of the paper's."""
    capillary = run.scene["growth"]["capillary_length"]
    domain = run.scene["domain"]
    return capillary, run.scene["heat"]["diffusivity"], domain["size"][0] / domain["cells"][0], 0.185 / capillary


def fitted(run, start, end):
    """V d0/D (least squares of time over position) and mean rho/d0 while the tip is in between."""
    capillary, diffusivity, _, width = groups(run)
    table = run.table("tip east")
    place = table["position"] * width
    near = (place >= start) & (place <= end)
    if near.sum() < 4:
        return np.nan, np.nan
    slowness = np.polyfit(table["position"][near], table.time[near], 1)[0]
    return capillary / diffusivity / slowness, np.mean(table["radius"][near]) / capillary


def label(name, run):
    _, _, spacing, _ = groups(run)
    return f"dx = {spacing:.1f} $W_0$" + (", $W_0$ halved" if name == "W0_halved" else "")


def figure17(results):
    runs = {}
    for name in RUNS:
        try:
            runs[name] = results.record("free_growth", name)
        except record.Missing:
            if name == "mpm_pf":
                raise
    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(style.DOUBLE, 2.7), layout="constrained")
    curves, ends = [], {}
    starts = np.arange(20.0, 186.0, 5.0)
    for colour, (name, run) in zip(style.SEQUENCE, runs.items()):
        along = np.array([fitted(run, start, start + 15.0) for start in starts])
        text = label(name, run)
        curves += panels.line_overlay(left, "velocity", [(text, starts + 7.5, along[:, 0], {"color": colour})])
        curves += panels.line_overlay(middle, "radius", [(text, starts + 7.5, along[:, 1], {"color": colour})])
        ends[name] = (groups(run)[2], *fitted(run, FROM, TO), colour)
    same = [end for name, end in ends.items() if name != "W0_halved"]
    squares = np.array([end[0] ** 2 for end in same])
    errors = np.array([100 * (end[1] / VELOCITY - 1) for end in same])
    curves += panels.line_overlay(right, "convergence", [("fit window", squares, errors, {"color": style.GREY, "lw": 0.7})])
    for name, (spacing, velocity, _, colour) in ends.items():
        right.plot(spacing**2, 100 * (velocity / VELOCITY - 1), "s" if name == "W0_halved" else "o", color=colour)
    for axes, value, text in ((left, VELOCITY, "solvability"), (middle, RADIUS, "solvability")):
        axes.axhline(value, color=style.THEORY, lw=1.8, alpha=0.4, label=text)
    right.axhline(0, color=style.THEORY, lw=1.8, alpha=0.4)
    right.axhspan(-3, 3, color=style.GREY, alpha=0.12, lw=0)
    right.text(0.97, 2.8, "3 %: asked at $dx = 0.4\\,W_0$", transform=right.get_yaxis_transform(), ha="right", va="top", fontsize=6)
    left.set(xlabel="tip position ($W_0$)", ylabel="$V d_0/D$", ylim=(0.0145, 0.0175))
    middle.set(xlabel="tip position ($W_0$)", ylabel=r"$\rho/d_0$", ylim=(5.5, 9.0))
    right.set(xlabel="$(dx/W_0)^2$", ylabel="deviation of $V$ (%)", xlim=(0, None))
    middle.legend(*left.get_legend_handles_labels(), loc="upper right", fontsize=6)
    panels.lettered((left, middle, right))
    return figure, curves


FIGURES = {"fig17": figure17}
