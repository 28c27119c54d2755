#!/usr/bin/python3
"""Print what Sec. 3 of the paper says and what the records show, sentence by sentence, as the tables of the cases' READMEs.

    claims_table.py RESULTS_DIR

Exit codes: 0 at least one table, 2 bad input, 4 no record for any.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

import claims  # noqa: E402
import claims_slender  # noqa: E402
import record  # noqa: E402


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        results = record.Results(sys.argv[1])
    except record.Missing as reason:
        print(f"claims_table.py: {reason}", file=sys.stderr)
        return 2
    printed = 0
    for title, measure in (("Fig. 12", claims.of_figure12), ("Figs. 13 to 15", claims_slender.of_figures13_to_15)):
        results.used = []
        try:
            table = claims.markdown(measure(results))
        except record.Missing as reason:
            print(f"{title}: skipped: {reason}", file=sys.stderr)
            continue
        print(f"{title}, from {', '.join(results.used)}\n\n{table}")
        printed += 1
    return 0 if printed else 4


if __name__ == "__main__":
    sys.exit(main())
