"""Nothing in the tree names one machine: no home or work folders, no host names, no temporary paths outside of scripts that make them."""

import re

import tree

# written in pieces, so that this file does not offend itself
PATHS = re.compile(r"(?<![\w.])/(?:ro" + r"ot|ho" + r"me|wo" + r"rk|farm|Users|mnt)/\w")
HOSTS = re.compile(r"\b(?:\w+\.(?:local|lan)|local" + r"host:\d+)\b")
TEXT = {".cc", ".h", ".py", ".md", ".toml", ".txt", ".cmake", ".sh", ".json", ".html", ".csv", ""}


def offenders_in(path):
    if path.suffix not in TEXT:
        return
    for number, line in enumerate(tree.read(path).split("\n"), 1):
        for pattern in (PATHS, HOSTS):
            if found := pattern.search(line):
                yield f"{path}:{number}: names one machine: {found.group()}"


if __name__ == "__main__":
    tree.finish("paths", [o for path in tree.files() for o in offenders_in(path)])
