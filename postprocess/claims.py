"""What Sec. 3 of the paper says about a compressed dendrite, sentence by sentence, against records.

Each claim measures something in a record and says "seen" or "not seen"; where the paper's words are not met and the
record itself shows why, the text after "differs because" says it. claims_table.py prints the tables of the cases' READMEs.
"""

import textwrap
from dataclasses import dataclass

import numpy as np

import compression
import record


@dataclass
class Claim:
    """One sentence, what was found, and the numbers it rests on."""

    sentence: str
    found: str
    measured: str


def judge(sentence, seen, measured, because="", applies=True, said="seen"):
    """A claim; `because` is the reason for not seeing it, said only where the record bears it out (`applies`);
    `said`: of what is seen, with its bounds."""
    why = f"differs because {because}" if because and applies else "not seen"
    return Claim(sentence, said if seen else why, measured)


def scales_of(run):
    """W0 and sigma_Y in the units of the record, whichever they are; fails where its scene has no such thing."""
    scene = run.scene
    width, limit = scene.get("phase_field", {}).get("width"), scene.get("solid", {}).get("yield_stress")
    if not width or not limit:
        raise record.Missing(f"{run.label}: lengths are judged in W0 and stresses in sigma_Y, and its scene lacks phase_field.width or solid.yield_stress")
    return float(width), float(limit)


class Compressed:
    """A compressed dendrite at one compression: its points and, on the grid, its crystal angle (degrees). Lengths in W0, stresses in sigma_Y."""

    def __init__(self, run, share):
        self.share = share
        length, stress = scales_of(run)
        time = compression.time_of(run, share)
        solid = compression.nearest_snapshot(run, "von_mises", time, "points")
        lower = np.array(run.scene["domain"].get("origin", [0.0, 0.0]))
        size = np.array(run.scene["domain"]["size"])
        middle = lower if compression.is_quarter(run) else lower + size / 2
        self.vertex = (solid.vertex - middle) / length
        self.x, self.y = np.abs(self.vertex).T  # one quarter stands for all
        self.inwards = -np.sign(self.vertex[:, 1]) * solid.fields["displacement_y"] / length
        self.von_mises, self.plastic = solid.fields["von_mises"] / stress, solid.fields["plastic_strain"]
        melt = compression.nearest_snapshot(run, "phi", time, "grid")
        self.gx, self.gy = np.meshgrid((melt.x - middle[0]) / length, (melt.y - middle[1]) / length)
        self.inside = melt.fields["phi"] > 0
        angle = melt.fields.get("crystal_angle")
        self.angle = np.zeros_like(self.gx) if angle is None else np.degrees(np.where(self.inside, angle, 0.0))
        self.spacing = (melt.x[1] - melt.x[0]) / length
        self.wall = self.y.max()

    def where(self, condition, value):
        """Mean of a point value where a condition holds; NaN where it never does."""
        return float(value[condition].mean()) if condition.any() else float("nan")

    def centre(self, radius):
        return np.hypot(self.x, self.y) < radius

    def plastic_depth(self, least=0.002):
        """The smallest distance from the horizontal axis at which plastic strain exceeds `least`."""
        flowed = self.plastic > least
        return float(self.y[flowed].min()) if flowed.any() else float("nan")


def near(mask, other, cells):
    """The part of `mask` that lies within so many cells of `other`."""
    grown = other.copy()
    for _ in range(cells):
        padded = np.pad(grown, 1)
        grown = padded[1:-1, 1:-1] | padded[:-2, 1:-1] | padded[2:, 1:-1] | padded[1:-1, :-2] | padded[1:-1, 2:]
    return mask & grown


def on_grid(state, values, least):
    """Nodes beside which some point has a value above `least`."""
    mask = np.zeros_like(state.inside)
    x0, y0 = state.gx[0, 0], state.gy[0, 0]
    chosen = values > least
    for sx in (1, -1):
        for sy in (1, -1):
            i = np.rint((sx * state.x[chosen] - x0) / state.spacing).astype(int)
            j = np.rint((sy * state.y[chosen] - y0) / state.spacing).astype(int)
            there = (i >= 0) & (j >= 0) & (i < mask.shape[1]) & (j < mask.shape[0])
            mask[j[there], i[there]] = True
    return mask


def in_percent(values):
    return ", ".join(f"{100 * v:.1f} %" for v in values)


def listed(values, digits=3):
    return ", ".join(f"{v:.{digits}g}" for v in values)


def of_figure12(results):
    """The claims about Fig. 12, from a folder of records."""
    return of_smooth_dendrite(results.record("compress_dendrite", "mpm_pf"), results.optional("compress_dendrite", "free"))


def of_smooth_dendrite(run, free=None):
    """The claims about Fig. 12 (contact, 5, 10, 15 % compression, no noise); `free`: the same growth without compression."""
    states = [Compressed(run, c) for c in (0.0, 0.05, 0.10, 0.15)]
    return [of_walls(run, 0.15)] + of_flow(states, ahead_of(free, run)) + of_stress(states) + of_turning(states[-1])


def of_walls(run, share):
    """How far walls and tips go from contact on to a compression."""
    length, _ = scales_of(run)
    melt, tip = (next(t for t in map(run.table, run.names("tables")) if column in t.columns) for column in ("wall_top_position", "position"))
    start, end = (compression.time_of(run, c) for c in (0.0, share))
    wall, arm = (abs(np.ptp(np.interp([start, end], t.time, t[column]))) / length for t, column in ((melt, "wall_top_position"), (tip, "position")))
    return judge(
        "the walls move about as fast as the dendrite's tips grow, as the tips of the horizontal arms show",
        0.7 * wall < arm < 1.4 * wall,
        f"from contact to {100 * share:g} % a wall goes {wall:.1f} W0, the horizontal tip {arm:.1f} W0",
    )


def of_flow(states, ahead):
    """Where it flows plastically; `ahead`: how far the horizontal tip has got beyond that without compression, if that is known."""
    _, five, _, last = states
    outer = [float(s.plastic[s.y > 0.5 * s.wall].sum() / max(s.plastic.sum(), 1e-30)) for s in states[1:]]
    arm = five.y > 0.8 * five.wall
    yields = five.where(arm, five.von_mises > 0.99)
    reach = last.x.max()
    side = last.x > 0.5 * reach
    depth = [s.plastic_depth() for s in states[1:]]
    unmoved = not ahead or max(np.abs(ahead[:2])) < 0.5 * five.spacing
    lasts = not ahead or abs(ahead[2]) < 0.5 * five.spacing
    beside = f"; tip ahead of the one without compression by {listed(ahead, 2)} W0 at 5, 10, 15 %" if ahead else ""
    return [
        judge(
            "the deformation for small compressive strains is limited to the vertical arms near the walls",
            outer[0] > 0.95,
            f"at 5 % {100 * outer[0]:.0f} % of the plastic strain lies in the outer half of the arms (10, 15 %: {in_percent(outer[1:])})",
        ),
        judge(
            "in these portions the yield stress is reached",
            yields > 0.3,
            f"at 5 % {100 * yields:.0f} % of the outer fifth of the arm is above 0.99 sigma_Y",
        ),
        judge(
            "the shape of the horizontal arms is unaffected",
            last.plastic[side].max() < 1e-3 and unmoved,
            f"largest plastic strain in their outer half {last.plastic[side].max():.1e}" + beside,
            "the melt that the vertical arms push aside carries the tips along before 10 %",
            not unmoved,
            "seen" if lasts else "seen to 10 %, beyond it the melt that is pushed aside carries the tips along",
        ),
        judge(
            "with increasing compression the plastic regions extend further towards the centre",
            depth[0] >= depth[1] >= depth[2] and depth[2] < depth[0],
            f"plastic strain above 0.2 % down to y = {listed(depth)} W0 at 5, 10, 15 %",
        ),
    ]


def of_stress(states):
    """The core and the layer at the wall."""
    first, last = states[0], states[-1]
    centre = [s.where(s.centre(12.0), s.von_mises) for s in states[1:]]
    layer = last.y > last.wall - 2.0
    below = (last.y < last.wall - 5.0) & (last.y > last.wall - 15.0) & (last.x < last.x[layer].max())
    in_layer, in_column = (last.where(m, last.von_mises < 0.99) for m in (layer, below))
    widths = [(s.x[s.y > s.wall - 2.0].max(), s.x[np.abs(s.y - (s.wall - 10.0)) < 1.0].max()) for s in states[1:]]
    middle = last.x < 0.5 * widths[-1][0]
    in_middle, beside = (last.where(layer & m, last.von_mises < 0.99) for m in (middle, ~middle))
    return [
        judge(
            "the stresses in the centre continually increase",
            centre[1] > 1.01 * centre[0] and centre[2] > 1.01 * centre[1],
            f"von Mises stress within 12 W0 of the centre: {listed(centre)} sigma_Y at 5, 10, 15 %",
            "they rise until the core yields, and no further",
            centre[0] < 0.99 <= centre[2],
        ),
        judge(
            "in the centre the yield stress is not reached at 15 %",
            centre[2] < 0.99,
            f"{centre[2]:.3f} sigma_Y there at 15 %; the contact with the wall is {last.x[layer].max():.0f} W0 wide to either side",
            "the contact with the wall has grown so wide that the arm carries enough to load the core",
            last.x[layer].max() > 2.0 * first.x[first.y > first.wall - 2.0].max(),
        ),
        judge(
            "a thin layer of solid directly adjacent to the walls stays below the yield stress",
            in_layer > 0.9 and in_layer > in_column,
            f"{100 * in_layer:.0f} % of the layer of 2 W0 at the wall is below 0.99 sigma_Y, {100 * in_column:.0f} % of the column 5 to 15 W0 below it",
            "most of it does, but hardly more than of the column below",
            in_layer > max(0.5, in_column),
        ),
        judge(
            "this is attributed to the larger cross-section of the dendrite at the walls",
            all(at_wall > 1.05 * under for at_wall, under in widths),
            f"half-width at the wall and 10 W0 below it: {', '.join(f'{at_wall:.0f} and {under:.0f} W0' for at_wall, under in widths)} at 5, 10, 15 %; "
            f"below 0.99 sigma_Y in the layer at 15 %: {100 * in_middle:.0f} % of its inner half, {100 * beside:.0f} % of its outer",
            "the crystal is narrower at the wall than below it; what stays below the yield stress is the middle of the contact, which the wall holds sideways",
            widths[-1][0] < widths[-1][1] and in_middle > max(0.8, beside),
        ),
    ]


def of_turning(last):
    """Where the crystal angle has changed."""
    turned = np.abs(last.angle) > 10.0
    flowed = on_grid(last, last.plastic, 0.1)
    beside = near(turned, flowed, int(round(2.0 / last.spacing))).sum() / max(turned.sum(), 1)
    on_axis = np.abs(last.angle[:, np.argmin(np.abs(last.gx[0]))]).max()
    return [
        judge(
            "bending occurs primarily in a thin layer at the edges of the regions with large plastic deformations",
            beside > 0.9 and turned.sum() < 0.2 * last.inside.sum(),
            f"more than 10 degrees on {100 * turned.sum() / last.inside.sum():.1f} % of the solid; {100 * beside:.0f} % of it within 2 W0 of plastic strains above 10 %",
        ),
        judge(
            "the centres of the vertical arms do not turn, by symmetry",
            on_axis < 0.02 * np.abs(last.angle).max(),
            f"at most {on_axis:.2g} degrees on the axis, {np.abs(last.angle).max():.0f} elsewhere",
        ),
    ]


def ahead_of(free, run):
    """How far the horizontal tip is beyond that of the same growth without compression, at 5, 10 and 15 %; in W0."""
    if free is None:
        return []
    times = [compression.time_of(run, share) for share in (0.05, 0.10, 0.15)]
    tips, others = run.table("tip"), free.table("tip")
    length, _ = scales_of(run)
    return [float(np.interp(t, tips.time, tips["position"]) - np.interp(t, others.time, others["position"])) / length for t in times]


def markdown(claims):
    """The claims as a table for a README."""
    rows = [(claim.sentence, claim.found, claim.measured) for claim in claims]
    return "".join(f"| {' | '.join(row)} |\n" for row in [("the paper says", "found", "measured"), ("---",) * 3, *rows])


def draw(claims, pyplot, style, title):
    """The claims as a table, so that they stand in the report beside their figure."""
    wrapped = [[fold(c.sentence, 40), fold(c.found, 26), fold(c.measured, 54)] for c in claims]
    lines = [max(cell.count("\n") + 1 for cell in row) for row in wrapped]
    height = 0.155 * (sum(lines) + len(lines)) + 0.6
    figure, axes = pyplot.subplots(figsize=(style.DOUBLE, height))
    axes.set_axis_off()
    table = axes.table(
        [["the paper says", "found", "measured"], *wrapped],
        colWidths=[0.33, 0.2, 0.47],
        cellLoc="left",
        bbox=[0, 0, 1, 1],
        edges="horizontal",
    )
    table.auto_set_font_size(False)
    table.set_fontsize(7.5)
    total = sum(lines) + 2
    for (row, _), cell in table.get_celld().items():
        cell.set_height((lines[row - 1] + 0.6 if row else 1.5) / total)
        cell.set_linewidth(0.4)
    axes.set_title(title, fontsize=9, loc="left")
    return figure


def fold(text, width):
    return "\n".join(textwrap.wrap(text, width))
