"""Each of the paper's Eqs. (1) to (6) is cited, as `Eq. (n)` in a comment, on a line of mpm_pf that computes it."""

import re

import tree


def cited():
    """Number -> places of `// ... Eq. (n)` comments beside or above code in mpm_pf's .cc and .h files."""
    places = {}
    for path in tree.sources():
        if path.parts[0] != "mpm_pf" or path.suffix == ".py":
            continue
        for number, line in enumerate(tree.read(path).split("\n"), 1):
            comment = line.split("//", 1)[1] if "//" in line else ""
            for first, last in re.findall(r"Eqs?\. \((\d)\)(?:\s*(?:-|to|and)\s*\((\d)\))?", comment):
                for equation in range(int(first), int(last or first) + 1):
                    places.setdefault(equation, []).append(f"{path}:{number}")
    return places


if __name__ == "__main__":
    found = cited()
    tree.finish("equations", [f"Eq. ({n}) is cited nowhere in mpm_pf" for n in range(1, 7) if n not in found])
