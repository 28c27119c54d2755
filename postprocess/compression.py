"""What the figures of a compressed dendrite share: when a compression is reached, and the field tables."""

import textwrap

import numpy as np
from matplotlib import pyplot

import panels
import record
import style

FIELDS = ("phi", "von_mises", "plastic_strain", "crystal_angle")


def time_of(run, compression):
    """When a table's column "compression" first reaches `compression` (a fraction; 0: first contact)."""
    for name in run.names("tables"):
        table = run.table(name)
        if "compression" not in table.columns:
            continue
        moving = np.nonzero(table["compression"] > 0)[0]
        reached = np.nonzero(table["compression"] >= compression * (1 - 1e-9))[0]
        if len(moving) == 0 or len(reached) == 0:
            raise record.Missing(f"{run.label}: the compression never reaches {100 * compression:g} %")
        return float(table.time[moving[0] if compression == 0 else reached[0]])
    raise record.Missing(f'{run.label}: no table has a column "compression"')


def nearest_snapshot(run, field, time, kind=None):
    """The snapshot with `field` nearest to `time`; fails if it is farther than 1 % of the run."""
    best = None
    for name in run.names("snapshots"):
        times = run.times("snapshots", name)
        snapshot = run.snapshot(name, times[np.argmin(np.abs(times - time))])
        if field in snapshot.fields and kind in (None, snapshot.kind):
            if best is None or abs(snapshot.time - time) < abs(best.time - time):
                best = snapshot
    if best is None or abs(best.time - time) > 0.01 * time:
        raise record.Missing(f"{run.label}: no snapshot of {field} near t = {time:g}")
    return best


def nearest_outline(run, name, time):
    times = run.times("outlines", name)
    index = int(np.argmin(np.abs(times - time)))
    if abs(times[index] - time) > 0.015 * time:
        raise record.Missing(f"{run.label}: no outline {name} near t = {time:g}")
    return run.outline(name, times[index])


def is_quarter(run):
    """Does the scene compute one quarter, with its corner at the seed's centre?"""
    corner = list(run.scene["domain"].get("origin", [0.0, 0.0]))
    return corner == [0.0, 0.0] == list(run.scene["body"][0]["centre"])


def names_of(run):
    """What the colour bars say; stresses are drawn over the yield stress where the solid has one."""
    return {**style.NAMES, **({"von_mises": r"von Mises stress / $\sigma_Y$"} if run.scene["solid"].get("yield_stress") else {})}


def scale_bar(axes, run, side="left"):
    """A length in widths of the interface, above the walls."""
    panels.scale_bar(axes, run.scene["phase_field"]["width"], "$W_0$", side, 0.12)


def between_nodes(snapshot, field, x, y):
    """Mean of a nodal field over the nodes next to (x, y), regular positions; at the middle of a cell its four corners."""
    at = [(positions - nodes[0]) / (nodes[1] - nodes[0]) for positions, nodes in ((x, snapshot.x), (y, snapshot.y))]
    (left, right), (low, high) = ([np.clip(round_(a).astype(int), 0, len(n) - 1) for round_ in (np.floor, np.ceil)] for a, n in zip(at, (snapshot.x, snapshot.y)))
    values = snapshot.fields[field]
    return 0.25 * sum(values[np.ix_(j, i)] for j in (low, high) for i in (left, right))


def image_of(run, field, time):
    """(x, y, values) of a field on a regular grid, whole even where a quarter was computed.

    Fields of material points are means over background cells; the crystal angle is in degrees and only
    shown in the solid, a von Mises stress is over the yield stress.
    """
    snapshot = nearest_snapshot(run, field, time)
    if snapshot.kind == "points":
        lower, spacing, shape = panels.background_mesh(run)
        means = panels.point_means(snapshot.vertex, snapshot.fields[field], lower, spacing, shape)
        x = lower[0] + spacing[0] * (np.arange(shape[1]) + 0.5)
        y = lower[1] + spacing[1] * (np.arange(shape[0]) + 0.5)
        inside = between_nodes(nearest_snapshot(run, "phi", time, "grid"), "phi", x, y) > 0
        values = np.where(inside & np.isnan(means), panels.filled_once(means), means)  # cells that no point happens to be in
        if field == "von_mises":
            values = values / (run.scene["solid"].get("yield_stress") or 1.0)
    else:
        x, y, values = snapshot.x, snapshot.y, snapshot.fields[field]
        if field == "crystal_angle":
            values = np.where(snapshot.fields["phi"] > 0, np.degrees(values), np.nan)
    if not is_quarter(run):
        return x, y, values
    sign = -1.0 if field == "crystal_angle" else 1.0
    first = 1 if x[0] == 0.0 else 0  # a node on the mirror is not doubled
    values = np.hstack([sign * values[:, ::-1][:, : len(x) - first], values])
    first_y = 1 if y[0] == 0.0 else 0
    values = np.vstack([sign * values[::-1][: len(y) - first_y], values])
    x = np.concatenate([-x[::-1][: len(x) - first], x])
    y = np.concatenate([-y[::-1][: len(y) - first_y], y])
    return x, y, values


def walls_of(run, time):
    """Where the moving walls stand: {"top": y, "left": x, ...}, of a quarter with their mirror images."""
    names = {side: f"wall_{side}_position" for side in ("left", "right", "bottom", "top")}
    found = {}
    for table in map(run.table, run.names("tables")):
        found |= {side: float(np.interp(time, table.time, table[name])) for side, name in names.items() if name in table.columns}
    if is_quarter(run):
        opposite = {"top": "bottom", "bottom": "top", "left": "right", "right": "left"}
        found |= {opposite[side]: -at for side, at in found.items()}
    return found


def draw_walls(axes, walls):
    """The walls' faces, and grey behind them, to the ends of the axes."""
    limits = {"left": axes.get_xlim()[0], "right": axes.get_xlim()[1], "bottom": axes.get_ylim()[0], "top": axes.get_ylim()[1]}
    for side, at in walls.items():
        span, line = (axes.axvspan, axes.axvline) if side in ("left", "right") else (axes.axhspan, axes.axhline)
        span(at, limits[side], facecolor="#c9ced4", edgecolor="none", zorder=3)
        line(at, color="black", linewidth=0.5, zorder=3)


def closed(phi):
    """phi for contours: what lies behind a wall (NaN) counts as melt, so that the line closes along the wall."""
    return np.nan_to_num(phi, nan=-1.0)


def verdict(run, width=170):
    """What the run says about its own inertia and resolution, to be read beside its figures; lines of `width` characters."""
    said = filter(None, (run.text("inertia"), run.text("warning")))
    return "\n".join(textwrap.fill(one, width) for one in said)


def field_table(run, compressions, below=verdict):
    """Figs. 12 and 13: phi, von Mises stress, plastic strain and crystal angle, a row per compression; `below(run)` is printed under it."""
    times = {f"{100 * c:g} %": time_of(run, c) for c in compressions}
    images = {(row, field): image_of(run, field, time) for row, time in times.items() for field in FIELDS}
    norms = {}
    for field in FIELDS:
        values = [images[row, field][2] for row in times]
        known = np.concatenate([v[~np.isnan(v)] for v in values])
        if field == "phi":
            norms[field] = panels.norm_of(values, -1, 1)
        elif field == "crystal_angle":
            most = max(float(np.quantile(np.abs(known), 0.999)), 1e-3)
            norms[field] = panels.norm_of(values, -most, most)
        else:
            norms[field] = panels.norm_of(values, 0, float(np.quantile(known, 0.999)))
    width, height = run.scene["domain"]["size"]
    panel = style.DOUBLE / 4.15
    figure, axes = pyplot.subplots(
        len(times), 4, figsize=(style.DOUBLE, len(times) * panel * height / width + 0.55), layout="constrained"
    )

    extend = {field: panels.beyond(norms[field], [images[row, field][2] for row in times]) for field in FIELDS if field != "phi"}

    def draw(one, row, field):
        x, y, values = images[row, field]
        drawn = panels.image(one, x, y, values, norm=norms[field], cmap=style.MAPS[field])
        px, py, phi = images[row, "phi"]
        if field != "phi":
            one.contour(px, py, closed(phi), [0.0], colors="black", linewidths=0.25)
        one.set(xlim=(px[0], px[-1]), ylim=(py[0], py[-1]))
        draw_walls(one, walls_of(run, times[row]))
        return drawn

    panels.field_table(figure, axes, list(times), FIELDS, draw, names_of(run), extend)
    scale_bar(axes[0, 0], run)
    if below(run):
        figure.supxlabel(below(run), fontsize=6.5)
    curves = []
    for (row, field), (x, y, values) in images.items():
        if field == "phi":
            lines = pyplot.figure().add_subplot().contour(x, y, closed(values), [0.0])
            pyplot.close()
            for segment in lines.allsegs[0]:
                curves.append(panels.Curve(row, "phi = 0", segment[:, 0], segment[:, 1]))
    return figure, curves
