"""Read the records of both solvers (HDF5, layout in mpm_pf/record/writer.h) for figures and reports.

Everything that can be absent raises Missing with a sentence that says what is absent where, so that a
figure is either drawn from data or skipped with a reason, never drawn half.
"""

import os
import pathlib
import tomllib
from dataclasses import dataclass

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")  # looking must not disturb a running solver

import h5py  # noqa: E402
import numpy as np  # noqa: E402

SUITES = ("scene", "quick", "smoke")  # the best resolved first


class Missing(Exception):
    """What a figure needs is not there; the text says what and where."""


@dataclass
class Table:
    """Columns over time: table["force_x"] is an array as long as table.time."""

    time: np.ndarray
    columns: dict
    units: dict

    def __getitem__(self, name):
        if name not in self.columns:
            raise Missing(f"no column {name} among {', '.join(self.columns)}")
        return self.columns[name]


@dataclass
class Line(Table):
    """A sampled line at one time: position (m, 2), columns (m,), NaN where no material is."""

    position: np.ndarray


@dataclass
class Snapshot:
    """A whole field at one time.

    kind "grid": x (nx), y (ny), fields (ny, nx); "points": vertex (n, 2), fields (n,);
    "cells": vertex (v, 2), connectivity (n, 4), fields (n,).
    """

    time: float
    kind: str
    fields: dict
    x: np.ndarray = None
    y: np.ndarray = None
    vertex: np.ndarray = None
    connectivity: np.ndarray = None


def _nearest(times, wanted, what):
    """Index of `wanted` (None: the last) among `times`, to 1e-3 of the run's length."""
    times = np.asarray(times)
    if len(times) == 0:
        raise Missing(f"{what} recorded nothing")
    if wanted is None:
        return len(times) - 1
    index = int(np.argmin(np.abs(times - wanted)))
    if abs(times[index] - wanted) > 1e-3 * max(abs(times[-1]), abs(wanted)):
        listed = ", ".join(f"{t:g}" for t in times[:12])
        raise Missing(f"{what} was not recorded at t = {wanted:g} but at {listed}")
    return index


class Record:
    """One finished run. `label` is how the run is called in messages, as in shear/scene/mpm_pf."""

    def __init__(self, path, label=None):
        self.path = pathlib.Path(path)
        self.label = label or str(path)
        if not self.path.exists():
            unfinished = self.path.with_name(self.path.name + ".part").exists()
            raise Missing(f"{self.label}: " + ("the run is unfinished" if unfinished else "no record"))
        try:
            self.file = h5py.File(self.path, "r")
        except OSError as error:
            raise Missing(f"{self.label}: not readable ({error})") from error
        if not str(self.file.attrs.get("format", "")).startswith("mpm_pf record"):
            raise Missing(f"{self.label}: not a record of this project")
        self.status = str(self.file.attrs["status"])
        if self.status.startswith("failed"):
            raise Missing(f"{self.label}: the run {self.status}")

    @property
    def scene(self):
        """The merged scene as nested dictionaries."""
        return tomllib.loads(self.file["provenance/scene"].asstr()[()])

    def number(self, name):
        """A number of the record or its profile; NaN if there is none."""
        for group in (self.file, self.file.get("profile")):
            if group is not None and name in group.attrs and np.isreal(group.attrs[name]):
                return float(group.attrs[name])
        return float("nan")

    def text(self, name):
        """A text that the run wrote about itself, as "inertia" or "warning"; empty if it wrote none."""
        return str(self.file.attrs.get(name, ""))

    @property
    def source(self):
        """Where a figure's numbers come from: the run and the commit of the program that made it."""
        noted = self.file["provenance"].attrs
        commit = str(noted.get("commit", "unknown"))[:10]
        changed = " with changes" if str(noted.get("dirty", "no")) == "yes" else ""
        return f"{self.label} (commit {commit}{changed})"

    def names(self, kind):
        """Probes of `kind`: "tables", "lines", "outlines" or "snapshots"."""
        return list(self.file.get(kind, {}))

    def _group(self, kind, name):
        if name not in self.names(kind):
            there = ", ".join(self.names(kind)) or "nothing"
            raise Missing(f'{self.label}: no "{name}" among its {kind} ({there})')
        return self.file[kind][name]

    def _numbered(self, kind, name):
        group = self._group(kind, name)
        return [group[str(k)] for k in range(len(group))]

    def table(self, name):
        group = self._group("tables", name)
        names = [str(n) for n in group.attrs["columns"]]
        units = [str(u) for u in group.attrs["units"]]
        values = group["values"][:]
        columns = {n: values[:, k] for k, n in enumerate(names)}
        return Table(group["time"][:], columns, dict(zip(names, units)))

    def line(self, name, at=None):
        group = self._group("lines", name)
        row = _nearest(group["time"][:], at, f"{self.label}: line {name}")
        names = [str(n) for n in group.attrs["columns"]]
        units = [str(u) for u in group.attrs["units"]]
        values = group["values"][row]
        columns = {n: values[:, k] for k, n in enumerate(names)}
        return Line(group["time"][row], columns, dict(zip(names, units)), group["position"][row])

    def times(self, kind, name):
        """Times of an outline or snapshot probe."""
        return np.array([float(g.attrs["time"]) for g in self._numbered(kind, name)])

    def outline(self, name, at=None):
        """Closed curves [(n, 2), ...] at time `at` (None: the last)."""
        index = _nearest(self.times("outlines", name), at, f"{self.label}: outline {name}")
        group = self.file["outlines"][name][str(index)]
        offset, vertex = group["offset"][:], group["vertex"][:]
        return [vertex[a:b] for a, b in zip(offset[:-1], offset[1:])]

    def snapshot(self, name, at=None):
        index = _nearest(self.times("snapshots", name), at, f"{self.label}: snapshot {name}")
        group = self.file["snapshots"][name][str(index)]
        fields = {f: group["fields"][f][:] for f in group["fields"]}
        mesh = {k: group[k][:] for k in ("x", "y", "vertex", "connectivity") if k in group}
        return Snapshot(float(group.attrs["time"]), str(group.attrs["kind"]), fields, **mesh)

    def snapshot_of(self, field, at=None, kind=None):
        """The snapshot, of whatever probe, that holds `field` at time `at`."""
        reasons = []
        for name in self.names("snapshots"):
            first = self._numbered("snapshots", name)[0]
            if field in first["fields"] and kind in (None, str(first.attrs["kind"])):
                try:
                    return self.snapshot(name, at)
                except Missing as missing:
                    reasons.append(str(missing))
        raise Missing(reasons[0] if reasons else f"{self.label}: no snapshot holds {field}")

    def outline_of(self, names, at=None):
        """Outline of the first probe among `names` that exists: (its name, curves)."""
        for name in names:
            if name in self.names("outlines"):
                return name, self.outline(name, at)
        raise Missing(f"{self.label}: none of the outlines {', '.join(names)}")


class Results:
    """A folder of records as `verify run` writes it: DIR/<case>/<scene|quick|smoke>/<run>.h5."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise Missing(f"{folder} is no folder")
        self.used = []  # sources of the current figure

    def records(self, case, runs):
        """The records of several runs of one case, all of the best suite that has them all."""
        reasons = []
        for suite in SUITES:
            try:
                found = [
                    Record(self.folder / case / suite / f"{run}.h5", f"{case}/{suite}/{run}")
                    for run in runs
                ]
            except Missing as missing:
                reasons.append(str(missing))
            else:
                self.used += [record.source for record in found]
                return found
        raise Missing(reasons[-1] if not (self.folder / case).is_dir() else "; ".join(reasons))

    def record(self, case, run):
        return self.records(case, [run])[0]

    def optional(self, case, run):
        """The record of a run, or None if there is none."""
        try:
            return self.record(case, run)
        except Missing:
            return None
