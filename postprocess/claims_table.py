#!/usr/bin/python3
"""Print what Sec. 3 of the paper says and what the records show, sentence by sentence, or write it into the cases' READMEs.

    claims_table.py RESULTS_DIR             prints every table for which there are records
    claims_table.py RESULTS_DIR --pages     writes them between the lines `<!-- claims: begin -->` and `<!-- claims: end -->` of benchmarks/<case>/README.md

Exit codes: 0 at least one table, 2 bad input, 4 no record for any.
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

import claims  # noqa: E402
import claims_beside  # noqa: E402
import claims_resolved  # noqa: E402
import claims_slender  # noqa: E402
import record  # noqa: E402
from between_marks import write_between_marks  # noqa: E402
from written import program  # noqa: E402



def judged(measure):
    """The table of claims that measure(results) finds."""
    return lambda results: claims.markdown(measure(results))


TABLES = (
    ("Fig. 12", "compress_dendrite", judged(claims.of_figure12)),
    ("Figs. 13 to 15", "compress_dendrite_noise", judged(claims_slender.of_figures13_to_15)),
    ("A dendrite attached to a wall", "wall_galilean", judged(claims_beside.of_wall)),
    ("Viscous dendrites (of Fig. 12; the paper's are those of Figs. 13 to 15)", "compress_dendrite_viscous", judged(claims_beside.of_viscous)),
    ("Beside a slender dendrite whose tip is resolved", "compress_dendrite_slender", claims_resolved.table),
)


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--pages"]):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        results = record.Results(arguments[0])
    except record.Missing as reason:
        print(f"claims_table.py: {reason}", file=sys.stderr)
        return 2
    made = 0
    for title, case, table_of in TABLES:
        results.used = []
        try:
            table = table_of(results)
        except record.Missing as reason:
            print(f"{title}: skipped: {reason}", file=sys.stderr)
            continue
        text = f"{title}, from {', '.join(results.used)}:\n\n{table}"
        if len(arguments) == 2:
            write_between_marks(HERE.parent / "benchmarks" / case / "README.md", "claims", text)
        else:
            print(text)
        made += 1
    return 0 if made else 4


if __name__ == "__main__":
    program("claims_table.py", main)
