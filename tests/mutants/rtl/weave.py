#!/usr/bin/env python3
"""Weaves the mutants of the circuits into copies of their sources, each behind a switch that is set when a model is constructed.

usage: weave.py --source ROOT --out FOLDER MUTANT...

    an expression   ((active_mutant == N) ? (broken) : (original))
    a statement     begin if (active_mutant == N) begin broken end else begin original end end

FOLDER gets rtl/TREE/MODULE.sv of the sources that have mutants. A mutant that does not fit its source is left
out and said; its test fails then (run_mutant.py). Files that would stay the same are not touched.
"""

import argparse
import re
import sys
from pathlib import Path

from mutant import Broken, occurs_once, read_mutant

# Not every build parameter has the part in which a mutant sits.
DECLARATION = """  // verilator lint_off UNUSEDSIGNAL
  int active_mutant = $c32("relievo_active_mutant()");  // active.cpp
  // verilator lint_on UNUSEDSIGNAL
"""


def form(text):
    if text.startswith("assign "):
        return "assign"
    return "statement" if text.endswith(";") or text.endswith("end") or not text else "expression"


def split_assign(text):
    match = re.fullmatch(r"assign\s+(.+?)\s*=\s*(.+);", text, re.DOTALL)
    if not match:
        raise Broken(f"not one assignment: {text}")
    return match.groups()


def woven(original, mutants):
    """The original text with all the mutants that replace it."""
    kind = form(original.strip())
    if any(form(m.broken.strip()) != kind for m in mutants if m.broken.strip() or kind != "statement"):
        raise Broken(f"{mutants[0].name}: both texts must be expressions, assignments or statements")
    if kind == "statement":
        text = "begin "
        for m in mutants:
            text += f"if (active_mutant == {m.number}) begin\n{m.broken}\nend else "
        return f"{text}begin\n{original}\nend end"
    head, tail, right = "", "", original
    broken = [m.broken for m in mutants]
    if kind == "assign":
        left, right = split_assign(original.strip())
        sides = [split_assign(b.strip()) for b in broken]
        if any(side[0] != left for side in sides):
            raise Broken(f"{mutants[0].name}: another left side")
        broken = [side[1] for side in sides]
        head, tail = f"assign {left} = ", ";"
    choice = "".join(f"(active_mutant == {m.number}) ? ({b}) : " for m, b in zip(mutants, broken))
    return f"{head}({choice}({right})){tail}"


def weave(source, mutants, name):
    """The source with its mutants; those that overlap in part cannot be woven together."""
    places = {}
    for m in mutants:
        at = source.index(m.original)
        places.setdefault((at, at + len(m.original)), []).append(m)
    spans = sorted(places)
    for (_, end), (start, _) in zip(spans, spans[1:]):
        if start < end:
            raise Broken(f"{name}: the texts of two mutants overlap: make them the same, or smaller")
    for start, end in reversed(spans):
        source = source[:start] + woven(source[start:end], places[(start, end)]) + source[end:]
    header = re.search(r"^\);\n", source, re.MULTILINE)
    if not header:
        raise Broken(f"{name}: where does the module's header end?")
    return source[: header.end()] + DECLARATION + source[header.end() :]


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("mutants", type=Path, nargs="+")
    args = parser.parse_args()
    try:
        of_file, numbers = {}, {}
        for path in args.mutants:
            m = read_mutant(path)
            if numbers.setdefault(m.number, m.name) != m.name:
                raise Broken(f"{m.name} and {numbers[m.number]} have the same number: rename one")
            of_file.setdefault(m.file, []).append(m)
        wanted = {}
        for name, mutants in of_file.items():
            source = (args.source / name).read_text()
            fitting = []
            for m in mutants:
                reason = occurs_once(m, source)
                if reason:
                    print(f"{m.name}: {reason}")
                else:
                    fitting.append(m)
            if fitting:
                wanted[args.out / name] = weave(source, fitting, name)
        for path in sorted(args.out.glob("rtl/**/*.sv")):
            if path not in wanted:
                path.unlink()
        for path, text in wanted.items():
            write(path, text)
    except Broken as reason:
        sys.exit(f"weave: {reason}")


if __name__ == "__main__":
    main()
