"""What Sec. 3 says in passing, of the first author's thesis: a dendrite attached to a moving wall, and the compression with a viscous solid; against records."""

import numpy as np

import asymmetry
import compression
import panels
from claims import Claim, Compressed, judge, listed, scales_of


def of_wall(results):
    """The contour beside a wall that moves, moved back by the wall's way, against that beside a wall at rest."""
    moving, rest = results.records("wall_galilean", ["mpm_pf", "at_rest"])
    way, largest, rms = apart(moving, rest)
    measured = f"after {way:.3g} cells: {largest:.2f} dx at most, {rms:.3f} dx rms"
    others = [results.optional("wall_galilean", name) for name in ("twice_the_way", "twice_the_way_at_rest")]
    if all(others):
        way, farther, _ = apart(*others)
        spacing = panels.background_mesh(others[0])[1][0] / panels.background_mesh(moving)[1][0]
        measured += f"; on cells {spacing:.3g} times as wide after {way:.3g} of them: {farther:.2f} dx at most"
    sentence = "the contours for a dendrite attached to a wall are indistinguishable with and without wall motion"
    return [judge(sentence, largest < 0.25, measured, said="seen: a quarter of a cell is less than a line's width")]


def apart(moving, rest):
    """(way of the wall, largest and rms distance of the contours), in cells."""
    spacing = panels.background_mesh(moving)[1][0]
    melt = next(table for table in map(moving.table, moving.names("tables")) if "wall_left_position" in table.columns)
    time = moving.times("outlines", "contour")[-1]
    way = float(np.interp(time, melt.time, melt["wall_left_position"])) - float(rest.scene["domain"].get("origin", [0.0])[0])
    ours = [curve - np.array([way, 0.0]) for curve in moving.outline("contour", time)]
    theirs = rest.outline("contour", rest.times("outlines", "contour")[-1])
    gaps = np.concatenate([asymmetry.distances(np.vstack(a), b) for a, b in ((ours, theirs), (theirs, ours))]) / spacing
    return way / spacing, float(gaps.max()), asymmetry.rms(gaps)


def of_viscous(results):
    """The wall's work, the stresses and how far it flows, beside the same dendrite without viscosity."""
    plain = results.record("compress_dendrite_viscous", "mpm_pf")
    runs = list(filter(None, (results.optional("compress_dendrite_viscous", name) for name in ("De_0.01", "De_0.1", "De_1"))))
    numbers = [deborah(run) for run in runs]
    share = last_compression(plain)
    works = [work(run) / work(plain) for run in runs]
    states = [Compressed(run, share) for run in (plain, *runs)]
    alike = [number for number, ratio in zip(numbers, works) if abs(ratio - 1.0) < 0.1]
    measured = (
        f"to {100 * share:.0f} % at De = {listed(numbers)}: the walls' work is {listed(works)} times that without viscosity, the highest von Mises stress {listed([s.von_mises.max() for s in states[1:]])} "
        f"sigma_Y, plastic strain above 0.2 % reaches down to y = {listed([s.plastic_depth() for s in states[1:]])} W0 (without: {listed([states[0].plastic_depth()])})"
    )
    sentence = "simulations with the viscous effect are very similar to those without"
    if not alike:
        return [judge(sentence, False, measured)]
    beyond = "" if len(alike) == len(numbers) else "; beyond, stresses rise above the yield stress with De"
    return [Claim(sentence, f"seen at De = {listed(alike)}{beyond}", measured)]


def deborah(run):
    """eta times the rate at which walls close in, over the yield stress: eta (V / half the height) / sigma_Y."""
    half = run.scene["domain"]["size"][1] / (1.0 if compression.is_quarter(run) else 2.0)
    return run.scene["solid"]["viscosity"] * run.scene["wall"][0]["speed"] / half / scales_of(run)[1]


def melt_of(run):
    return next(table for table in map(run.table, run.names("tables")) if "compression" in table.columns)


def work(run):
    return float(melt_of(run)["external_work"][-1])


def last_compression(run):
    """The largest compression at which fields are recorded."""
    return max(share for probe in run.scene["probe"] if probe.get("snapshot") for share in probe.get("compressions", []))
