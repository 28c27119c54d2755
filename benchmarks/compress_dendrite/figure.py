"""Figs. 11 and 12: a dendrite between walls that close in, without noise."""

import numpy as np
from matplotlib import patches, pyplot

import asymmetry
import claims
import compression
import panels
import style

FLOOR = 1e-16  # differences below it are drawn here, so that a logarithmic axis can show that there are none


def figure11(results):
    run = results.record("compress_dendrite", "mpm_pf")
    width, height = run.scene["domain"]["size"]
    if compression.is_quarter(run):
        width, height = 2 * width, 2 * height
    spacing = panels.background_mesh(run)[1]
    figure, axes = pyplot.subplots(figsize=(style.SINGLE, 2.6))
    axes.add_patch(patches.Rectangle((-width / 2, -height / 2), width, height, fill=False, lw=0.9))
    seed = run.scene["body"][0]["radius"]
    for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        shape = {"width": 3, "head_width": 9, "head_length": 12, "color": style.MATERIAL_POINTS}
        axes.add_patch(patches.FancyArrow(1.5 * seed * dx, 1.5 * seed * dy, 0.2 * height * dx, 0.2 * height * dy, **shape))
    axes.add_patch(patches.Circle((0, 0), seed, facecolor=style.SOLID_FILL, edgecolor="black", lw=0.7, zorder=3))
    axes.text(2 * seed, 2 * seed, "seed, grows\nalong its axes", va="bottom", fontsize=8)
    for side in (1, -1):
        panels.wall(axes, (-width / 2, side * height / 2 - (0.05 * height if side < 0 else 0)), (width, 0.05 * height))
        for x in (-0.42 * width, 0.42 * width):
            start = (x, side * 0.49 * height)
            axes.annotate("", (x, side * 0.33 * height), start, arrowprops={"arrowstyle": "->", "lw": 1})
        axes.text(0, side * 0.62 * height, "moving wall, adiabatic", ha="center", va="center", fontsize=8)
    melt = f"undercooled melt, $\\theta = -{run.scene['heat']['undercooling']:g}$"
    axes.text(0, -0.41 * height, melt, ha="center", va="center", fontsize=8)
    for side in (1, -1):
        axes.text(side * 0.53 * width, 0, "adiabatic", rotation=90, ha="center", va="center", fontsize=8)
    panels.dimension(axes, (-width / 2, -0.76 * height), (width / 2, -0.76 * height), f"{width:g} $W_0$: {width / spacing[0]:.0f} cells", (0, -0.07 * height))
    panels.dimension(axes, (0.6 * width, -height / 2), (0.6 * width, height / 2), "", (0, 0))
    axes.text(0.645 * width, 0, f"{height:g} $W_0$: {height / spacing[1]:.0f} cells", rotation=90, ha="center", va="center")
    axes.set(xlim=(-0.6 * width, 0.7 * width), ylim=(-0.9 * height, 0.7 * height))
    panels.plain(axes)
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.99)
    return figure, []


def figure12(results):
    run = results.record("compress_dendrite", "mpm_pf")
    return compression.field_table(run, (0.0, 0.05, 0.10, 0.15))


def claims12(results):
    """What the paper says about Fig. 12, sentence by sentence, beside the figure."""
    return claims.draw(claims.of_figure12(results), pyplot, style, "Sec. 3 on Fig. 12, sentence by sentence"), []


def asymmetry12(results):
    """How symmetry is lost: the run of the whole domain against its own images, at each recorded compression."""
    run = results.record("compress_dendrite", "whole")
    times = run.times("outlines", "contour")
    melt = next(table for table in map(run.table, run.names("tables")) if "compression" in table.columns)
    percent = 100 * np.interp(times, melt.time, melt["compression"])
    measured = (
        ("contour", asymmetry.of_contour, r"largest distance / $\Delta x$", 0.05),
        ("von Mises stress", asymmetry.of_stress, r"rms difference / $\sigma_Y$", 0.01),
    )
    figure, axes = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.5), layout="constrained")
    curves = []
    for one, (panel, measure, label, limit) in zip(axes, measured):
        found = [measure(run, time) for time in times]
        for colour, mark, name in zip(style.SEQUENCE, ("o-", "s-", "^--"), asymmetry.IMAGES):
            values = np.array([f[name] for f in found])
            one.plot(percent, np.maximum(values, FLOOR), mark, color=colour, mfc="none", ms=4.5, label=name)
            curves.append(panels.Curve(panel, name, percent, values))
        one.axhline(limit, color=style.GREY, lw=0.7, ls="--", label="asked of the mirrors")
        one.set(yscale="log", xlabel="compression / %", ylabel=label, title=panel, ylim=(FLOOR / 3, 1))
    axes[0].legend(loc="center right", bbox_to_anchor=(1.0, 0.69), title=f"{run.scene['domain']['cells'][0]} cells across")
    return figure, curves


FIGURES = {"fig11": figure11, "fig12": figure12, "fig12_claims": claims12, "fig12_asymmetry": asymmetry12}
