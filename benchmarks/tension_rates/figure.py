"""Fig. 7b: stress against strain of the viscoplastic dogbone at three strain rates."""

from matplotlib import lines, pyplot

import panels
import record
import style

GAUGE_LENGTH, GAUGE_WIDTH = 5.0, 2.0
# nominal rate, material-point run, finite-element run
RATES = (
    (r"$10^{-2}$ /s", "mpm_pf", "fe_reference"),
    (r"$5\times10^{-3}$ /s", "mpm_pf_5e-3", "fe_5e-3"),
    (r"$10^{-3}$ /s", "mpm_pf_1e-3", "fe_1e-3"),
)


def stress_strain(run):
    """Nominal strain (grip displacement over gauge length) and stress (force over gauge width)."""
    top, bottom = run.table("top reaction"), run.table("bottom reaction")
    count = min(len(top.time), len(bottom.time))
    strain = (top["displacement_y"][:count] - bottom["displacement_y"][:count]) / GAUGE_LENGTH
    return 100 * strain, top["force_y"][:count] / GAUGE_WIDTH / 1e3


def figure7b(results):
    figure, axes = pyplot.subplots(figsize=(style.SINGLE, 2.7), layout="constrained")
    curves, reasons = [], []
    for (rate, ours, theirs), colour in zip(RATES, style.SEQUENCE):
        try:
            points, elements = results.records("tension_rates", [ours, theirs])
        except record.Missing as reason:
            reasons.append(str(reason))
            continue
        strain, stress = stress_strain(points)
        curves += panels.line_overlay(
            axes,
            rate,
            [
                ("finite elements", *stress_strain(elements), {"color": colour, "lw": 1.5, "alpha": 0.55}),
                ("material points", strain, stress, {"color": colour, "lw": 0.9, "ls": (0, (4, 1.5))}),
            ],
        )
        axes.text(strain[-1] * 0.98, stress[-1] - 2.2, rate, color=colour, ha="right", va="top", fontsize=8)
    if len(curves) < 2 * len(RATES):
        pyplot.close(figure)
        raise record.Missing("three rates are needed: " + "; ".join(reasons))
    axes.set(xlabel="nominal strain (%)", ylabel="nominal stress (kPa)", xlim=(0, None), ylim=(0, None))
    keys = [
        lines.Line2D([], [], color=style.GREY, lw=1.5, alpha=0.55, label="finite elements"),
        lines.Line2D([], [], color=style.GREY, lw=0.9, ls=(0, (4, 1.5)), label="material points"),
    ]
    axes.legend(handles=keys, loc="lower right")
    return figure, curves


FIGURES = {"fig7b": figure7b}
