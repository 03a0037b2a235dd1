#!/usr/bin/env python3
"""Sums Verilator's coverage files over all tests, prints a row a module, and says what is left: lines and toggled bits reached, and the
points of tests/cover, which scenes and tests are to reach.

A line is a block of lines, a toggle one bit of a signal that was seen to change; instances of a module and its tests count together. What
bits changed in files NAME.begin.dat (tb/cosim/coverage.hpp) is taken off again: random words before reset are no signals. Packages
are left out, they hold no logic of their own, and what is generated.

Holes are closed by a test or explained in tests/cover/explained.toml, one table each:
  [[hole]]
  module = "engine"                 its file without .sv, or a list of them
  point = "flight_full"             or line = 'default: ;' (the text of the line that the block begins at),
                                    or signal = "index_o[1*]", bits of a signal, * for anything, or a list of such
  why = "..."
Bits that are explained are left out of the table. With --check a hole that is not explained is a finding, and so is an explanation of a line
or point that is no hole, or of bits that are not there: which bits of a wide signal stay holes depends on the number of vectors.

Two last lists name the signals without a counter: those that are wider than Verilator was told to count (rtl/CMakeLists.txt), and those in
blocks of a module (generate blocks above all), where Verilator 5.006 counts none. What the tests see of them is what is compared.

usage: rtl_coverage.py [--misses] [--check] [--root FOLDER] FILE.dat...
       a table, and out/coverage.json;  exit code 1: findings
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
DECLARED = re.compile(r"\s*(?:input\s+|output\s+)?(?:logic|T|\w+_[te])\b(?:\s+signed)?(?:\s*\[[^\]]*\])*\s+(\w[^;=()]*?)\s*[,;]?\s*(?://.*)?$")
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
        self.patterns = defaultdict(list)
        for hole in holes:
            kinds = [kind for kind in HEADS if kind in hole]
            if len(kinds) != 1 or not hole.get("module") or not hole.get("why") or len(hole) != 3:
                sys.exit(f"{path}: a hole has a module, one of line, signal or point, and a why: {hole}")
            modules, names = (of if isinstance(of, list) else [of] for of in (hole["module"], hole[kinds[0]]))
            for key in ((module, kinds[0], name) for module in modules for name in names):
                self.why[key] = hole["why"]
                if kinds[0] == "signal":
                    # Brackets are those of bits, so only * stands for something else.
                    self.patterns[key[0]].append((re.compile(".*".join(map(re.escape, key[2].split("*")))), key))

    def of(self, module, kind, what):
        keys = [(module, kind, what)]
        if kind == "signal":
            keys = [key for pattern, key in self.patterns[module] if pattern.fullmatch(what)]
        keys = [key for key in keys if key in self.why]
        self.used.update(keys)
        return self.why[keys[0]] if keys else None

    def unused(self):
        return sorted(set(self.why) - self.used)


def declared(text):
    """(name, whether within a block) of the ports and signals of a module, as this project writes them: a declaration a line."""
    names, within, depth = [], None, 0
    for line in text.split("\n"):
        line = line.split("//")[0]
        if re.match(r"\s*(typedef (struct|enum)|function)\b", line):
            within = "endfunction" if "function" in line else "}"
        if within:
            if re.match(rf"\s*{re.escape(within)}", line):
                within = None
            continue
        match = DECLARED.match(line)
        if match:
            names += [(name, depth > 0) for name in re.findall(r"\w+", re.sub(r"\[[^\]]*\]", "", match.group(1)))]
        depth += len(re.findall(r"\bbegin\b", line)) - len(re.findall(r"\bend\b", line))
    return names


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
        at_begin = file.name.endswith(".begin.dat")
        for source, kind, line, what, count in points(file):
            path = root / source
            path = path.relative_to(root) if path.is_relative_to(root) else path
            # What the points themselves are made of is not what they are about.
            bound = path.parts[:2] == ("tests", "cover")
            if bound == (kind == "point") and (bound or path.parts[0] == "rtl") and not path.stem.endswith("_pkg"):
                if not at_begin or kind == "signal":
                    counts[str(path), kind, line, what] += -count if at_begin else count

    texts = {}
    modules = defaultdict(lambda: {kind: [0, 0] for kind in HEADS})
    report = defaultdict(dict)
    left = []
    never = defaultdict(list)
    counted = defaultdict(set)
    for (path, kind, line, what), count in sorted(counts.items()):
        module = Path(path).stem.removesuffix("_cover")
        name = what
        if kind == "line":
            lines = texts.setdefault(path, (root / path).read_text(encoding="utf-8").split("\n"))
            name = lines[line - 1].strip() if line <= len(lines) else ""
        if kind == "signal":
            counted[path].add(re.match(r"\w*", what).group())
        if kind == "point":
            report[module][what] = count
        why = explained.of(module, kind, name) if kind == "signal" or not count else None
        why = None if count else why
        if not count and (kind != "signal" or not why or arguments.misses):
            left.append(f"{path}:{line}: {kind}: {name}" + (f" ({why})" if why else ""))
        if not count and not why:
            never[f"{path}:{line}", kind, name if kind != "signal" else re.match(r"\w*", what).group()].append(what)
        if kind == "signal" and not count and why:
            continue
        modules[module][kind][0] += count > 0
        modules[module][kind][1] += 1
    if arguments.check:
        for (where, kind, name), bits in never.items():
            said = f"never reached, and not explained: {name}"
            if kind == "signal":
                said = f"never changed, and not explained: {', '.join(bits[:8])}" + (f" and {len(bits) - 8} more bits" if len(bits) > 8 else "")
            findings.add(where, kind, said)
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
    uncounted = {False: [], True: []}
    for path, names in sorted(counted.items()):
        rest = defaultdict(list)
        for name, in_block in declared((root / path).read_text(encoding="utf-8")):
            if name not in names and name not in rest[in_block]:
                rest[in_block].append(name)
        for in_block, names in rest.items():
            uncounted[in_block].append(f"{path}: {', '.join(names)}")
    for in_block, why in ((False, "too wide to be counted (rtl/CMakeLists.txt)"), (True, "in blocks, where Verilator counts no bits")):
        if uncounted[in_block] and (arguments.check or arguments.misses):
            print(f"\n{why}:", *uncounted[in_block], sep="\n  ")
    (root / "out").mkdir(exist_ok=True)
    summary = {m: {HEADS[k]: {"reached": a, "of": b} for k, (a, b) in row.items()} | {"hits": report[m]} for m, row in sorted(modules.items())}
    (root / "out/coverage.json").write_text(json.dumps(summary, indent=1) + "\n")
    return findings.finish(f"{len(counts)} lines, bits and points") if arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
