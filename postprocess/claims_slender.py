"""What Sec. 3 says about the slender dendrite with side branches (Figs. 13-15), against records."""

import numpy as np

import compression
from claims import Claim, Compressed, judge, listed, scales_of


def half_widths(curves, middle, levels):
    """Distance from the vertical axis to the outermost contour at some heights above and below the middle; mean of the four quarters."""
    found = []
    for level in levels:
        reach = []
        for side in (1, -1):
            for curve in curves:
                x, y = (curve - middle).T
                y = y * side - level
                cross = np.nonzero(y * np.roll(y, -1) < 0)[0]
                share = y[cross] / (y[cross] - np.roll(y, -1)[cross])
                reach += list(np.abs(x[cross] + share * (np.roll(x, -1)[cross] - x[cross])))
        found.append(max(reach) if reach else np.nan)
    return np.array(found)


def of_figures13_to_15(results):
    """The claims about Figs. 13 to 15, from a folder of records."""
    run, free = results.records("compress_dendrite_noise", ["mpm_pf", "free"])
    return of_slender_dendrite(run, free, results.optional("compress_dendrite", "mpm_pf"))


def of_slender_dendrite(run, free, smooth=None):
    """The claims about Figs. 13 to 15 (contact, 10, 20, 30 % compression); `smooth`: the run of Fig. 12."""
    states = [Compressed(run, c) for c in (0.0, 0.10, 0.20, 0.30)]
    return of_shape(run, free, states) + of_flow(states, smooth) + of_stress(states)


def of_shape(run, free, states):
    """Necks, stresses in them, and the arms beside those of the run without compression."""
    contact, ten, _, _ = states
    size = np.array(run.scene["domain"]["size"])
    lower = np.array(run.scene["domain"].get("origin", [0.0, 0.0]))
    middle = lower if compression.is_quarter(run) else lower + size / 2

    length, _ = scales_of(run)

    def widths(which, share, at):
        curves = compression.nearest_outline(which, "contour", compression.time_of(run, share))
        return half_widths([curve / length for curve in curves], middle / length, at)

    height = contact.wall
    levels = np.linspace(0.1, 0.9, 33) * height
    at_contact = widths(run, 0.0, levels)
    neck = int(np.nanargmin(at_contact[:20]))
    core = np.nanmax(at_contact[: max(neck, 1)])
    around_neck = np.abs(ten.y - levels[neck]) < 0.12 * height
    rim = ten.x > 0.75 * np.interp(ten.y, levels, widths(run, 0.10, levels))
    at_rim, inside = (ten.where(around_neck & m, ten.von_mises > 0.99) for m in (rim, ~rim))
    upper = np.linspace(0.4, 0.6, 9) * height
    with_walls, without = (np.nanmean(widths(r, 0.30, upper)) for r in (run, free))
    return [
        judge(
            "a more slender structure with small side branches; the necks between core and arms are thin",
            at_contact[neck] < 0.5 * core,
            f"half-width of the neck {at_contact[neck]:.1f} W0 at y = {levels[neck]:.0f} W0, of the core {core:.1f} W0",
        ),
        judge(
            "at 10 % small regions near the interface in the necks have reached the yield stress, the inner parts are elastic",
            at_rim > inside,
            f"above 0.99 sigma_Y: {100 * at_rim:.0f} % of the outer quarter of the neck, {100 * inside:.0f} % of its inside",
            "a band through the neck yields as well as its rim",
            inside > 0.02,
        ),
        judge(
            "compression makes the vertical arms appear much thicker than without",
            with_walls > 1.1 * without,
            f"mean half-width at 40 to 60 % of the height: {with_walls:.1f} W0, without compression {without:.1f} W0",
        ),
    ]


def of_flow(states, smooth):
    """Plastic strains and crystal angles, beside those of Fig. 12 where its run is at hand."""
    _, ten, twenty, thirty = states
    near_wall = thirty.y > 0.7 * thirty.wall
    strains = [float(np.quantile(s.plastic, 0.999)) for s in (ten, twenty, thirty)]
    turned = [float(np.quantile(np.abs(s.angle[s.inside]), 0.999)) for s in (ten, twenty, thirty)]
    return [
        beside_smooth(strains, turned, smooth),
        judge(
            "plastic strains in excess of 100 % occur near the moving walls",
            thirty.plastic[near_wall].max() > 1.0,
            f"up to {100 * thirty.plastic[near_wall].max():.0f} % there at 30 %, {100 * ten.plastic.max():.0f} % at 10 %",
        ),
    ]


def beside_smooth(strains, turned, smooth):
    """Each at the end of its figure, 30 % here and 15 % in Fig. 12: at least twice as large counts as much larger."""
    sentence = "plastic strains and angle changes are much larger than in Fig. 12"
    measured = f"99.9 % quantiles at 10, 20, 30 %: {listed(strains, 2)} and {listed(turned)} degrees"
    if smooth is None:
        return Claim(sentence, "not judged: Fig. 12's run is not at hand", measured)
    other = Compressed(smooth, 0.15)
    strain, angle = np.quantile(other.plastic, 0.999), np.quantile(np.abs(other.angle[other.inside]), 0.999)
    return judge(
        sentence,
        strains[2] > 2.0 * strain and turned[2] > 2.0 * angle,
        f"{measured}; Fig. 12 at 15 %: {strain:.2g} and {angle:.0f} degrees",
        f"at the end they are {strains[2] / strain:.1f} and {turned[2] / angle:.1f} times as large, at twice the compression",
        strains[2] > strain and turned[2] > angle,
    )


def of_stress(states):
    """The core and the horizontal arms."""
    _, ten, twenty, thirty = states
    height = states[0].wall
    core_yield = [s.where(s.centre(0.1 * height), s.von_mises > 0.99) for s in (ten, twenty, thirty)]
    across = [
        s.where((s.x > 0.35 * height) & (s.y < 0.15 * height), s.von_mises) for s in (ten, twenty, thirty)
    ]
    return [
        judge(
            "at 20 % the centre starts to yield",
            core_yield[1] > core_yield[0],
            f"above 0.99 sigma_Y near the centre at 10, 20, 30 %: {', '.join(f'{100 * c:.0f} %' for c in core_yield)}",
        ),
        judge(
            "at 30 % elastic stresses propagate into the horizontal arms",
            across[2] > across[0],
            f"mean von Mises stress there at 10, 20, 30 %: {listed(across, 2)} sigma_Y",
        ),
    ]
