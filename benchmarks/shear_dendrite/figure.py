"""Fig. 3: a dendrite in a linear shear, its contours and the path of its horizontal tip."""

import re
from fractions import Fraction

import numpy as np
from matplotlib import patches, pyplot

import panels
import record
import style


def shear_rate(run):
    """g of the imposed velocity (0, -g x)."""
    text = str(run.scene.get("imposed", {}).get("velocity", ["", ""])[1])
    found = re.fullmatch(r"-([\d.eE+-]+)(?:/([\d.eE+-]+))?\*x", text.replace(" ", ""))
    try:
        return float(Fraction(found[1]) / Fraction(found[2] or 1))
    except (TypeError, ValueError, ZeroDivisionError):
        raise record.Missing(f"{run.label}: the imposed velocity {text!r} is not -g*x with a number or a fraction g") from None


def tip_path(run, rate=0.0):
    """(times, positions) of the tip: where the contour reaches farthest along the turned crystal axis.

    The extreme of a parabola through the vertices within 2 W0 of the farthest one: vertices lie on mesh lines.
    """
    times = run.times("outlines", "contour")
    tips = []
    for time in times:
        axis = np.array([np.cos(0.5 * rate * time), -np.sin(0.5 * rate * time)])
        across = np.array([-axis[1], axis[0]])
        vertices = np.vstack(run.outline("contour", time))
        along, aside = vertices @ axis, vertices @ across
        far = np.argmax(along)
        near = np.linalg.norm(vertices - vertices[far], axis=1) < 2.0
        bend, slope, top = np.polyfit(aside[near] - aside[far], along[near], 2)
        shift = -slope / (2 * bend)
        tips.append((top - slope**2 / (4 * bend)) * axis + (aside[far] + shift) * across)
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
    left.text(0.45 * size[0], 0.08 * size[1], "$v_x = 0,\\;\\; v_y = -g\\,x$", ha="left")
    left.text(-0.05 * size[0], 0.2 * size[1], "symmetry", rotation=90, va="center", ha="right", fontsize=8)
    left.add_patch(patches.Wedge((0, 0), run.scene["body"][0]["radius"], -90, 90, color=style.MATERIAL_POINTS))
    left.text(0.12 * size[0], 0.04 * size[1], "seed", fontsize=8)
    left.set(xlim=(-0.2 * size[0], 1.05 * size[0]), ylim=(1.02 * lower[1], 1.02 * (lower[1] + size[1])))
    panels.plain(left)
    curves = []
    for time in run.times("outlines", "contour"):
        curve = run.outline("contour", time)
        curves.append(panels.outlines(right, "contours", f"t = {time:g}", curve, lw=0.45, color=style.GREY, label=None))
    times, tips = tip_path(run, rate)
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
