"""Fig. 3: a dendrite in a linear shear, its contours and the path of its horizontal tip."""

from fractions import Fraction

import numpy as np
from matplotlib import pyplot

import panels
import record
import style


def shear_rate(run):
    """g of the imposed velocity (0, -g x)."""
    text = run.scene["imposed"]["velocity"][1]
    if not (text.startswith("-") and text.endswith("*x")):
        raise record.Missing(f"{run.label}: the imposed velocity {text} is not -g*x")
    top, bottom = text[1:-2].split("/")
    return float(Fraction(top) / Fraction(bottom))


def tip_path(run):
    """(time, position) of the vertex of each contour that lies farthest to the right."""
    times = run.times("outlines", "contour")
    tips = []
    for time in times:
        vertices = np.vstack(run.outline("contour", time))
        tips.append(vertices[np.argmax(vertices[:, 0])])
    return times, np.array(tips)


def superposed(times, still_x, rate):
    """Path of a tip that grows as it would without shear, along its turned axis, and is swept.

    dx/dt = V cos T, dy/dt = V sin T - g x, with the crystal's angle T = -g t/2 (half the curl).
    """
    fine = np.linspace(times[0], times[-1], 4001)
    speed = np.gradient(np.interp(fine, times, still_x), fine)
    angle = -0.5 * rate * fine
    step = fine[1] - fine[0]

    def integral(velocity):
        return np.concatenate([[0], np.cumsum(0.5 * step * (velocity[1:] + velocity[:-1]))])

    x = still_x[0] + integral(speed * np.cos(angle))
    return x, integral(speed * np.sin(angle) - rate * x)


def figure3(results):
    run, still = results.records("shear_dendrite", ["mpm_pf", "still"])
    rate = shear_rate(run)
    domain = run.scene["domain"]
    lower, size = np.array(domain["origin"]), np.array(domain["size"])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(style.ONE_AND_HALF, 4.2), layout="constrained")
    left.add_patch(pyplot.Rectangle(lower, *size, fill=False, lw=0.8))
    for x in np.linspace(0.15, 0.95, 5) * size[0]:
        left.annotate("", (x, -0.6 * x), (x, 0), arrowprops={"arrowstyle": "->", "lw": 0.7})
    left.plot([0, 0.97 * size[0]], [0, -0.58 * size[0]], color=style.GREY, lw=0.6, ls="--")
    left.text(0.4 * size[0], 0.15 * size[1], "$v_y = -g\\,x$", ha="left")
    left.text(-0.05 * size[0], 0.2 * size[1], "symmetry", rotation=90, va="center", ha="right", fontsize=8)
    left.add_patch(pyplot.Circle((0, 0), run.scene["body"][0]["radius"], color=style.MATERIAL_POINTS))
    left.set(xlim=(-0.2 * size[0], 1.05 * size[0]), ylim=(1.02 * lower[1], 1.02 * (lower[1] + size[1])))
    panels.plain(left)
    curves = []
    for time in run.times("outlines", "contour"):
        curve = run.outline("contour", time)
        curves.append(panels.outlines(right, "contours", f"t = {time:g}", curve, lw=0.45, color=style.GREY, label=None))
    times, tips = tip_path(run)
    still_times, still_tips = tip_path(still)
    path_x, path_y = superposed(still_times, still_tips[:, 0], rate)
    curves += panels.line_overlay(
        right,
        "tip",
        [
            ("tip", *tips.T, {"color": style.MATERIAL_POINTS, "lw": 1.8}),
            ("superposition", path_x, path_y, {"color": style.FINITE_ELEMENTS, "lw": 1, "ls": (0, (4, 1.5))}),
        ],
    )
    right.set(aspect="equal", xlabel="$x/W_0$", ylabel="$y/W_0$", xlim=(0, None))
    right.legend(loc="upper right", fontsize=7)
    panels.lettered((left, right))
    return figure, curves


FIGURES = {"fig3": figure3}
