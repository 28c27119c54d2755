"""One place for how figures look: a journal's widths, fonts, colours, and bytes that do not change.

The fonts come with matplotlib, text becomes outlines in SVG, and no date is written: the same records
give the same files on any machine with this version of matplotlib.
"""

import pathlib
import re

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402

SINGLE = 3.54  # inches: 90 mm, one column
ONE_AND_HALF = 5.51  # 140 mm
DOUBLE = 7.48  # 190 mm, the page

# Distinct for colour-blind readers and in grey: dark blue, vermilion, black, green, and their kin.
MATERIAL_POINTS = "#0a4f8f"
FINITE_ELEMENTS = "#d1495b"
THEORY = "#111111"
VARIANT = "#2a9d6f"
GREY = "#7a7a7a"
SOLID_FILL = "#d9e2ec"
SEQUENCE = ("#0a4f8f", "#d1495b", "#2a9d6f", "#c98a1b", "#6d4f9e", "#4f4f4f")

# One colour map per quantity, so that a colour means the same thing in every figure.
MAPS = {
    "phi": "Greys",
    "theta": "inferno",
    "von_mises": "turbo",
    "plastic_strain": "viridis",
    "crystal_angle": "RdBu_r",
}

NAMES = {
    "phi": r"$\phi$",
    "theta": r"$\theta$",
    "von_mises": "von Mises stress",
    "plastic_strain": "equivalent plastic strain",
    "crystal_angle": "crystal angle (deg)",
    "displacement_y": "$u_y$",
}

_SETTINGS = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9,
    "axes.labelsize": 9,
    "axes.titlesize": 9,
    "legend.fontsize": 8,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.1,
    "lines.markersize": 3.2,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.top": True,
    "ytick.right": True,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "legend.frameon": False,
    "legend.handlelength": 2.2,
    "image.cmap": "viridis",
    "axes.formatter.use_mathtext": True,
    "axes.formatter.limits": (-3, 4),
    "figure.dpi": 100,
    "savefig.dpi": 300,
    "svg.hashsalt": "mpm_pf",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "pdf.compression": 6,
}


def apply():
    """Make this the style of every figure drawn from now on."""
    pyplot.rcdefaults()
    matplotlib.rcParams.update(_SETTINGS)


def _renamed_clips(svg):
    """Number the clip paths of an SVG: matplotlib names some of them after places in memory."""
    names = dict.fromkeys(re.findall(r'<clipPath id="(\w+)"', svg))
    order = {name: f"clip{k}" for k, name in enumerate(names)}
    return re.sub(r'(id="|#)(\w+)', lambda m: m[1] + order.get(m[2], m[2]), svg)


def save(figure, stem, sources):
    """Write <stem>.pdf, .svg and .png, each of which tells its sources; returns their names."""
    drawn_from = "drawn from " + ", ".join(sources)
    metadata = {
        "pdf": {"CreationDate": None, "ModDate": None, "Creator": None, "Producer": None, "Subject": drawn_from},
        "svg": {"Date": None, "Creator": None, "Description": drawn_from},
        "png": {"Software": None, "Description": drawn_from},
    }
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # laid out once, so that the three are alike
    names = []
    for kind, entries in metadata.items():
        names.append(f"{stem}.{kind}")
        figure.savefig(names[-1], metadata=entries)
    svg = pathlib.Path(f"{stem}.svg")
    svg.write_text(_renamed_clips(svg.read_text(encoding="utf-8")), encoding="utf-8")
    pyplot.close(figure)
    return names
