"""What inertia costs: forces at both ends of the squeezed dendrite at three Mach numbers, beside finite elements."""

from matplotlib import pyplot

import panels
import record
import style

RUNS = {  # the quick suite does without the second
    "mach_3e-3": (r"Mach $3\times10^{-3}$", {"color": style.SEQUENCE[3], "lw": 0.8}),
    "mach_1e-3": (r"Mach $10^{-3}$", {"color": style.VARIANT, "lw": 0.9}),
    "mpm_pf": (r"Mach $2\times10^{-4}$", {"color": style.MATERIAL_POINTS}),
    "fe_reference": ("finite elements", {"color": style.FINITE_ELEMENTS, "ls": "--"}),
}


def squeeze_mach(results):
    try:
        names = list(RUNS)
        runs = results.records("dendrite_squeeze", names)
    except record.Missing:
        names.remove("mach_1e-3")
        runs = results.records("dendrite_squeeze", names)
    figure, axes = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.6), sharey=True, layout="constrained")
    curves = []
    for one, (end, sign, panel) in zip(axes, (("top reaction", -1, "driven end"), ("bottom reaction", 1, "held end"))):
        entries = []
        for name, run in zip(names, runs):
            table = run.table(end)
            entries.append((RUNS[name][0], table.time, sign * table["force_y"], RUNS[name][1]))
        curves += panels.line_overlay(one, panel, entries)
        one.set(xlabel=r"$t/\tau_0$", title=panel, ylim=(-10, 70))
    axes[0].set_ylabel(r"force / $\sigma_Y W_0$")
    axes[1].legend(loc="upper left", frameon=True, facecolor="white", edgecolor="none", framealpha=0.9)
    return figure, curves


FIGURES = {"squeeze_mach": squeeze_mach}
