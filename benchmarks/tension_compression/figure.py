"""Figs. 6 and 7a: the dogbone specimen, its material points, and its stress over one loading cycle."""

from matplotlib import patches, pyplot

import panels
import style

GAUGE_LENGTH, GAUGE_WIDTH = 5.0, 2.0


def stress_strain(record):
    """Nominal strain (grip displacement over gauge length) and stress (force over gauge width)."""
    top, bottom = record.table("top reaction"), record.table("bottom reaction")
    count = min(len(top.time), len(bottom.time))
    strain = (top["displacement_y"][:count] - bottom["displacement_y"][:count]) / GAUGE_LENGTH
    return strain, top["force_y"][:count] / GAUGE_WIDTH


def figure6(results):
    record = results.record("tension_compression", "mpm_pf")
    snapshot = record.snapshot("fields", 0.0)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(style.SINGLE, 2.9))
    for body in record.scene["body"]:
        left.add_patch(patches.Rectangle(body["corner"], *body["size"], facecolor=style.SOLID_FILL, lw=0))
    half = [(0, 1), (0, 0), (4, 0), (4, 1), (3, 1), (3, 6)]
    outline = half + [(4 - x, 7 - y) for x, y in half]
    left.add_patch(patches.Polygon(outline, fill=False, lw=0.8))
    for y, step in ((7.15, 0.7), (-0.15, -0.7)):
        for x in (0.6, 2.0, 3.4):
            left.annotate("", (x, y + step), (x, y), arrowprops={"arrowstyle": "->", "lw": 0.7})
    panels.dimension(left, (0, 6.65), (4, 6.65), "4", (0, -0.32))
    panels.dimension(left, (1, 2.2), (3, 2.2), "2", (0, 0.32))
    panels.dimension(left, (4.35, 6), (4.35, 7), "1", (0.35, 0))
    panels.dimension(left, (4.35, 1), (4.35, 6), "5", (0.35, 0))
    panels.dimension(left, (4.35, 0), (4.35, 1), "1", (0.35, 0))
    curve = panels.points_on_mesh(right, "points", record, snapshot)
    for axes in (left, right):
        axes.set(xlim=(-1, 5.1), ylim=(-1.05, 8.05))
        panels.plain(axes)
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.99, wspace=0.03)
    return figure, [curve]


def figure7a(results):
    points, elements = results.records("tension_compression", ["mpm_pf", "fe_reference"])
    figure, axes = pyplot.subplots(figsize=(style.SINGLE, 2.7), layout="constrained")
    entries = []
    for name, record, options in (
        ("finite elements", elements, {"color": style.FINITE_ELEMENTS, "lw": 1.6}),
        ("material points", points, {"color": style.MATERIAL_POINTS, "lw": 0.9, "ls": (0, (4, 1.5))}),
    ):
        strain, stress = stress_strain(record)
        entries.append((name, 100 * strain, stress / 1e3, options))
    curves = panels.line_overlay(axes, "cycle", entries)
    axes.axhline(0, color=style.GREY, lw=0.4)
    axes.axvline(0, color=style.GREY, lw=0.4)
    axes.set(xlabel="nominal strain (%)", ylabel="nominal stress (kPa)")
    axes.legend(loc="upper left")
    return figure, curves


FIGURES = {"fig6": figure6, "fig7a": figure7a}
