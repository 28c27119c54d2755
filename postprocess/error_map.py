"""Error maps for the report: the last snapshot that both solvers recorded at the same time, on one raster, side by side, and their difference.

Material points are averaged over raster cells; finite-element quadrilaterals are sampled bilinearly inside (one value per cell, so each of
its samples has that value) and averaged likewise: cell means against cell means, never nodal averages.
"""

import base64
import io
import sys

import h5py
import matplotlib.pyplot as plt
import numpy as np

import recorded_units
import style  # no window: it chooses matplotlib's drawing engine

FIELDS = ("von_mises", "plastic_strain", "displacement_y")
RASTER = 48  # raster cells along the longer side


SAME_TIME = 1e-3  # of the longer run, as the checks have it


def first_series(record):
    """The snapshots of a record's first probe of fields: {number as text: group}."""
    names = sorted(record["snapshots"]) if "snapshots" in record else []
    return record["snapshots"][names[0]] if names else {}


def snapshot_times(path):
    """{time: number} of the snapshots in a record; empty where it has none or is gone."""
    if not path.exists():
        return {}
    with h5py.File(path, "r") as record:
        return {float(group.attrs["time"]): number for number, group in first_series(record).items()}


def last_common(first, second):
    """The last pair of times, one of each, that are the same; None where there is none but the start."""
    longest = max([*first, *second], default=0.0)
    pairs = [(a, b) for a in first for b in second if abs(a - b) <= SAME_TIME * longest and max(a, b) > 0.0]
    return max(pairs, default=None)


def snapshot(path, number):
    """(positions n x 2, {field: n values}, number of points or cells) of one snapshot, or None where it is a grid's."""
    with h5py.File(path, "r") as record:
        group = first_series(record)[number]
        kind = group.attrs["kind"]
        kind = kind.decode() if isinstance(kind, bytes) else kind
        if kind == "grid":
            return None
        vertex = group["vertex"][:]
        fields = {name: group["fields"][name][:] for name in FIELDS if name in group["fields"]}
        if kind == "points":
            return vertex, fields, len(vertex)
        quads = group["connectivity"][:].reshape(-1, 4)
        return *inside_cells(vertex, quads, fields), len(quads)


def inside_cells(vertex, quads, fields, samples=6):
    s = (np.arange(samples) + 0.5) / samples
    u, v = (a.ravel() for a in np.meshgrid(s, s))
    weight = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v])  # vertices run round the cell
    places = np.einsum("kp,ckd->cpd", weight, vertex[quads]).reshape(-1, 2)
    return places, {name: np.repeat(values, samples * samples) for name, values in fields.items() if len(values) == len(quads)}


def raster(places, values, box, cells):
    """Means over raster cells; NaN where nothing lies."""
    edges = [np.linspace(box[0][d], box[1][d], cells[d] + 1) for d in range(2)]
    count = np.histogram2d(places[:, 0], places[:, 1], bins=edges)[0]
    total = np.histogram2d(places[:, 0], places[:, 1], bins=edges, weights=values)[0]
    with np.errstate(invalid="ignore", divide="ignore"):
        return (total / count).T


def picture(name, a, b, labels, time, units):
    """PNG (base64) of a, b and a - b, and the text below it. None if they share no material."""
    low = np.minimum(a[0].min(axis=0), b[0].min(axis=0))
    high = np.maximum(a[0].max(axis=0), b[0].max(axis=0))
    # raster cells that hold two points or more of the sparser cloud, or are larger than the cells of the coarser mesh, whatever samples
    # those have: else the raster shows the lattice and not the field
    spacing = np.sqrt((high - low).prod() / min(a[2], b[2]))
    side = max((high - low).max() / RASTER, 1.6 * spacing)
    cells = [max(2, int(round(extent / side))) for extent in high - low]
    fields = [raster(places, values[name], (low, high), cells) for places, values, _ in (a, b)]
    difference = fields[0] - fields[1]
    if not np.isfinite(difference).any():
        return None
    figure, axes = plt.subplots(1, 3, figsize=(10, 1.3 + 3.0 * min(1.6, (high - low)[1] / (high - low)[0])), layout="constrained", sharey=True)
    quantity, unit = style.NAMES.get(name, name), units.after(name)
    extent = (low[0], high[0], low[1], high[1])
    shared = dict(vmin=np.nanmin(fields), vmax=np.nanmax(fields))
    largest = np.nanmax(np.abs(difference))
    top = largest or 1.0  # a colour bar needs a width
    for axis, field, label in zip(axes, (*fields, difference), (*labels, "difference")):
        colours = dict(cmap=style.MAPS.get(name, "viridis"), **shared) if label != "difference" else dict(cmap="RdBu_r", vmin=-top, vmax=top)
        image = axis.imshow(field, origin="lower", extent=extent, interpolation="nearest", **colours)
        axis.set_title(label, fontsize=9)
        axis.tick_params(labelsize=7)
        axis.locator_params(nbins=5)
        bar = figure.colorbar(image, ax=axis, location="bottom", aspect=30)
        bar.ax.tick_params(labelsize=7)
        bar.ax.locator_params(nbins=4)
        bar.set_label((quantity if label != "difference" else f"{quantity}, difference") + unit, fontsize=8)
        bar.ax.xaxis.get_offset_text().set_size(7)
        axis.set_xlabel(f"x ({units.length})", fontsize=8)
    axes[0].set_ylabel(f"y ({units.length})", fontsize=8)
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=110, bbox_inches="tight", pad_inches=0.05, metadata={"Software": None})
    plt.close(figure)
    rms = np.sqrt(np.nanmean(difference**2))
    text = f"{name} at t = {time:g} {units.time}, {labels[0]}, {labels[1]} and their difference (rms {rms:.3g}, largest {largest:.3g}{unit}), means over raster cells"
    return dict(title=text, png=base64.b64encode(stream.getvalue()).decode())


def of_case(folder, case):
    """Maps of one case: its first mpm_pf run against its first fe_reference run that share a scene and a field."""
    complete = [run for run in case["runs"] if run["status"] == "complete"]
    pairs = [
        (p, q) for p in complete for q in complete if p["solver"] == "mpm_pf" and q["solver"] == "fe_reference" and p["scene"] == q["scene"]
    ]
    if not pairs:
        return []
    stem = "scene" if case["suite"] == "full" else case["suite"]
    runs = pairs[0]
    paths = [folder / case["case"] / stem / (run["name"] + ".h5") for run in runs]
    times = [snapshot_times(path) for path in paths]
    if not all(times):
        return []
    same = last_common(*times)
    if same is None:
        last = " and ".join(f'{run["name"]} at t = {max(of_run):g}' for run, of_run in zip(runs, times))
        print(f'report: no error map of {case["case"]}: no snapshot of both is of the same time (the last: {last})', file=sys.stderr)
        return []
    snapshots = [snapshot(path, of_run[time]) for path, of_run, time in zip(paths, times, same)]
    if None in snapshots:
        return []
    shared = [name for name in FIELDS if all(name in fields for _, fields, _ in snapshots)]
    units = recorded_units.of_record(paths[0])
    maps = [picture(name, *snapshots, [run["name"] for run in runs], same[0], units) for name in shared[:2]]
    return [entry for entry in maps if entry]
