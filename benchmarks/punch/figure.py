"""Prandtl's mechanism under a rough footing: plastic strain in both solvers, and load against settlement."""

import numpy as np
from matplotlib import pyplot

import panels
import style

END = 1.05
SETTLEMENT = "settlement / half width (%)"
PRANDTL = (2 + np.pi) / np.sqrt(3)


def footing(results):
    points, elements = results.records("punch", ["mpm_pf", "fe_reference"])
    runs = (("material points", points), ("finite elements", elements))
    yield_stress = points.scene["solid"]["yield_stress"]
    figure = pyplot.figure(figsize=(style.DOUBLE, 3.2), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=[0.75, 1])
    fields, load = [figure.add_subplot(grid[row, 0]) for row in (0, 1)], figure.add_subplot(grid[:, 1])
    snapshots = [run.snapshot("fields", END) for _, run in runs]
    # The footing's corner is singular in both solvers: it must not set the scale.
    values = np.concatenate([s.fields["plastic_strain"] for s in snapshots])
    norm = panels.norm_of([values], 0.0, np.nanquantile(values, 0.98))
    curves, entries = [], []
    for axes, snapshot, (name, run), options in zip(
        fields,
        snapshots,
        runs,
        ({"color": style.MATERIAL_POINTS}, {"color": style.FINITE_ELEMENTS, "lw": 1.2, "ls": (0, (4, 1.5))}),
    ):
        drawn, curve = panels.field_map(axes, "plastic strain", name, run, snapshot, "plastic_strain", norm)
        curves.append(curve)
        axes.plot([0, 1], [2.74, 2.74], color="black", lw=2)
        axes.set(xlim=(-0.02, 4.02), ylim=(0.15, 2.85))
        axes.set_title(name, fontsize=8)
        axes.set(aspect="equal", yticks=[1, 2], ylabel="$y / B$", xlabel="$x / B$" if axes is fields[-1] else "")
        table = run.table("footing")
        entries.append((name, -100 * table["displacement_y"], -table["force_y"] / yield_stress, options))
    panels.colour_bar(figure, drawn, fields, "equivalent plastic strain", extend="max")
    curves += panels.line_overlay(load, "load", entries)
    load.axhline(PRANDTL, color=style.GREY, lw=0.8, ls=":")
    load.text(0.02, PRANDTL - 0.05, r"Prandtl: $(2+\pi)\,k$", color=style.GREY, va="top", fontsize=8)
    load.set(xlabel=SETTLEMENT, ylabel=r"load / ($\sigma_Y B$)", xlim=(0, None), ylim=(0, None))
    load.legend(loc="lower right", fontsize=7)
    return figure, curves


FIGURES = {"footing": footing}
