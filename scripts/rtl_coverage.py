#!/usr/bin/env python3
"""Sums Verilator's coverage files over all tests and prints a row a module: lines and toggled bits reached.

A point is a block of lines, or one bit of a signal that has been seen to change; the instances of a module and its tests count
together. Packages are left out: they hold no logic of their own.

usage: rtl_coverage.py [--misses] FILE.dat...        a table, and out/coverage.json
"""

import argparse
import json
import re
import sys
from collections import defaultdict
from pathlib import Path

POINT = re.compile(r"^C '(.*)' (\d+)$")
KINDS = {"v_line": "lines", "v_branch": "lines", "v_toggle": "toggles"}


def points(path):
    """(file, kind, line, what, count) of each point of a coverage file."""
    for row in path.read_text(encoding="utf-8", errors="replace").split("\n"):
        match = POINT.match(row)
        if not match:
            continue
        fields = dict(field.split("\2", 1) for field in match.group(1).split("\1") if "\2" in field)
        kind = KINDS.get(fields.get("page", "").split("/")[0])
        if kind:
            yield fields["f"], kind, int(fields["l"]), f"{fields.get('n', '')} {fields.get('o', '')}", int(match.group(2))


def percent(reached, total):
    # Rounded down, so that 100 % is all of it.
    return f"{int(1000 * reached / total) / 10:.1f} %" if total else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--misses", action="store_true")
    parser.add_argument("files", type=Path, nargs="+")
    arguments = parser.parse_args()
    root = Path(__file__).resolve().parents[1]

    counts = defaultdict(int)
    for file in arguments.files:
        for source, kind, line, what, count in points(file):
            path = Path(source).resolve()
            path = path.relative_to(root) if path.is_relative_to(root) else path
            if not path.stem.endswith("_pkg"):
                counts[str(path), kind, line, what] += count
    rows = defaultdict(lambda: {"lines": [0, 0], "toggles": [0, 0]})
    for (path, kind, _, _), count in counts.items():
        rows[path][kind][0] += count > 0
        rows[path][kind][1] += 1

    if arguments.misses:
        for (path, kind, line, what), count in sorted(counts.items()):
            if not count:
                print(f"{path}:{line}: {kind}: {what.split(' ', 1)[1]}")
    print("| module | lines | toggled bits |\n|---|--:|--:|")
    total = {"lines": [0, 0], "toggles": [0, 0]}
    for path in sorted(rows):
        for kind, (reached, of) in rows[path].items():
            total[kind][0] += reached
            total[kind][1] += of
        print(f"| `{path}` | {' | '.join(percent(*rows[path][kind]) for kind in ('lines', 'toggles'))} |")
    print(f"| all | {' | '.join(percent(*total[kind]) for kind in ('lines', 'toggles'))} |")
    report = {path: {kind: {"reached": a, "of": b} for kind, (a, b) in row.items()} for path, row in sorted(rows.items())}
    Path(root / "out/coverage.json").write_text(json.dumps(report, indent=1) + "\n")


if __name__ == "__main__":
    sys.exit(main())
