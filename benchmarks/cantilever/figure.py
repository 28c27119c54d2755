"""Figs. 4 and 5: the cantilever, its material points, and its centre line against theory and finite elements."""

import numpy as np
from matplotlib import patches, pyplot

import panels
import style


def timoshenko(scene, force, x):
    """Deflection of the centre line in plane strain under an end load `force` (Timoshenko and Goodier)."""
    young, poisson = scene["solid"]["young_modulus"], scene["solid"]["poisson_ratio"]
    length, height = scene["body"][0]["size"]
    inertia = height**3 / 12
    stiffness, ratio = young / (1 - poisson**2), poisson / (1 - poisson)
    bending = (4 + 5 * ratio) * height**2 * x / 4 + (3 * length - x) * x**2
    return force / (6 * stiffness * inertia) * bending


def figure4(results):
    record = results.record("cantilever", "mpm_pf")
    snapshot = record.snapshot("fields", 0.0)
    figure, (top, bottom) = pyplot.subplots(2, 1, figsize=(style.ONE_AND_HALF, 3.1))
    (x0, y0), (length, height) = (record.scene["body"][0][key] for key in ("corner", "size"))
    top.add_patch(patches.Rectangle((x0, y0), length, height, facecolor=style.SOLID_FILL, edgecolor="black", lw=0.8))
    panels.wall(top, (x0 - 0.35, y0 - 0.4), (0.35, height + 0.8))
    top.plot([x0, x0], [y0 - 0.4, y0 + height + 0.4], color="black", lw=0.8)
    end = x0 + length
    top.annotate("", (end, y0), (end, y0 + height), arrowprops={"arrowstyle": "<-", "lw": 1.2})
    top.text(end + 0.12, y0 + height / 2, "$P$", va="center")
    panels.dimension(top, (x0, y0 - 0.6), (end, y0 - 0.6), f"$l = {length:g}$", (0, -0.3))
    panels.dimension(top, (end + 0.7, y0), (end + 0.7, y0 + height), f"$h = {height:g}$", (0.55, 0))
    lower, spacing, shape = panels.background_mesh(record)
    top.set_xlim(lower[0], lower[0] + spacing[0] * shape[1] + 0.6)
    top.set_ylim(y0 - 1.2, y0 + height + 0.6)
    panels.plain(top)
    curve = panels.points_on_mesh(bottom, "points", record, snapshot)
    bottom.set_xlim(top.get_xlim())
    panels.plain(bottom)
    figure.subplots_adjust(0.02, 0.02, 0.98, 0.98, hspace=0.02)
    return figure, [curve]


def figure5(results):
    points, elements = results.records("cantilever", ["mpm_pf", "fe_reference"])
    ours, theirs = points.line("centre line"), elements.line("centre line")
    x = np.linspace(0, points.scene["body"][0]["size"][0], 201)
    figure, axes = pyplot.subplots(figsize=(style.SINGLE, 2.6), layout="constrained")
    curves = panels.line_overlay(
        axes,
        "centre line",
        [
            ("Timoshenko, plane strain", x, timoshenko(points.scene, 100.0, x), {"color": style.THEORY}),
            (
                "finite elements",
                theirs.position[:, 0],
                theirs["displacement_y"],
                {"color": style.FINITE_ELEMENTS, "ls": "--"},
            ),
            (
                "material points",
                ours.position[:, 0],
                ours["displacement_y"],
                {"color": style.MATERIAL_POINTS, "ls": "", "marker": "o", "mfc": "white", "mew": 0.9},
            ),
        ],
    )
    axes.set(xlabel="$x$ (m)", ylabel="vertical displacement (m)", xlim=(0, x[-1]))
    axes.legend(loc="upper left")
    return figure, curves


FIGURES = {"fig4": figure4, "fig5": figure5}
