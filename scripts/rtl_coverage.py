#!/usr/bin/env python3
"""Sums Verilator's coverage files over all tests, prints a row a module, and says what is left: lines and toggled bits reached, and the
points of tests/cover, which scenes and tests are to reach.

A line is a block of lines, a toggle one bit of a signal that was seen to change both ways; instances of a module and its tests count
together. Packages are left out, they hold no logic of their own, and what is generated.

Holes are closed by a test or explained in tests/cover/explained.toml, one table each:
  [[hole]]
  module = "engine"                 its file without .sv
  point = "flight_full"             or line = 'default: ;' (the text of the line that the block begins at), or signal = "index_o"
  why = "..."
A signal's untoggled bits are then left out of the table. With --check a hole in lines or points that is not explained is a finding, and
so is an explanation of what is no hole.

usage: rtl_coverage.py [--misses] [--check] [--root FOLDER] FILE.dat...        a table, and out/coverage.json;  exit code 1: findings
"""

import argparse
import json
import re
import sys
import tomllib
from collections import defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / "lint"))
from source import Findings, project_root  # noqa: E402

POINT = re.compile(r"^C '(.*)' (\d+)$")
KINDS = {"v_line": "line", "v_branch": "line", "v_toggle": "signal", "v_user": "point"}
HEADS = {"line": "lines", "signal": "toggled bits", "point": "points"}


def points(path):
    """(file, kind, line, what, count) of each point of a coverage file."""
    for row in path.read_text(encoding="utf-8", errors="replace").split("\n"):
        match = POINT.match(row)
        if not match:
            continue
        fields = dict(field.split("\2", 1) for field in match.group(1).split("\1") if "\2" in field)
        kind = KINDS.get(fields.get("page", "").split("/")[0])
        if kind:
            what = fields.get("o", "")
            # Blocks of lines are told apart by their column too.
            yield fields["f"], kind, int(fields["l"]), f"{fields.get('n', '')} {what}" if kind == "line" else what, int(match.group(2))


def percent(reached, total):
    # Rounded down, so that 100 % is all of it.
    return f"{int(1000 * reached / total) / 10:.1f} %" if total else ""


class Explanations:
    """tests/cover/explained.toml, and which of it was of use."""

    def __init__(self, path):
        self.path = path
        holes = tomllib.loads(path.read_text(encoding="utf-8")).get("hole", []) if path.is_file() else []
        self.why, self.used = {}, set()
        for hole in holes:
            kinds = [kind for kind in HEADS if kind in hole]
            if len(kinds) != 1 or not hole.get("module") or not hole.get("why") or len(hole) != 3:
                sys.exit(f"{path}: a hole has a module, one of line, signal or point, and a why: {hole}")
            self.why[hole["module"], kinds[0], hole[kinds[0]]] = hole["why"]

    def of(self, module, kind, what):
        key = module, kind, what
        if key in self.why:
            self.used.add(key)
        return self.why.get(key)

    def unused(self):
        return sorted(set(self.why) - self.used)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--misses", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--root", type=Path, default=project_root())
    parser.add_argument("files", type=Path, nargs="+")
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    findings = Findings("coverage")
    explained = Explanations(root / "tests/cover/explained.toml")

    counts = defaultdict(int)
    for file in arguments.files:
        for source, kind, line, what, count in points(file):
            path = root / source
            path = path.relative_to(root) if path.is_relative_to(root) else path
            # What the points themselves are made of is not what they are about.
            bound = path.parts[:2] == ("tests", "cover")
            if bound == (kind == "point") and (bound or path.parts[0] == "rtl") and not path.stem.endswith("_pkg"):
                counts[str(path), kind, line, what] += count

    texts = {}
    modules = defaultdict(lambda: {kind: [0, 0] for kind in HEADS})
    report = defaultdict(dict)
    left = []
    for (path, kind, line, what), count in sorted(counts.items()):
        module = Path(path).stem.removesuffix("_cover")
        name = what
        if kind == "line":
            lines = texts.setdefault(path, (root / path).read_text(encoding="utf-8").split("\n"))
            name = lines[line - 1].strip() if line <= len(lines) else ""
        if kind == "signal":
            name = re.match(r"\w+", what).group() if re.match(r"\w+", what) else what
        if kind == "point":
            report[module][what] = count
        why = None if count else explained.of(module, kind, name)
        if not count and (kind != "signal" or arguments.misses):
            left.append(f"{path}:{line}: {kind}: {name if kind != 'signal' else what}" + (f" ({why})" if why else ""))
        if arguments.check and not count and not why and kind != "signal":
            findings.add(f"{path}:{line}", kind, f"never reached, and not explained: {name}")
        if kind == "signal" and not count and why:
            continue
        modules[module][kind][0] += count > 0
        modules[module][kind][1] += 1
    if arguments.check:
        for module, kind, what in explained.unused():
            findings.add(explained.path.relative_to(root), "explanation", f"of what is no hole: {module}, {kind} {what}")

    print(f"| module | {' | '.join(HEADS.values())} |\n|---|{'--:|' * len(HEADS)}")
    total = {kind: [0, 0] for kind in HEADS}
    for module, row in sorted(modules.items()):
        for kind, (reached, of) in row.items():
            total[kind][0] += reached
            total[kind][1] += of
        cells = [percent(*row[kind]) if kind != "point" else f"{row[kind][0]} of {row[kind][1]}" if row[kind][1] else "" for kind in HEADS]
        print(f"| `{module}` | {' | '.join(cells)} |")
    print(f"| all | {percent(*total['line'])} | {percent(*total['signal'])} | {total['point'][0]} of {total['point'][1]} |")
    if left:
        print("\nnot reached:", *left, sep="\n  ")
    (root / "out").mkdir(exist_ok=True)
    summary = {m: {HEADS[k]: {"reached": a, "of": b} for k, (a, b) in row.items()} | {"hits": report[m]} for m, row in sorted(modules.items())}
    (root / "out/coverage.json").write_text(json.dumps(summary, indent=1) + "\n")
    return findings.finish(f"{len(counts)} lines, bits and points") if arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
