"""What the gates and flows of rtl/ share: its packages in an order that compiles, its modules, and what a module is made of."""

import os
import re
import sys
from pathlib import Path

_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_PACKAGE = re.compile(r"\b(\w+_pkg)\s*::")
_WORD = re.compile(r"\b[a-z]\w*\b")


def code(path):
    """The text without comments."""
    return _COMMENT.sub(" ", path.read_text(encoding="utf-8"))


def header(path):
    """The lines of the comment that a file begins with, without their slashes."""
    lines = []
    for line in path.read_text(encoding="utf-8").split("\n"):
        if not line.startswith("//"):
            break
        lines.append(line[2:].strip())
    return lines


def generated(root, pattern):
    """What scripts/registers.sh has made of rtl/top/*.rdl."""
    return sorted((root / os.environ.get("RELIEVO_BUILD", "build") / "registers").glob(pattern))


def _below(root, path):
    return path.relative_to(root) if path.is_relative_to(root) else path


def packages(root, wanted=None):
    """The packages of rtl/ (of these names, generated ones too, and what they import), the imported before those that import, as paths
    below root."""
    found = {path.stem: path for path in sorted((root / "rtl").glob("*/*_pkg.sv"))}
    if wanted is not None:
        found |= {path.stem: path for path in generated(root, "*_pkg.sv")}
    ordered = []

    def visit(name):
        if name not in found or found[name] in ordered:
            return
        for imported in sorted(set(_PACKAGE.findall(code(found[name]))) - {name}):
            visit(imported)
        ordered.append(found[name])

    for name in found if wanted is None else sorted(wanted):
        visit(name)
    return [_below(root, path) for path in ordered]


def modules(root):
    """Every module of rtl/: a file each, as paths below root."""
    return sorted(path.relative_to(root) for path in (root / "rtl").glob("*/*.sv") if not path.stem.endswith("_pkg"))


def made_of(root, module):
    """The packages and modules that a module reaches, itself last, as paths below root."""
    known = {path.stem: path for path in modules(root)}
    known |= {path.stem: _below(root, path) for path in generated(root, "*_regblock.sv")}
    reached, named, waiting = [], set(), [module]
    while waiting:
        path = waiting.pop()
        if path in reached:
            continue
        reached.append(path)
        text = code(root / path)
        named |= set(_PACKAGE.findall(text))
        waiting += [known[word] for word in sorted(set(_WORD.findall(text))) if word in known]
    return packages(root, named) + reached[::-1]


if __name__ == "__main__":
    print(*made_of(Path.cwd(), Path(sys.argv[1])), sep="\n")
