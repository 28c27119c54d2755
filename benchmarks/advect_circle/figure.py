"""Fig. 1: a circle carried along the diagonal and back."""

import numpy as np
from matplotlib import patches, pyplot

import panels
import style


def figure1(results):
    run = results.record("advect_circle", "mpm_pf")
    body, domain = run.scene["body"][0], run.scene["domain"]
    centre, radius = np.array(body["centre"]), body["radius"]
    half, end = run.scene["clock"]["end"] / 2, run.scene["clock"]["end"]
    figure, axes = pyplot.subplots(2, 2, figsize=(style.ONE_AND_HALF, 5.2), layout="constrained")
    sketch = axes[0, 0]
    far = np.array(domain["size"]) - centre
    for place, dash in ((centre, "-"), (far, "--")):
        sketch.add_patch(patches.Circle(place, radius, fill=False, ls=dash, lw=0.9))
    sketch.annotate("", far, centre, arrowprops={"arrowstyle": "<->", "lw": 0.8})
    curves = []
    entries = (
        (0.0, "initial", {"color": style.THEORY, "lw": 1.6, "alpha": 0.4}),
        (half, "half translation", {"color": style.VARIANT, "lw": 1.0}),
        (end, "full translation", {"color": style.FINITE_ELEMENTS, "lw": 0.9, "ls": (0, (4, 1.5))}),
    )
    for time, name, options in entries:
        curves.append(panels.outlines(axes[0, 1], "contours", name, run.outline("contour", time), **options))
    axes[0, 1].legend(loc="lower right", fontsize=7)
    norm = panels.norm_of([], -1, 1)
    for one, (time, name, _) in zip(axes[1], entries[1:]):
        snapshot = run.snapshot_of("phi", time, "grid")
        drawn, _ = panels.field_map(one, name, name, run, snapshot, "phi", norm)
        exact = patches.Circle(centre if time == end else far, radius, fill=False, ls=":", lw=0.8, color=style.FINITE_ELEMENTS)
        one.add_patch(exact)
        one.set_title(f"$\\phi$ after {name}", fontsize=8)
    sketch.set_title("circle of radius 0.15 and its way", fontsize=8)
    axes[0, 1].set_title("contours $\\phi = 0$", fontsize=8)
    panels.colour_bar(figure, drawn, axes, style.NAMES["phi"], shrink=0.5)
    for one in axes.ravel():
        one.set(xlim=(0, domain["size"][0]), ylim=(0, domain["size"][1]), aspect="equal")
        one.set(xticks=[0, 0.5, 1], yticks=[0, 0.5, 1])
    for one in axes[:, 0]:
        one.set_ylabel("$y$")
    for one in axes[1]:
        one.set_xlabel("$x$")
    panels.lettered(axes)
    return figure, curves


FIGURES = {"fig1": figure1}
