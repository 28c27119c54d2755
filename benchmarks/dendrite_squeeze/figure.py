"""What inertia costs: forces at both ends of the squeezed dendrite at three Mach numbers, beside finite elements."""

import numpy as np
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
    figure, axes = pyplot.subplots(1, 2, figsize=(style.DOUBLE, 2.9), sharey=True, layout="constrained")
    curves = []
    for one, (end, sign, panel) in zip(axes, (("top reaction", -1, "driven end"), ("bottom reaction", 1, "held end"))):
        entries = []
        for name, run in zip(names, runs):
            table = run.table(end)
            entries.append((RUNS[name][0], table.time, sign * table["force_y"], RUNS[name][1]))
        curves += panels.line_overlay(one, panel, entries)
        one.set(xlabel=r"$t/\tau_0$", title=panel, ylim=(-10, 70))
    axes[0].set_ylabel(r"force / $\sigma_Y W_0$")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncols=len(RUNS))
    figure.get_layout_engine().set(rect=(0, 0.09, 1, 0.91))
    forces = np.concatenate([curve.y for curve in curves])
    figure.suptitle(f"cut off at -10 and 70; forces at the largest Mach number reach {forces.min():.0f} and {forces.max():.0f}", fontsize=7)
    return figure, curves


FIGURES = {"squeeze_mach": squeeze_mach}
