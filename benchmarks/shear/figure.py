"""Figs. 8, 9 and 10: the bar sheared by 40 %, its fields beside finite elements, its line probe and its shape."""

import numpy as np
from matplotlib import patches, pyplot

import panels
import record
import style

END = 1.025  # when the ends have moved by +-0.4
BOUNDARIES = ("contour", "outline")  # phi = 0 where the scene advects phi, else the tracers of the outline


def bar(run):
    body = run.scene["body"][0]
    return np.array(body["corner"]), np.array(body["size"])


def marked(results, run):
    """The same bar with phi as the marker of its boundary, where that was run: the paper's Figs. 8 and 10b; else the run itself."""
    return results.optional("shear_marker", "mpm_pf") or run


def initial_boundary(axes, run):
    """Contours of the first phi, or the first outline where the scene has no phase field."""
    try:
        first = run.snapshot_of("phi", 0.0, "grid")
    except record.Missing:
        name, curves = run.outline_of(BOUNDARIES, 0.0)
        axes.set_title(f"initial {name}", fontsize=9)
        return [panels.outlines(axes, "initial boundary", name, curves, lw=0.9, color=style.MATERIAL_POINTS)]
    levels = axes.contour(first.x, first.y, first.fields["phi"], np.linspace(-0.9, 0.9, 7), linewidths=0.7, cmap="viridis")
    axes.set_title(r"initial $\phi$ on the background mesh", fontsize=9)
    bar = panels.colour_bar(axes.figure, levels, axes, r"$\phi$", shrink=0.75)
    bar.set_ticks(levels.levels)
    bar.lines[0].set_linewidth(3)
    return [
        panels.Curve("initial boundary", f"phi = {level:.1f}", *segment.T)
        for level, segments in zip(levels.levels, levels.allsegs)
        for segment in segments
        if len(segment)
    ]


def figure8(results):
    run = results.record("shear", "mpm_pf")
    (x0, y0), (width, height) = bar(run)
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.2), layout="constrained")
    left.add_patch(patches.Rectangle((x0, y0), width, height, facecolor=style.SOLID_FILL, edgecolor="black", lw=0.8))
    shift = 0.2 * height
    sheared = [(x0 - shift, y0), (x0 + width - shift, y0), (x0 + width + shift, y0 + height), (x0 + shift, y0 + height)]
    left.add_patch(patches.Polygon(sheared, fill=False, ls="--", lw=0.7, edgecolor=style.GREY))
    for y, way in ((y0 + height + 0.12, 1), (y0 - 0.12, -1)):
        start = x0 + width / 2 - way * 0.35
        left.annotate("", (start + way * 0.7, y), (start, y), arrowprops={"arrowstyle": "->", "lw": 1})
    panels.dimension(left, (x0, y0 + 0.35 * height), (x0 + width, y0 + 0.35 * height), "$L$", (0, 0.13))
    panels.dimension(left, (x0 - 0.75, y0), (x0 - 0.75, y0 + height), f"{height / width:g} $L$", (-0.25, 0))
    with_phi = marked(results, run)
    lower, spacing, shape = panels.background_mesh(with_phi)
    panels.mesh_lines(right, lower, spacing, shape, linewidths=0.12)
    curves = initial_boundary(right, with_phi)
    for axes in (left, right):
        axes.set(
            xlim=(lower[0], lower[0] + spacing[0] * shape[1]),
            ylim=(lower[1] - 0.15, lower[1] + spacing[1] * shape[0] + 0.15),
        )
        panels.plain(axes)
    panels.lettered((left, right))
    return figure, curves


def figure9(results):
    points, elements = results.records("shear", ["mpm_pf", "fe_reference"])
    runs = (("material points", points), ("finite elements", elements))
    snapshots = {name: run.snapshot("fields", END) for name, run in runs}
    clip = points.outline("outline", END)
    figure, axes = pyplot.subplots(2, 2, figsize=(style.ONE_AND_HALF, 5.2), layout="constrained")
    curves = []
    for row, (field, factor, label) in zip(
        axes, (("von_mises", 1e-6, "von Mises stress (MPa)"), ("plastic_strain", 1.0, "equivalent plastic strain"))
    ):
        values = np.concatenate([s.fields[field] for s in snapshots.values()]) * factor
        # The clamped corners are singular in both solvers: they must not set the scale of the strain.
        top = points.scene["solid"]["yield_stress"] * factor if field == "von_mises" else np.nanquantile(values, 0.98)
        norm = panels.norm_of([values], 0.0, top)
        for one, (name, run) in zip(row, runs):
            own_clip = clip if snapshots[name].kind == "points" else None
            drawn, curve = panels.field_map(one, label, name, run, snapshots[name], field, norm, own_clip, factor)
            curves.append(curve)
            one.set_title(name if field == "von_mises" else "", fontsize=9)
            one.set(xlim=(1.45, 3.55), ylim=(0.1, 2.3))
            panels.plain(one)
        above = np.nanmax(values) > top * (1 + 1e-6)
        panels.colour_bar(figure, drawn, row, label, extend="max" if above else "neither")
    y = points.scene["domain"]["size"][1] / 2
    for one in axes[0]:  # the line of Fig. 10a
        one.plot([1.5, 3.5], [y, y], color="black", lw=0.7, ls=(0, (5, 2)))
    return figure, curves


def figure10(results):
    points, elements = results.records("shear", ["mpm_pf", "fe_reference"])
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.9), layout="constrained")
    entries = []
    for name, run, options in (
        ("finite elements", elements, {"color": style.FINITE_ELEMENTS, "lw": 1.4}),
        ("material points", points, {"color": style.MATERIAL_POINTS, "marker": "o", "ms": 3.5, "mfc": "none", "mew": 0.8, "ls": "none"}),
    ):
        line = run.line("sampling line", END)
        entries.append((name, line.position[:, 0], line["von_mises"] / 1e6, options))
    curves = panels.line_overlay(left, "von Mises stress on the sampling line", entries)
    left.set(xlabel="$x/L$", ylabel="von Mises stress (MPa)", ylim=(0, None))
    left.legend(loc="lower center")
    label = {"contour": r"material points, $\phi = 0$", "outline": "material points, tracers"}
    theirs = elements.outline("outline", END)
    curves.append(panels.outlines(right, "shape", "finite elements", theirs, color=style.FINITE_ELEMENTS, lw=1.4))
    name, ours = marked(results, points).outline_of(BOUNDARIES, END)
    dashes = {"color": style.MATERIAL_POINTS, "lw": 0.9, "ls": (0, (4, 1.5))}
    curves.append(panels.outlines(right, "shape", label[name], ours, **dashes))
    right.set(xlabel="$x/L$", ylabel="$y/L$", aspect="equal", xlim=(0.9, 4.1), ylim=(0, 2.4))
    right.legend(loc="upper left", fontsize=7)
    panels.lettered((left, right))
    return figure, curves


FIGURES = {"fig8": figure8, "fig9": figure9, "fig10": figure10}
