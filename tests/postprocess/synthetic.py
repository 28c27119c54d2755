"""Invented records, in the layout of mpm_pf/record/writer.h, with which the drawing can be tested.

The numbers are smooth stand-ins of the right size and shape; they are no results of anything.
"""

import pathlib
import sys

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
ANGLES = np.linspace(0, 2 * np.pi, 400, endpoint=False)


class Invented:
    """One record being written; columns have no units worth the name."""

    def __init__(self, folder, case, run, scene, suite="scene"):
        path = pathlib.Path(folder) / case / suite / f"{run}.h5"
        path.parent.mkdir(parents=True, exist_ok=True)
        self.file = h5py.File(path, "w")
        self.file.attrs["format"] = "mpm_pf record 1"
        self.file.attrs["status"] = "complete"
        self.file.create_group("provenance")["scene"] = scene
        self.file["provenance"].attrs.update({"commit": "0123456789abcdef", "dirty": "yes"})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def _declare(self, path, columns):
        group = self.file.create_group(path)
        group.attrs["columns"] = list(columns)
        group.attrs["units"] = ["1"] * len(columns)
        return group

    def table(self, name, time, **columns):
        group = self._declare(f"tables/{name}", columns)
        group["time"], group["values"] = np.asarray(time, float), np.column_stack(list(columns.values()))

    def line(self, name, time, position, **columns):
        group = self._declare(f"lines/{name}", columns)
        group["time"], group["position"] = [float(time)], position[None]
        group["values"] = np.column_stack(list(columns.values()))[None]

    def _next(self, kind, name, time):
        group = self.file.require_group(f"{kind}/{name}")
        group = group.create_group(str(len(group)))
        group.attrs["time"] = float(time)
        if kind == "snapshots":
            group.create_group("fields")
        return group

    def outline(self, name, time, curves):
        group = self._next("outlines", name, time)
        group["offset"] = np.cumsum([0] + [len(c) for c in curves]).astype("i4")
        group["vertex"] = np.vstack(curves)

    def grid(self, name, time, x, y, **fields):
        group = self._next("snapshots", name, time)
        group.attrs["kind"], group["x"], group["y"] = "grid", x, y
        for field, values in fields.items():
            group[f"fields/{field}"] = values

    def points(self, name, time, vertex, **fields):
        group = self._next("snapshots", name, time)
        group.attrs["kind"], group["vertex"] = "points", vertex
        for field, values in fields.items():
            group[f"fields/{field}"] = values

    def cells(self, name, time, vertex, connectivity, **fields):
        group = self._next("snapshots", name, time)
        group.attrs["kind"], group["vertex"] = "cells", vertex
        group["connectivity"] = connectivity.astype("i4")
        for field, values in fields.items():
            group[f"fields/{field}"] = values


def scene_text(case, name="scene"):
    """A case's scene as merged text; includes are flat enough here to be read as written."""
    return (ROOT / "benchmarks" / case / f"{name}.toml").read_text()


def lattice(corner, size, spacing):
    """Cell centres of a rectangle, (n, 2)."""
    axes = [np.arange(c + spacing / 2, c + s, spacing) for c, s in zip(corner, size)]
    return np.column_stack([a.ravel() for a in np.meshgrid(*axes)])


def quads(nx, ny, position):
    """Vertices position(X, Y) of an nx x ny mesh of the unit square, and its quadrilaterals."""
    grid_x, grid_y = np.meshgrid(np.linspace(0, 1, nx + 1), np.linspace(0, 1, ny + 1))
    first = (np.arange(ny)[:, None] * (nx + 1) + np.arange(nx)).ravel()
    connectivity = np.column_stack([first, first + 1, first + nx + 2, first + nx + 1])
    return position(grid_x.ravel(), grid_y.ravel()), connectivity


def cantilever(folder):
    scene = scene_text("cantilever")
    x = np.linspace(0, 8, 33)
    shape = 100 / (6 * 3e7 / 0.91 / 12) * ((4 + 15 / 7) * x / 4 + (24 - x) * x**2)
    for run, factor in (("mpm_pf", 1.01), ("fe_reference", 0.998)):
        with Invented(folder, "cantilever", run, scene) as out:
            out.line("centre line", 22.0, np.column_stack([x, 0 * x]), displacement_x=0 * x, displacement_y=factor * shape)
            out.points("fields", 0.0, lattice((0, -0.5), (8, 1), 0.125))


def loop(strain_rate_sign, limit):
    """Elastic, then flat: stress along a strain path by clipping the trial stress."""
    stress = np.zeros_like(strain_rate_sign)
    for k in range(1, len(stress)):
        trial = stress[k - 1] + 3.3e7 * (strain_rate_sign[k] - strain_rate_sign[k - 1])
        stress[k] = np.clip(trial, -limit, limit)
    return stress


def tension(folder):
    time = np.linspace(0, 13.5, 201)
    strain = 0.005 * np.sin(2 * np.pi * time / 10)
    points = np.vstack([lattice((0, 0), (4, 1), 0.25), lattice((1, 1), (2, 5), 0.25), lattice((0, 6), (4, 1), 0.25)])
    for run, limit in (("mpm_pf", 6.9e4), ("fe_reference", 7.0e4)):
        with Invented(folder, "tension_compression", run, scene_text("tension_compression")) as out:
            out.points("fields", 0.0, points)
            for end, sign in (("top", 1), ("bottom", -1)):
                force = 2 * sign * loop(strain, limit)
                out.table(f"{end} reaction", time, force_y=force, displacement_y=sign * 2.5 * strain)
    strain = np.linspace(0, 0.02, 101)
    for tail, limit in (("", 1.1e5), ("_5e-3", 9.0e4), ("_1e-3", 7.4e4)):
        for run, factor in ((f"mpm_pf{tail}", 1.01), (f"fe{tail or '_reference'}", 1.0)):
            with Invented(folder, "tension_rates", run, scene_text("tension_rates")) as out:
                stress = factor * limit * np.tanh(3.3e7 * strain / limit)
                out.table("top reaction", strain, force_y=2 * stress, displacement_y=2.5 * strain)
                out.table("bottom reaction", strain, force_y=-2 * stress, displacement_y=-2.5 * strain)


def shear(folder):
    def sheared(x, y):
        s = 2 * y - 1
        return np.column_stack([2 + x + 0.4 * (1.5 * s - 0.5 * s**3) * (1 + 0.05 * (x - 0.5)), 0.2 + 2 * y])

    def fields(x, y):
        bow = np.exp(-8 * ((x - 0.5) ** 2 / 0.3 + (y - 0.5) ** 2 / 0.08))
        return {"von_mises": 4e8 * (1 - 0.8 * bow), "plastic_strain": 0.35 * (1 - bow) * (1 + np.abs(2 * y - 1) ** 8)}

    line = np.column_stack([np.linspace(1.5, 3.5, 81), np.full(81, 1.2)])
    inside = np.where(np.abs(line[:, 0] - 2.5) < 0.5, 1.0, np.nan)
    sides = np.linspace(0, 1, 60)
    rim = np.vstack([np.column_stack([sides, 0 * sides]), np.column_stack([0 * sides + 1, sides])])
    rim = np.vstack([rim, 1 - rim])
    with Invented(folder, "shear", "mpm_pf", scene_text("shear")) as out:
        material = lattice((0, 0), (1, 2), 1 / 120) / [1, 2]
        out.points("fields", 0.0, material * [1, 2] + [2, 0.2])
        out.points("fields", 1.025, sheared(*material.T), **fields(*material.T))
        out.outline("outline", 0.0, [rim * [1, 2] + [2, 0.2]])
        out.outline("outline", 1.025, [sheared(*rim.T)])
        out.line("sampling line", 1.025, line, von_mises=inside * fields(line[:, 0] - 2, 0.5)["von_mises"])
    with Invented(folder, "shear", "fe_reference", scene_text("shear")) as out:
        vertex, cells = quads(20, 40, sheared)
        centre = quads(20, 40, lambda x, y: np.column_stack([x, y]))[0][cells].mean(axis=1)
        out.cells("fields", 1.025, vertex, cells, **fields(*centre.T))
        out.outline("outline", 1.025, [sheared(*rim.T) + [0.01, 0]])
        out.line("sampling line", 1.025, line, von_mises=0.98 * inside * fields(line[:, 0] - 2, 0.5)["von_mises"])


def crystal(radius, angle=0.0, depth=0.6, folds=4):
    """A four-armed outline of the given arm length."""
    reach = radius * (1 - depth + depth * np.abs(np.cos(folds / 2 * (ANGLES - angle))) ** 3)
    return np.column_stack([reach * np.cos(ANGLES), reach * np.sin(ANGLES)])


def phase(x, y, radius, angle=0.0, squeeze=1.0, depth=0.6):
    grid_x, grid_y = np.meshgrid(x, y / squeeze)
    around = np.arctan2(grid_y, grid_x)
    reach = radius * (1 - depth + depth * np.abs(np.cos(2 * (around - angle))) ** 3)
    return np.tanh((reach - np.hypot(grid_x, grid_y)) / np.sqrt(2) / 2)


def melt(folder):
    with Invented(folder, "advect_circle", "mpm_pf", scene_text("advect_circle")) as out:
        x = (np.arange(80) + 0.5) / 80
        for time, at in ((0.0, 0.25), (0.5, 0.75), (1.0, 0.2505)):
            distance = np.hypot(*np.meshgrid(x - at, x - at)) - 0.15
            out.grid("fields", time, x, x, phi=-np.tanh(distance / np.sqrt(2) / 0.025))
            out.outline("contour", time, [0.15 * np.column_stack([np.cos(ANGLES), np.sin(ANGLES)]) + at])
    x = np.linspace(-128, 128, 321)
    for run, angle in (("mpm_pf", np.pi / 4), ("at_rest", 0.0), ("angle_frozen", np.pi / 8)):
        with Invented(folder, "rotate_dendrite", run, scene_text("rotate_dendrite")) as out:
            out.grid("fields", 240.0, x, x, phi=phase(x, x, 80, angle))
            out.outline("contour", 240.0, [crystal(80, angle)])
    for run, rate in (("mpm_pf", 0.5 / 260), ("still", 0.0)):
        with Invented(folder, "shear_dendrite", run, scene_text("shear_dendrite")) as out:
            for time in np.linspace(10, 260, 26):
                curve = crystal(8 + 0.29 * time)
                curve[:, 0] = np.maximum(curve[:, 0], 0)
                curve[:, 1] -= 0.75 * rate * time * curve[:, 0]
                out.outline("contour", time, [curve])


STEPS = [(0.0, 1000.0), (0.05, 1050.0), (0.10, 1100.0), (0.15, 1150.0), (0.20, 1200.0), (0.30, 1300.0)]


def compressed_state(out, at, x, y, share, yields, swirl):
    """One recording of a dendrite pressed in y: fields of the melt on a grid, of the solid at points."""
    phi = phase(x, y, 150, swirl, 1 - share)
    grid_x, grid_y = np.meshgrid(x, y)
    solid = phi > 0
    height = np.abs(grid_y) / 160 / (1 - share)  # of the material, before it was pressed
    out.grid("melt", at, x, y, phi=phi, crystal_angle=grid_x * grid_y / 2e5 * share * np.sign(phi))
    out.points(
        "solid",
        at,
        np.column_stack([grid_x[solid], grid_y[solid]]),
        von_mises=np.minimum(1, yields * share + height[solid] ** 2),
        plastic_strain=share * 4 * height[solid] ** 8,
        displacement_y=-grid_y[solid] * share / (1 - share),
    )


def compressed(folder, yields=3, carried=0.0, swirl=0.0):
    """Dendrites between walls. `yields`: von Mises stress at the centre per compression; `carried`: how far the melt carries
    the horizontal tip per compression; `swirl`: angle (radians) by which the whole-domain crystal has turned."""
    quarter = scene_text("compress_dendrite").replace("[600, 400]", "[120, 80]")
    whole = quarter.replace("[domain]", "[domain]\norigin = [-240.0, -160.0]")
    whole = whole.replace("size     = [240.0, 160.0]", "size     = [480.0, 320.0]").replace("[120, 80]", "[240, 160]")
    in_quarter = np.linspace(0, 240, 151), np.linspace(0, 160, 101)
    in_whole = np.linspace(-240, 240, 301), np.linspace(-160, 160, 201)
    cases = (
        ("compress_dendrite", "mpm_pf", quarter, in_quarter),
        ("compress_dendrite", "free", quarter, None),
        ("compress_dendrite", "whole", whole, in_whole),
        ("compress_dendrite_slender", "mpm_pf", quarter, in_quarter),
        ("compress_dendrite_noise", "mpm_pf", whole, in_whole),
        ("compress_dendrite_noise", "free", whole, None),
    )
    time = np.linspace(900, 1300, 81)
    compression = np.clip((time - 1000) / 1000, 0, None)
    for case, run, scene, grid in cases:
        with Invented(folder, case, run, scene) as out:
            pressed = run != "free"
            out.table("melt", time, compression=compression * pressed, wall_top_position=160 * (1 - compression))
            out.table("tip", time, position=160 + 0.16 * (time - 1000) + carried * compression * pressed)
            for share, at in STEPS:
                turned = swirl if run == "whole" else 0.0
                out.outline("contour", at, [crystal(150 + 60 * share, turned) * [1, 1 - share * pressed]])
                if grid:
                    compressed_state(out, at, *grid, share, yields, turned)


def squeezed(folder):
    time = np.linspace(0, 4.6, 24)
    force = 25 * np.tanh(time)
    for run, swing in (("mpm_pf", 0.1), ("mach_1e-3", 5.0), ("mach_3e-3", 40.0), ("fe_reference", 0.0)):
        with Invented(folder, "dendrite_squeeze", run, scene_text("dendrite_squeeze")) as out:
            ringing = swing * np.sin(9 * time)
            out.table("top reaction", time, force_y=-force + ringing, displacement_y=-0.3 * time)
            out.table("bottom reaction", time, force_y=force + ringing, displacement_y=0 * time)


def write_all(folder):
    for write in (cantilever, tension, shear, melt, compressed, squeezed):
        write(folder)


if __name__ == "__main__":
    write_all(sys.argv[1])
