"""The panels that figures are made of: curves over each other, fields with one colour bar, outlines.

Each panel draws into the axes it is given and returns what it drew; figures.py and the figure.py of each
case put them together. A Curve is what also goes into the CSV beside a figure.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib import collections, colors, patches, path, patheffects

import style


@dataclass
class Curve:
    """Numbers behind a figure: x and y (and value, for a field) of one curve in one panel."""

    panel: str
    name: str
    x: np.ndarray
    y: np.ndarray
    value: np.ndarray = None


def lettered(axes, start="a"):
    """Put (a), (b), ... at the upper left of the axes."""
    for k, one in enumerate(np.ravel(axes)):
        one.set_title(f"({chr(ord(start) + k)})", loc="left", pad=3)


def plain(axes):
    """No frame, no ticks, equal scales: for pictures of things."""
    axes.set_aspect("equal")
    axes.set_axis_off()


def line_overlay(axes, panel, entries):
    """Draw curves over each other; entries are (name, x, y, plot options)."""
    drawn = []
    for name, x, y, options in entries:
        axes.plot(x, y, label=name, **options)
        drawn.append(Curve(panel, name, np.asarray(x), np.asarray(y)))
    return drawn


def closed_path(curves):
    """Closed curves as one path; curves inside an odd number of others turn backwards: holes stay holes."""
    vertices, codes = [], []
    for curve in curves:
        depth = sum(contains(other, curve[0]) for other in curves if other is not curve)
        wanted = 1 if depth % 2 == 0 else -1
        turned = curve if np.sign(signed_area(curve)) == wanted else curve[::-1]
        vertices.append(np.vstack([turned, turned[:1]]))
        codes.append([path.Path.MOVETO] + [path.Path.LINETO] * (len(turned) - 1) + [path.Path.CLOSEPOLY])
    return path.Path(np.vstack(vertices), np.concatenate(codes))


def contains(curve, point):
    return path.Path(curve).contains_point(point)


def signed_area(curve):
    x, y = curve[:, 0], curve[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))


def outlines(axes, panel, name, curves, **options):
    """Draw closed curves as one line; returns their Curve, with NaN between them."""
    gap = np.full((1, 2), np.nan)
    joined = np.vstack([np.vstack([c, c[:1], gap]) for c in curves])
    axes.plot(joined[:, 0], joined[:, 1], **{"label": name, **options})
    return Curve(panel, name, joined[:, 0], joined[:, 1])


def norm_of(arrays, low=None, high=None):
    """One colour scale for several fields."""
    low = min(np.nanmin(a) for a in arrays) if low is None else low
    high = max(np.nanmax(a) for a in arrays) if high is None else high
    return colors.Normalize(low, high if high > low else low + 1)


def beyond(norm, arrays):
    """Which ends of a colour bar want an arrow, because values lie beyond them: extend= of a colour bar."""
    slack = 1e-6 * (norm.vmax - norm.vmin)
    below, above = min(np.nanmin(a) for a in arrays) < norm.vmin - slack, max(np.nanmax(a) for a in arrays) > norm.vmax + slack
    return {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[bool(below), bool(above)]


def point_means(vertex, values, lower, spacing, shape):
    """Mean of point values in each cell of a regular mesh (ny, nx); NaN where there are no points."""
    i = np.clip(((vertex[:, 0] - lower[0]) / spacing[0]).astype(int), 0, shape[1] - 1)
    j = np.clip(((vertex[:, 1] - lower[1]) / spacing[1]).astype(int), 0, shape[0] - 1)
    flat = j * shape[1] + i
    size = shape[0] * shape[1]
    count = np.bincount(flat, minlength=size).astype(float)
    total = np.bincount(flat, weights=values, minlength=size)
    with np.errstate(invalid="ignore"):
        return (total / np.where(count > 0, count, np.nan)).reshape(shape)


def filled_once(means):
    """Give empty cells the mean of their filled neighbours (at the rim, where an outline clips)."""
    padded = np.pad(means, 1, constant_values=np.nan)
    around = [
        padded[1 + dj : 1 + dj + means.shape[0], 1 + di : 1 + di + means.shape[1]]
        for dj in (-1, 0, 1)
        for di in (-1, 0, 1)
    ]
    known = np.sum([~np.isnan(a) for a in around], axis=0)
    total = np.sum([np.nan_to_num(a) for a in around], axis=0)
    mean = np.divide(total, known, out=np.full(means.shape, np.nan), where=known > 0)
    return np.where(np.isnan(means), mean, means)


def background_mesh(record):
    """(lower, spacing, (ny, nx)) of the cells of the scene's domain."""
    domain = record.scene["domain"]
    nx, ny = domain["cells"]
    lower = domain.get("origin", [0.0, 0.0])
    return lower, (domain["size"][0] / nx, domain["size"][1] / ny), (ny, nx)


def image(axes, x, y, values, **options):
    """Values (ny, nx) at the regular positions x, y as one image (in vector files too); NaN is empty."""
    dx, dy = 0.5 * (x[1] - x[0]), 0.5 * (y[1] - y[0])
    extent = (x[0] - dx, x[-1] + dx, y[0] - dy, y[-1] + dy)
    shown = np.ma.masked_invalid(values)
    drawn = axes.imshow(shown, **{"extent": extent, "origin": "lower", "interpolation": "nearest", **options})
    axes.update_datalim([extent[::2], extent[1::2]])
    return drawn


def field_map(axes, panel, name, record, snapshot, field, norm, clip=None, factor=1.0):
    """Draw one field of a snapshot of any kind; points are averaged over background cells.

    `clip`: closed curves outside which nothing is shown. Returns the mappable and the Curve.
    """
    values = snapshot.fields[field] * factor
    options = {"norm": norm, "cmap": style.MAPS.get(field, "viridis")}
    if snapshot.kind == "cells":
        corners = snapshot.vertex[snapshot.connectivity]
        drawn = collections.PolyCollection(corners, array=values, rasterized=True, antialiased=False, **options)
        axes.add_collection(drawn)
        axes.update_datalim(snapshot.vertex)
        centre = corners.mean(axis=1)
    elif snapshot.kind == "points":
        lower, spacing, shape = background_mesh(record)
        means = point_means(snapshot.vertex, values, lower, spacing, shape)
        x = lower[0] + spacing[0] * (np.arange(shape[1]) + 0.5)
        y = lower[1] + spacing[1] * (np.arange(shape[0]) + 0.5)
        drawn = image(axes, x, y, filled_once(filled_once(means)) if clip else means, **options)
        jj, ii = np.nonzero(~np.isnan(means))
        centre, values = np.column_stack([x[ii], y[jj]]), means[jj, ii]
    else:
        # a nodal field is continuous between its nodes: steps would be the picture's, not the field's
        drawn = image(axes, snapshot.x, snapshot.y, values, **{"interpolation": "bilinear", **options})
        grid_x, grid_y = np.meshgrid(snapshot.x, snapshot.y)
        centre, values = np.column_stack([grid_x.ravel(), grid_y.ravel()]), values.ravel()
    if clip:
        drawn.set_clip_path(closed_path(clip), axes.transData)
    axes.autoscale_view()
    return drawn, Curve(panel, name, centre[:, 0], centre[:, 1], values)


def colour_bar(figure, mappable, axes, label, **options):
    """One colour bar for all the axes given."""
    bar = figure.colorbar(mappable, ax=axes, label=label, **{"fraction": 0.05, "pad": 0.03, **options})
    bar.outline.set_linewidth(0.5)
    bar.ax.tick_params(width=0.5, size=2)
    return bar


def mesh_lines(axes, lower, spacing, shape, **options):
    """The cells of a regular mesh as thin lines."""
    x = lower[0] + spacing[0] * np.arange(shape[1] + 1)
    y = lower[1] + spacing[1] * np.arange(shape[0] + 1)
    lines = [[(a, y[0]), (a, y[-1])] for a in x] + [[(x[0], b), (x[-1], b)] for b in y]
    axes.add_collection(collections.LineCollection(lines, **{"colors": "#b5bcc4", "linewidths": 0.35, **options}))
    axes.update_datalim([(x[0], y[0]), (x[-1], y[-1])])
    axes.autoscale_view()


def points_on_mesh(axes, panel, record, snapshot, **options):
    """Material points on the fixed background mesh, as in Figs. 4 and 6."""
    mesh_lines(axes, *background_mesh(record))
    axes.plot(*snapshot.vertex.T, ".", **{"color": style.MATERIAL_POINTS, "markersize": 2, **options})
    return Curve(panel, "material points", snapshot.vertex[:, 0], snapshot.vertex[:, 1])


def dimension(axes, start, end, text, gap=(0.0, 0.0)):
    """An arrow from start to end with a length written at its middle, moved by `gap`."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "lw": 0.6, "shrinkA": 0, "shrinkB": 0})
    middle = (0.5 * (start[0] + end[0]) + gap[0], 0.5 * (start[1] + end[1]) + gap[1])
    axes.text(*middle, text, ha="center", va="center")


def wall(axes, corner, size):
    """A hatched block that holds something."""
    axes.add_patch(patches.Rectangle(corner, *size, fill=False, hatch="//////", linewidth=0))


def scale_bar(axes, unit, name, side="left", height=0.06):
    """A round length, about a fifth of the panel, in multiples of `unit`, in a lower corner at a part of the panel's height; for panels without ticks."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    most = 0.25 * (right - left) / unit
    power = 10.0 ** np.floor(np.log10(most))
    length = max(m for m in (1, 2, 5) if m * power <= most) * power
    halo = [patheffects.withStroke(linewidth=3, foreground="white")]
    margin, y = 0.04 * (right - left), low + height * (high - low)
    x = left + margin if side == "left" else right - margin - length * unit
    axes.plot([x, x + length * unit], [y, y], color="black", lw=1.5, solid_capstyle="butt", path_effects=halo)
    axes.text(x + 0.5 * length * unit, y + 0.03 * (high - low), f"{length:g} {name}", ha="center", va="bottom", fontsize=6, path_effects=halo)


def field_table(figure, axes, rows, columns, draw, names=style.NAMES, extend=None):
    """A table of field panels as in Figs. 12 and 13: draw(axes, row, column) -> mappable.

    One colour bar below each column, made from the last mappable of that column; `extend[column]`: its arrows.
    """
    for c, column in enumerate(columns):
        for r, row in enumerate(rows):
            mappable = draw(axes[r, c], row, column)
            axes[r, c].set(xticks=[], yticks=[], aspect="equal")
            for side in axes[r, c].spines.values():
                side.set(linewidth=0.4, color=style.GREY)
        colour_bar(figure, mappable, axes[:, c], names.get(column, column), location="bottom", extend=(extend or {}).get(column, "neither"))
    for r, row in enumerate(rows):
        axes[r, 0].set_ylabel(row, labelpad=2)
