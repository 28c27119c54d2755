"""A slender dendrite whose tip the mesh resolves beside that of Figs. 13 to 15, whose tip it does not: where each yields, and how far it has flowed."""

import numpy as np

from claims import Compressed


def measured(state):
    """What is compared of one state: {words: text}."""
    height, yields, flowed = state.wall, state.von_mises > 0.99, state.plastic
    centre, outer, tip = state.centre(0.1 * height), state.y > 0.8 * height, state.x > 0.5 * state.x.max()
    whole = max(flowed.sum(), 1e-30)
    return {
        "mean von Mises stress near the centre, sigma_Y": f"{state.where(centre, state.von_mises):.2f}",
        "above 0.99 sigma_Y near the centre": f"{100 * state.where(centre, yields):.0f} %",
        "above 0.99 sigma_Y of the solid": f"{100 * yields.mean():.1f} %",
        "above 0.99 sigma_Y of the outer fifth of the vertical arms": f"{100 * state.where(outer, yields):.0f} %",
        "plastic strain, 99.9 % quantile": f"{np.quantile(flowed, 0.999):.2f}",
        "part of it in the outer half of the vertical arms": f"{100 * flowed[state.y > 0.5 * height].sum() / whole:.1f} %",
        "part of it in the outer half of the horizontal arms": f"{100 * flowed[tip].sum() / whole:.1f} %",
    }


def table(results):
    """The comparison as Markdown."""
    resolved, paper = results.record("compress_dendrite_slender", "mpm_pf"), results.record("compress_dendrite_noise", "mpm_pf")
    states = (("resolved", resolved, 0.05), ("resolved", resolved, 0.10), ("Figs. 13-15", paper, 0.10), ("Figs. 13-15", paper, 0.20))
    columns = [(f"{name}, {100 * share:g} %", measured(Compressed(run, share))) for name, run, share in states]
    lines = [["", *(head for head, _ in columns)], ["---"] * (1 + len(columns))]
    lines += [[words, *(values[words] for _, values in columns)] for words in columns[0][1]]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)
