"""The units in which a record speaks: those of its columns stand beside them, those of places, times and fields follow from the scene's system."""

import re
from dataclasses import dataclass, field

import h5py

SYSTEMS = {"SI": ("m", "s", "Pa"), "W0-tau0-sigmaY": ("W0", "tau0", "sigma_Y")}


@dataclass
class Units:
    """Of one record: of lengths, times and stresses, and of the columns of each table and line ({name: {column: unit}})."""

    length: str = "m"
    time: str = "s"
    stress: str = "Pa"
    columns: dict = field(default_factory=dict)

    def after(self, quantity):
        """What follows the numbers of a field: " Pa", or nothing of a pure number."""
        if quantity in ("von_mises", "pressure") or quantity.startswith("stress_"):
            return f" {self.stress}"
        return f" {self.length}" if quantity.startswith("displacement_") else ""

    def of(self, probe, expression):
        """The unit of a column of a probe, of the time or of a place; "" of anything else, as an expression of several columns."""
        own = self.columns.get(probe, {})
        unit = own.get(expression) or {"time": self.time, "x": self.length, "y": self.length, "s": self.length}.get(expression, "")
        return "" if unit in ("1", "-") else unit


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def of_record(path):
    """Units of a record; those of the SI where it does not say."""
    with h5py.File(path, "r") as record:
        scene = _text(record["provenance/scene"][()]) if "provenance/scene" in record else ""
        system = re.search(r'^\s*system\s*=\s*"([^"]+)"', scene, flags=re.M)
        units = Units(*SYSTEMS.get(system[1] if system else "SI", SYSTEMS["SI"]))
        for kind in ("tables", "lines"):
            for name, group in record.get(kind, {}).items():
                units.columns[name] = dict(zip(map(_text, group.attrs.get("columns", [])), map(_text, group.attrs.get("units", []))))
        return units
