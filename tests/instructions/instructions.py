#!/usr/bin/python3
"""Counts instructions of fixed small runs under callgrind: what a scene costs, free of the machine's mood.

    tests/instructions/instructions.py [--accept] [NAME ...]

Only what happens inside simulate() counts (fe::run() of fe_reference), so that set-up and the reading of files do not hide a step that got dearer.
Left out is keep_house(), what both programs do by the clock (checkpoints, rows to be seen, progress): under callgrind a run takes fifty times as
long, on a busy machine more, and its count must not know.
The programs are those of build/instructions, compiled for x86-64-v3 (valgrind knows no wider vectors). Counts hold for one tool chain: compiler,
flags and libraries stand beside them in runs.json. --accept makes what is measured the stored counts, and this tool chain theirs; of another tool
chain all of them have to be accepted together.
"""

import json
import os
import platform
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "build/instructions/bin"
RUNS = Path(__file__).resolve().parent / "runs.json"
INSIDE = {"mpm_pf": "simulate(*", "fe_reference": "fe::run(*"}
BY_THE_CLOCK = "*keep_house(*"  # entered while callgrind collects, it ends that until it is left


def command_of(run, folder):
    """The command of a run, with its record at folder/run.h5."""
    program = PROGRAMS / run.get("program", "mpm_pf")
    command = [str(program), str(ROOT / "benchmarks" / run["scene"]), "--output", folder, "--record", "run", "--threads", "1"]
    for setting in run["set"]:
        command += ["--set", setting]
    return command


def call(command):
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1"}
    environment |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, env=environment, check=False)


def counted(run):
    """Instructions executed inside the functions of that name, their callees included; raises with valgrind's words if there are none."""
    inside = run.get("inside") or INSIDE[run.get("program", "mpm_pf")]
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", f"--toggle-collect={inside}"]
        if inside in INSIDE.values():
            command.append(f"--toggle-collect={BY_THE_CLOCK}")
        command += command_of(run, folder)
        done = call(command)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not found or int(found.group(1)) == 0:
        raise RuntimeError(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stderr[-3000:]}")
    return int(found.group(1))


def count_all(runs):
    """Name -> instructions, as many at once as there are cores."""
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return {run["name"]: number for run, number in zip(runs, pool.map(counted, runs))}


def words(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def tool_chain(run):
    """What the counts of a machine depend on beside our sources: compiler, flags and Eigen as the record of a run tells them, and what it is run
    with. mathematics comes from libc."""
    import h5py  # only here: counting alone needs no module

    with tempfile.TemporaryDirectory() as folder:
        done = call(command_of(run, folder))
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(done.args)}\nended with {done.returncode}:\n{done.stderr[-3000:]}")
        with h5py.File(Path(folder) / "run.h5", "r") as record:
            made = {name: words(record["provenance"].attrs[name]) for name in ("compiler", "flags", "eigen")}
    valgrind = subprocess.run(["valgrind", "--version"], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=True)
    return made | {"libc": " ".join(platform.libc_ver()), "valgrind": valgrind.stdout.strip()}


def differences(stored, now):
    """A sentence for each part of the tool chain that is not the one of the stored counts."""
    return [f"{name}: counts are of {(stored or {}).get(name, 'none')!r}, here is {now[name]!r}" for name in now if (stored or {}).get(name) != now[name]]


def not_accepted(runs):
    """A sentence for each run without a stored count."""
    return [f'{run["name"]}: not accepted yet: tests/instructions/instructions.py --accept "{run["name"]}"' for run in runs if not run.get("instructions")]


def main(arguments):
    accept = "--accept" in arguments
    names = [argument for argument in arguments if argument != "--accept"]
    stored = json.loads(RUNS.read_text())
    unknown = set(names) - {run["name"] for run in stored["runs"]}
    if unknown:
        print(f"no run is called {', '.join(sorted(unknown))}; there are: {', '.join(run['name'] for run in stored['runs'])}", file=sys.stderr)
        return 2
    chosen = [run for run in stored["runs"] if not names or run["name"] in names]
    chain = tool_chain(stored["runs"][0])
    other = differences(stored.get("tool_chain"), chain)
    print("\n".join(other), file=sys.stderr)
    if accept and other and len(chosen) < len(stored["runs"]):
        print("counts of two tool chains do not stand in one file: accept all of them (no NAME)", file=sys.stderr)
        return 2
    numbers = count_all(chosen)
    for run in chosen:  # in the order of the file
        now, before = numbers[run["name"]], run.get("instructions")
        change = f"{100 * (now / before - 1):+.2f} %" if before else "new"
        print(f'{run["name"]:28} {now:14d}  {change}')
        run["instructions"] = now
    if accept:
        RUNS.write_text(json.dumps({"tool_chain": chain, "runs": stored["runs"]}, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
