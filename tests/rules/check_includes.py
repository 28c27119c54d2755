"""Who may include whom: the rooms of the house and the doors between them. Solid and melt never open a door to each other, and the
finite-element reference shares data with the solver, never a line of physics."""

import re

import tree

# room -> rooms it may include, beside itself
ALLOWED = {
    "scene": set(),
    "record": {"scene"},
    "medium": {"scene", "record"},
    "solid": {"scene", "record", "medium"},
    "melt": {"scene", "record", "medium"},
    "mpm_pf": {"scene", "record", "medium", "solid", "melt"},
    "fe_reference": {"scene", "record"},
    "verify": {"scene", "record"},
    "kernels": {"scene", "record", "medium", "solid", "melt"},
}
# libraries that only these rooms may use
LIBRARIES = {"deal.II/": {"fe_reference"}, "Trilinos": {"fe_reference"}, "hdf5.h": {"record"}}
INNER = ("scene", "record", "medium", "solid", "melt")


def room_of(path):
    """The room a file belongs to, or None where every door is open (tests, postprocess)."""
    parts = path.parts
    if parts[0] == "mpm_pf":
        return parts[1] if parts[1] in INNER else "mpm_pf"
    if parts[0] == "fe_reference":
        return "fe_reference"
    if parts[0] == "benchmarks" and parts[1] in ("verify", "kernels"):
        return parts[1]
    return None


def target_room(name):
    """The room that an include names, or None for libraries and neighbours in the same folder."""
    first = name.split("/")[0]
    return first if first in INNER + ("fe_reference",) and "/" in name else None


def offenders_in(path):
    room = room_of(path)
    if room is None or path.suffix not in (".cc", ".h"):
        return
    for number, line in enumerate(tree.read(path).split("\n"), 1):
        found = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if not found:
            continue
        name = found.group(1)
        target = target_room(name)
        if target and target != room and target not in ALLOWED[room]:
            yield f"{path}:{number}: {room} may not include {name}"
        for library, rooms in LIBRARIES.items():
            if name.startswith(library) and room not in rooms:
                yield f"{path}:{number}: only {', '.join(sorted(rooms))} may include {name}"


if __name__ == "__main__":
    tree.finish("includes", [o for path in tree.sources() for o in offenders_in(path)])
