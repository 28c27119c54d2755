"""What the rule checks share: the project's own files, and how offenders are reported."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = {".cc", ".h", ".py"}


def files():
    """Paths (relative to the root) of all files that git knows or would add; all files where there is no git."""
    try:
        out = subprocess.run(
            ["git", "-C", str(ROOT), "ls-files", "--cached", "--others", "--exclude-standard"], capture_output=True, text=True, check=True
        ).stdout.split("\n")
        found = [Path(line) for line in out if line]
    except (OSError, subprocess.CalledProcessError):
        found = [p.relative_to(ROOT) for p in ROOT.rglob("*") if p.is_file() and p.relative_to(ROOT).parts[0] not in (".git", "build", "results")]
    return sorted({p for p in found if (ROOT / p).is_file()})


def sources():
    return [p for p in files() if p.suffix in SOURCES]


def read(path):
    return (ROOT / path).read_text(errors="replace")


def finish(rule, offenders):
    """Prints every offender; exit code 1 if there is one."""
    for offender in offenders:
        print(f"{rule}: {offender}")
    print(f"{rule}: {len(offenders)} offenders" if offenders else f"{rule}: holds")
    sys.exit(1 if offenders else 0)
