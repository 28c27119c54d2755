"""Fig. 2: a dendrite turned by 45 degrees while it grows, against the same at rest."""

import numpy as np
from matplotlib import pyplot

import panels
import style


def turned_back(curves, angle):
    """Curves turned by -angle about the origin."""
    cos, sin = np.cos(angle), np.sin(angle)
    return [curve @ np.array([[cos, -sin], [sin, cos]]) for curve in curves]


def figure2(results):
    turned, still, frozen = results.records("rotate_dendrite", ["mpm_pf", "at_rest", "angle_frozen"])
    figure, axes = pyplot.subplots(2, 2, figsize=(style.ONE_AND_HALF, 5.2), layout="constrained")
    reach = max(np.abs(curve).max() for curve in still.outline("contour"))
    norm = panels.norm_of([], -1, 1)
    for one, run in zip(axes.ravel(), (still, turned, frozen)):
        last = run.snapshot_of("phi", None, "grid")
        drawn, _ = panels.field_map(one, "phi", "phi", run, last, "phi", norm)
    below = {"color": style.THEORY, "lw": 1.8, "alpha": 0.45}
    rest = panels.outlines(axes[1, 1], "contours", "without rotation", still.outline("contour"), **below)
    back = panels.outlines(
        axes[1, 1],
        "contours",
        "rotated, turned back",
        turned_back(turned.outline("contour"), np.pi / 4),
        color=style.FINITE_ELEMENTS,
        lw=0.8,
    )
    axes[1, 1].legend(loc="center", fontsize=7, handlelength=1.4)
    names = ("at rest", "turned by 45° while growing", "the same, crystal angle frozen", r"contours $\phi = 0$")
    for one, name in zip(axes.ravel(), names):
        one.set_title(name, fontsize=8)
    panels.lettered(axes)
    for one in axes.ravel():
        one.set(xlim=(-1.12 * reach, 1.12 * reach), ylim=(-1.12 * reach, 1.12 * reach), aspect="equal")
    for one in axes[1]:
        one.set_xlabel("$x/W_0$")
    for one in axes[:, 0]:
        one.set_ylabel("$y/W_0$")
    panels.colour_bar(figure, drawn, axes, style.NAMES["phi"], shrink=0.5)
    return figure, [rest, back]


FIGURES = {"fig2": figure2}
