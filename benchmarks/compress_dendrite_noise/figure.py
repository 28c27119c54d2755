"""Figs. 13, 14 and 15: a slender dendrite with side branches under compression, and without it."""

import numpy as np
from matplotlib import pyplot

import claims
import claims_slender
import compression
import panels
import style

FREE = "free"  # the same noise without compression


TIP_RADIUS = 2.08  # over d0, by solvability theory at eps = 0.06 and undercooling 0.55 (Karma & Rappel 1998)


def labels(run, width=170):
    """The two labels that belong to every figure of this case: inertia, and a tip that the mesh does not resolve."""
    radius = TIP_RADIUS * run.scene["growth"]["capillary_length"]
    dx = run.scene["domain"]["size"][0] / run.scene["domain"]["cells"][0]
    resolved = f"tip radius by solvability {radius:.2f} W0 against dx = {dx:g} W0" + (": under-resolved" if radius < 2 * dx else "")
    return "\n".join(filter(None, (compression.verdict(run, width), resolved)))


def figure13(results):
    run = results.record("compress_dendrite_noise", "mpm_pf")
    return compression.field_table(run, (0.0, 0.10, 0.20, 0.30), labels)


def figure14(results):
    """Close-up of the core at 10 %: phi and von Mises stress."""
    run = results.record("compress_dendrite_noise", "mpm_pf")
    time = compression.time_of(run, 0.10)
    figure, axes = pyplot.subplots(1, 2, figsize=(style.ONE_AND_HALF, 2.9), layout="constrained")
    curves = []
    px, py, phi = compression.image_of(run, "phi", time)
    middle = np.array([0.5 * (px[0] + px[-1]), 0.5 * (py[0] + py[-1])])
    reach = 0.23 * (py[-1] - py[0])
    for one, field in zip(axes, ("phi", "von_mises")):
        x, y, values = compression.image_of(run, field, time)
        near = np.ix_(np.abs(y - middle[1]) < reach, np.abs(x - middle[0]) < reach)
        norm = panels.norm_of([values[near]], -1 if field == "phi" else 0, 1)
        drawn = panels.image(one, x, y, values, norm=norm, cmap=style.MAPS[field])
        lines = one.contour(px, py, compression.closed(phi), [0.0], colors="black", linewidths=0.4)
        one.set(xlim=middle[0] + np.array([-reach, reach]), ylim=middle[1] + np.array([-reach, reach]))
        one.set(aspect="equal", xticks=[], yticks=[])
        panels.colour_bar(figure, drawn, one, compression.names_of(run)[field], location="bottom")
    compression.scale_bar(axes[1], run)
    figure.supxlabel(labels(run, 90), fontsize=6.5)
    for segment in lines.allsegs[0]:
        curves.append(panels.Curve("close-up at 10 %", "phi = 0", segment[:, 0], segment[:, 1]))
    return figure, curves


def figure15(results):
    """Contours with (red) and without (black) compression at 10, 20 and 30 %; the right half."""
    run, free = results.records("compress_dendrite_noise", ["mpm_pf", FREE])
    domain = run.scene["domain"]
    lower, size = np.array(domain.get("origin", [0.0, 0.0])), np.array(domain["size"])
    figure, axes = pyplot.subplots(1, 3, figsize=(style.DOUBLE, 3.6), layout="constrained")
    curves = []
    for one, share in zip(axes, (0.10, 0.20, 0.30)):
        time, panel = compression.time_of(run, share), f"{100 * share:g} %"
        for name, which, colour in (("without compression", free, "black"), ("with compression", run, "#c1121f")):
            outline = compression.nearest_outline(which, "contour", time)
            curves.append(panels.outlines(one, panel, name, outline, color=colour, lw=0.7))
        one.set(xlim=(lower[0] + size[0] / 2, lower[0] + size[0]), ylim=(lower[1], lower[1] + size[1]))
        one.set(aspect="equal", xticks=[], yticks=[])
        one.set_title(panel, fontsize=9)
    axes[0].legend(loc="lower right", fontsize=7)
    compression.scale_bar(axes[2], run, "right")
    figure.supxlabel(labels(run), fontsize=6.5)
    return figure, curves


def claims13(results):
    """What the paper says about Figs. 13 to 15, sentence by sentence, beside the figures."""
    title = "Sec. 3 on Figs. 13 to 15, sentence by sentence"
    return claims.draw(claims_slender.of_figures13_to_15(results), pyplot, style, title), []


FIGURES = {"fig13": figure13, "fig14": figure14, "fig15": figure15, "fig15_claims": claims13}
