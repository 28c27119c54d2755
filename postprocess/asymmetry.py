"""How far a compressed dendrite of the whole domain is from its own mirror images, recording by recording.

A scene without noise is symmetric in x, in y and under half a turn, and so is Sec. 3 of the paper (it computes a quarter);
what a run of the whole domain loses of that is rounding that growth and plastic flow amplify.
"""

import numpy as np

import compression
import panels

IMAGES = {"mirrored in x": (-1, 1), "mirrored in y": (1, -1), "turned by half": (-1, -1)}
SQUARE = 4  # cells: von Mises stresses are compared as means over such squares


def distances(points, curves, chunk=256):
    """Distance of each point (n, 2) to the nearest edge of some closed curves."""
    start = np.vstack(curves)
    edge = np.vstack([np.roll(curve, -1, axis=0) - curve for curve in curves])
    length = np.maximum((edge**2).sum(axis=1), 1e-300)
    nearest = np.empty(len(points))
    for first in range(0, len(points), chunk):
        gap = points[first : first + chunk, None] - start
        along = np.clip((gap * edge).sum(axis=2) / length, 0, 1)
        nearest[first : first + chunk] = np.sqrt(((gap - along[..., None] * edge) ** 2).sum(axis=2).min(axis=1))
    return nearest


def middle_of(run):
    lower, size = (np.array(run.scene["domain"].get(key, [0.0, 0.0])) for key in ("origin", "size"))
    return lower + size / 2


def of_contour(run, time):
    """The contour's largest distance from each of its images, over the mesh spacing."""
    curves = [curve - middle_of(run) for curve in run.outline("contour", time)]
    spacing = panels.background_mesh(run)[1][0]
    return {name: distances(np.vstack(curves), [c * signs for c in curves]).max() / spacing for name, signs in IMAGES.items()}


def of_stress(run, time):
    """Root mean square of the differences of von Mises stress, means over squares of four cells, over the yield stress."""
    snapshot = compression.nearest_snapshot(run, "von_mises", time, "points")
    size = np.array(run.scene["domain"]["size"])
    square = SQUARE * np.array(panels.background_mesh(run)[1])
    shape = tuple(2 * int(np.ceil(s / 2 / side)) for s, side in zip(size[::-1], square[::-1]))
    lower = middle_of(run) - 0.5 * square * np.array(shape[::-1])
    stress = snapshot.fields["von_mises"] / (run.scene["solid"].get("yield_stress") or 1.0)
    means = panels.point_means(snapshot.vertex, stress, lower, square, shape)
    return {name: rms(means - means[:: signs[1], :: signs[0]]) for name, signs in IMAGES.items()}


def rms(values):
    """Root mean square of what is known; zero if nothing is."""
    known = values[~np.isnan(values)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else 0.0
