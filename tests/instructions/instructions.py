#!/usr/bin/python3
"""Counts instructions of fixed small runs under callgrind: what a scene costs, free of the machine's mood.

    tests/instructions/instructions.py [--accept] [NAME ...]

Only what happens inside simulate() counts, so that set-up and the reading of files do not hide a step that got dearer. The program is that of
build/instructions, compiled for x86-64-v3 (valgrind knows no wider vectors). --accept makes what is measured the stored counts.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/instructions/bin/mpm_pf"
RUNS = Path(__file__).resolve().parent / "runs.json"


def counted(scene, settings, inside="simulate(*"):
    """Instructions executed inside the functions of that name, their callees included; raises with valgrind's words if there are none."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", f"--toggle-collect={inside}"]
        command += [str(PROGRAM), str(ROOT / "benchmarks" / scene), "--output", folder, "--record", "run", "--threads", "1"]
        for setting in settings:
            command += ["--set", setting]
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, env=environment, check=False)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not found:
        raise RuntimeError(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr[-3000:]}")
    return int(found.group(1))


def count_all(runs):
    """Name -> instructions, as many at once as there are cores."""
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        numbers = pool.map(lambda run: counted(run["scene"], run["set"], run.get("inside", "simulate(*")), runs)
        return {run["name"]: number for run, number in zip(runs, numbers)}


def main(arguments):
    accept = "--accept" in arguments
    names = [argument for argument in arguments if argument != "--accept"]
    stored = json.loads(RUNS.read_text())
    chosen = [run for run in stored["runs"] if not names or run["name"] in names]
    numbers = count_all(chosen)
    for run in chosen:  # in the order of the file
        now, before = numbers[run["name"]], run.get("instructions")
        change = f"{100 * (now / before - 1):+.2f} %" if before else "new"
        print(f'{run["name"]:28} {now:14d}  {change}')
        run["instructions"] = now
    if accept:
        RUNS.write_text(json.dumps(stored, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
