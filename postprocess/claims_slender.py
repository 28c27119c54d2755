"""What Sec. 3 says about the slender dendrite with side branches (Figs. 13-15), against records."""

import numpy as np

import compression
from claims import Claim, Compressed, judge, listed, near, of_walls, on_grid, scales_of

QUARTERS = [(1, 1), (-1, 1), (1, -1), (-1, -1)]
NEAR = 4.0  # W0: what is so near to a place of the contour counts as at it


def half_widths(curves, levels, signs):
    """In one quarter, the distance from the vertical axis to the outermost contour at some heights; NaN where there is none.

    Curves (n, 2) about the dendrite's middle."""
    found = np.full(len(levels), np.nan)
    for curve in curves:
        x, y = (curve * signs).T
        next_x, next_y = np.roll(x, -1), np.roll(y, -1)
        for k, level in enumerate(levels):
            cross = np.nonzero((y - level) * (next_y - level) < 0)[0]
            reach = x[cross] + (level - y[cross]) / (next_y[cross] - y[cross]) * (next_x[cross] - x[cross])
            reach = reach[reach > 0]
            if len(reach):
                found[k] = np.fmax(found[k], reach.max())
    return found


def turns(values, least):
    """Indices at which a sequence turns by more than `least`: (valleys, bumps). Its ends count as neither; NaN are passed over."""
    found = {1: [], -1: []}
    known = np.nonzero(~np.isnan(values))[0]
    way, extreme = 0, known[0] if len(known) else 0
    for k in known:
        change = values[k] - values[extreme]
        if way == 0:
            if abs(change) > least:
                way, extreme = np.sign(change), k
        elif way * change > 0:
            extreme = k
        elif way * change < -least:
            found[way].append(extreme)
            way, extreme = -way, k
    return found[-1], found[1]


class Arms:
    """The contour of a run when it, or another run, is compressed so far: half-widths of its vertical arms. Lengths in W0 about the middle."""

    def __init__(self, run, share, other=None):
        length, _ = scales_of(run)
        lower = np.array(run.scene["domain"].get("origin", [0.0, 0.0]))
        size = np.array(run.scene["domain"]["size"])
        quarter = compression.is_quarter(run)
        middle = lower if quarter else lower + size / 2
        curves = compression.nearest_outline(run, "contour", compression.time_of(other or run, share))
        self.curves = [(curve - middle) / length for curve in curves]
        self.quarters = QUARTERS[:1] if quarter else QUARTERS

    def widest(self, levels):
        """The largest of the quarters."""
        return np.fmax.reduce([half_widths(self.curves, levels, signs) for signs in self.quarters])


def of_figures13_to_15(results):
    """The claims about Figs. 13 to 15, from a folder of records."""
    run, free = results.records("compress_dendrite_noise", ["mpm_pf", "free"])
    return of_slender_dendrite(run, free, results.optional("compress_dendrite", "mpm_pf"))


def of_slender_dendrite(run, free, smooth=None):
    """The claims about Figs. 13 to 15 (contact, 10, 20, 30 % compression); `smooth`: the run of Fig. 12."""
    states = [Compressed(run, c) for c in (0.0, 0.10, 0.20, 0.30)]
    return [of_structure(run, states[0], smooth), of_walls(run, 0.30)] + of_flow(states, smooth) + of_necks(run, states) + of_stress(states) + of_mass(run, free, states)


def of_structure(run, contact, smooth):
    """Necks between core and arms beside those of Fig. 12, and side branches."""
    sentence = "a more slender structure with small side branches; the necks between core and arms are much thinner"
    levels = np.linspace(0.1, 0.9, 161) * contact.wall
    arms = Arms(run, 0.0)
    neck = np.nanmin(arms.widest(levels[: len(levels) // 2]))
    branches = [len(turns(half_widths(arms.curves, levels, signs), 1.0)[1]) for signs in arms.quarters]
    measured = f"half-width of the neck {neck:.1f} W0; bumps of more than 1 W0 on each flank of the vertical arms: {listed(branches)}"
    if smooth is None:
        return Claim(sentence, "not judged: Fig. 12's run is not at hand", measured)
    other = np.nanmin(Arms(smooth, 0.0).widest(np.linspace(0.1, 0.5, 81) * Compressed(smooth, 0.0).wall))
    return judge(sentence, neck < 0.75 * other and max(branches) > 0, f"{measured}; the neck of Fig. 12: {other:.1f} W0")


def of_necks(run, states):
    """Stresses at the necks and in the valleys between side branches at 10 %."""
    ten = states[1]
    arms = Arms(run, 0.10)
    valleys, bumps = valleys_and_bumps(arms, ten)
    at_rim, inside, mean, beside = np.transpose([around_neck(arms, ten, signs) for signs in arms.quarters])
    return [
        judge(
            "at 10 % small stress concentrations in the valleys between the side branches and at the necks",
            valleys > 1.15 * bumps and np.nanmean(mean) > 1.15 * np.nanmean(beside),
            f"mean von Mises stress within {NEAR:g} W0 of the contour: {valleys:.2g} sigma_Y in valleys, {bumps:.2g} sigma_Y on bumps; "
            f"{np.nanmean(mean):.2g} sigma_Y at the necks, {np.nanmean(beside):.2g} sigma_Y 15 W0 above and below them",
        ),
        judge(
            "at 10 % small regions near the interface in the necks have reached the yield stress, the inner parts are elastic",
            np.nanmax(at_rim) > 0.05 and np.nanmax(inside) < 0.02,
            f"above 0.99 sigma_Y within {NEAR:g} W0 of the contour at the {len(arms.quarters)} necks: {listed(100 * at_rim, 2)} %; in the inner half of a neck at most {100 * np.nanmax(inside):.2g} %",
            "the inside of the necks yields as well as their rim",
            np.nanmax(at_rim) > 0.05 and np.nanmax(inside) > 0.02,
        ),
    ]


def around_neck(arms, state, signs):
    """In one quarter, where the vertical arm is narrowest below half its height: the parts above 0.99 sigma_Y within NEAR of the contour and in the
    inner half there, and the mean stress within NEAR of the contour there and 15 W0 above and below."""
    levels = np.arange(0.1 * state.wall, 0.9 * state.wall, 1.0)
    widths = half_widths(arms.curves, levels, signs)
    neck = int(np.nanargmin(np.where(levels < 0.5 * state.wall, widths, np.inf)))
    x, y = (state.vertex * signs).T

    def rim(k):
        return np.hypot(x - widths[k], y - levels[k]) < NEAR

    inner = (np.abs(y - levels[neck]) < NEAR) & (np.abs(x) < 0.5 * widths[neck])
    beside = [state.where(rim(k), state.von_mises) for k in (max(neck - 15, 0), neck + 15)]
    yields = state.von_mises > 0.99
    return state.where(rim(neck), yields), state.where(inner, yields), state.where(rim(neck), state.von_mises), float(np.mean(beside))


def valleys_and_bumps(arms, state, least=1.0):
    """Mean von Mises stress beside the valleys and the bumps of the vertical arms' flanks."""
    levels = np.arange(0.1 * state.wall, 0.9 * state.wall, 1.0)
    means = ([], [])
    for signs in arms.quarters:
        widths = half_widths(arms.curves, levels, signs)
        for found, mean in zip(turns(widths, least), means):
            for k in found:
                at = np.array(signs) * (widths[k], levels[k])
                mean.append(state.where(np.hypot(*(state.vertex - at).T) < NEAR, state.von_mises))
    return [float(np.nanmean(m)) if m else float("nan") for m in means]


def of_flow(states, smooth):
    """Plastic strains and crystal angles, beside those of Fig. 12 where its run is at hand."""
    _, ten, twenty, thirty = states
    near_wall = thirty.y > 0.7 * thirty.wall
    strains = [float(np.quantile(s.plastic, 0.999)) for s in (ten, twenty, thirty)]
    turned = [float(np.quantile(np.abs(s.angle[s.inside]), 0.999)) for s in (ten, twenty, thirty)]
    outer = float(ten.plastic[ten.y > 0.5 * ten.wall].sum() / max(ten.plastic.sum(), 1e-30))
    depth = [s.plastic_depth() for s in (ten, twenty, thirty)]
    bent = np.abs(thirty.angle) > 10.0
    beside = near(bent, on_grid(thirty, thirty.plastic, 0.1), int(round(2.0 / thirty.spacing))).sum() / max(bent.sum(), 1)
    return [
        judge(
            "the fields follow generally the same trends as in Fig. 12",
            outer > 0.75 and depth[0] >= depth[1] >= depth[2] and beside > 0.9,
            f"at 10 % {100 * outer:.0f} % of the plastic strain lies in the outer half of the arms, at 10, 20, 30 % it reaches down to y = {listed(depth)} W0; "
            f"at 30 % {100 * beside:.0f} % of what has turned lies within 2 W0 of plastic strains above 10 %",
        ),
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
    flowed = twenty.where(twenty.centre(0.1 * height), twenty.plastic)
    across = [
        s.where((s.x > 0.35 * height) & (s.y < 0.15 * height), s.von_mises) for s in (ten, twenty, thirty)
    ]
    return [
        judge(
            "at 20 % the centre is starting to yield",
            core_yield[0] < 0.5 and core_yield[0] < core_yield[1] and flowed < 0.01,
            f"above 0.99 sigma_Y within a tenth of the height of the centre at 10, 20, 30 %: {', '.join(f'{100 * c:.0f} %' for c in core_yield)}; plastic strain there at 20 %: {flowed:.1g}",
            said="seen: all of it has reached the yield stress, and has hardly flowed" if core_yield[1] > 0.9 else "seen",
        ),
        judge(
            "at 30 % elastic stresses propagate into the horizontal arms",
            across[2] > across[0],
            f"mean von Mises stress there at 10, 20, 30 %: {listed(across, 2)} sigma_Y",
        ),
    ]


def of_mass(run, free, states):
    """The arms beside those of the run without compression, and what the walls have pushed inwards."""
    height, thirty = states[0].wall, states[3]
    upper = np.linspace(0.4, 0.6, 9) * height
    arms = [Arms(one, 0.30, run) for one in (run, free)]
    with_walls, without = (np.nanmean([half_widths(one.curves, upper, signs) for signs in one.quarters]) for one in arms)
    pushed = float(np.mean(thirty.inwards > 0.1 * (height - thirty.wall)))
    return [
        judge(
            "compression makes the vertical arms appear much thicker than without",
            with_walls > 1.1 * without,
            f"mean half-width at 40 to 60 % of the height: {with_walls:.1f} W0, without compression {without:.1f} W0",
        ),
        judge(
            "due to the movement of the walls, a large amount of solid mass is advected inwards",
            pushed > 0.2,
            f"at 30 % {100 * pushed:.0f} % of the material points have come inwards by more than a tenth of the walls' way, {thirty.inwards.max():.0f} W0 at most",
        ),
    ]
