#!/usr/bin/python3
"""Draw every figure of the paper for which records exist: PDF, SVG, PNG, and the CSV of its curves.

    figures.py RESULTS_DIR [--output DIR] [--only fig5 ...] [--cases DIR]

A case draws its own figures: benchmarks/<case>/figure.py holds FIGURES = {"fig5": function}, each
function(results) -> (matplotlib figure, [panels.Curve, ...]). What cannot be drawn is said with its reason; a program
of a figure that fails does not keep the others from being drawn.
Exit codes: 0 at least one was drawn, 1 the program of a figure failed, 2 bad input, 4 nothing could be drawn.
"""

import argparse
import csv
import importlib.util
import pathlib
import re
import sys
import traceback

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

try:
    import record
    import style
except ImportError as missing:
    print(
        f"figures.py: {missing}. Run it with /usr/bin/python3 after: "
        "apt-get install python3-matplotlib python3-h5py",
        file=sys.stderr,
    )
    sys.exit(2)


def figures_of(script):
    """FIGURES of one figure.py; of one that cannot be loaded a figure, named after its case, that says so where it is drawn."""
    spec = importlib.util.spec_from_file_location(f"figure_{script.parent.name}", script)
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:  # whatever it is, it is that case's
        failure = error  # `error` ends with this block

        def fail(_):
            raise failure

        return {script.parent.name: fail}
    return module.FIGURES


def all_figures(cases):
    """{"fig5": function, ...} of every case folder that draws: the paper's figures in its order, then the others."""
    found = {}
    for script in sorted(cases.glob("*/figure.py")):
        for name, function in figures_of(script).items():
            if name in found:
                raise SystemExit(f"figures.py: {script} draws {name} a second time")
            found[name] = function

    def place(name):
        number = re.match(r"fig(\d+)", name)
        return (int(number[1]) if number else len(found) + 100, name)

    return {name: found[name] for name in sorted(found, key=place)}


def write_curves(path, curves, sources):
    """All curves of a figure in one table: panel, curve, x, y and, for fields, the value there."""
    with open(path, "w", newline="", encoding="utf-8") as out:
        out.write("".join(f"# from {source}\n" for source in sources))
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["panel", "curve", "x", "y", "value"])
        for curve in curves:
            for k in range(len(curve.x)):
                value = "" if curve.value is None else f"{curve.value[k]:.9g}"
                table.writerow([curve.panel, curve.name, f"{curve.x[k]:.9g}", f"{curve.y[k]:.9g}", value])


def draw(name, function, results, output):
    """Draw one figure; returns the line that says what became of it, and "drawn", "skipped" or "failed"."""
    style.apply()
    results.used = []
    try:
        figure, curves = function(results)
        sources = list(dict.fromkeys(results.used))
        style.save(figure, output / name, sources)
        write_curves(output / f"{name}.csv", curves, sources)
    except record.Missing as reason:
        return f"{name}: skipped: {reason}", "skipped"
    except Exception as error:  # a fault of this figure's program: the others are drawn all the same
        traceback.print_exc()
        return f"{name}: failed: {type(error).__name__}: {error}", "failed"
    return f"{name}: drawn from {', '.join(sources)}", "drawn"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", help="folder that verify run wrote")
    parser.add_argument("--output", help="where the figures go (default: RESULTS_DIR/figures)")
    parser.add_argument("--only", nargs="+", metavar="FIG", help="only these, as in fig5 fig7a")
    parser.add_argument("--cases", default=HERE.parent / "benchmarks", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        results = record.Results(arguments.results)
    except record.Missing as reason:
        print(f"figures.py: {reason}", file=sys.stderr)
        return 2
    figures = all_figures(arguments.cases)
    unknown = [name for name in arguments.only or [] if name not in figures]
    if unknown:
        print(f"figures.py: no figure {', '.join(unknown)}; there are {', '.join(figures)}", file=sys.stderr)
        return 2
    output = pathlib.Path(arguments.output or results.folder / "figures")
    output.mkdir(parents=True, exist_ok=True)
    became = set()
    for name, function in figures.items():
        if arguments.only is None or name in arguments.only:
            line, fate = draw(name, function, results, output)
            print(line, flush=True)
            became.add(fate)
    return 1 if "failed" in became else 0 if "drawn" in became else 4


if __name__ == "__main__":
    sys.exit(main())
