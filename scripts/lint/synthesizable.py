#!/usr/bin/env python3
"""Is every entry point a circuit? Judged on LLVM IR, without a vendor's tool.

Each file is compiled as C++14, freestanding, with RELIEVO_SYNTHESIS and RELIEVO_LINT, no exceptions, no RTTI. Before any
optimisation these are refused:
  float                   a floating-point type, constant or instruction
  heap                    new, delete, malloc and their kin
  recursion               a circle in the call graph
  indirect call           a call through a pointer
  virtual call            a table of virtual functions
  unresolved external     a function or an object that no header of ours defines
  exception, rtti         throw, try, typeid, dynamic_cast
  wide integer            more than 64 bits
  dynamic stack           an array whose size is not constant
  dynamic initialisation  a global that needs code before the entry point
  inline assembly
  not an addition         a multiplication, division or remainder in a function with RELIEVO_ADDITIONS_ONLY("what"), or below it
Then scalar evolution bounds the loops, after inlining as much as that takes:
  unbounded loop          no constant largest count, or one above LARGEST_COUNT (which only says how wide the counter is);
                          a loop that holds RELIEVO_STREAMING_LOOP("why") is exempt

usage: synthesizable.py [--include FOLDER] [--list] FILE.cpp...     default: hls/top/*.cpp
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from llvm_ir import Module, types_only
from source import Findings, project_root

LARGEST_COUNT = 1 << 16
INLINE_THRESHOLDS = (100, 1000000)
MARKER = "relievo_streaming_loop"
ADDITIONS_ONLY = "relievo_additions_only"
NOT_AN_ADDITION = re.compile(r"= (mul|[su]div|[su]rem)\b")
FLOAT = re.compile(r"\b(half|bfloat|float|double|x86_fp80|fp128|ppc_fp128)\b")
WIDE = re.compile(r"\bi(\d+)\b")
HEAP = re.compile(r"^(_Zn[wa]|_Zd[la]|malloc$|calloc$|realloc$|free$|aligned_alloc$|posix_memalign$|strdup$)")
COMPILE = "-std=c++14 -ffreestanding -fno-exceptions -fno-rtti -DRELIEVO_SYNTHESIS -DRELIEVO_LINT -O1 -fno-finite-loops"
TO_IR = "-Xclang -disable-llvm-passes -fno-discard-value-names -gline-tables-only -S -emit-llvm -o -"
PASSES = (
    "cgscc(inline),globaldce,function(sroa,early-cse,simplifycfg,instcombine,loop-simplify,lcssa,"
    "loop(loop-rotate),instcombine,simplifycfg,loop-simplify,lcssa,loop(indvars),print<loops>,print<scalar-evolution>)"
)


def tool(name):
    for candidate in (f"{name}-14", name):
        if shutil.which(candidate):
            return candidate
    sys.exit(f"synthesizable.py: {name} (LLVM 14) is not on PATH")


class Checker:
    def __init__(self, include, findings):
        self.include = include
        self.findings = findings
        self.clang = tool("clang++")
        self.opt = tool("opt")
        self.streaming = []
        self.additions_only = set()

    def check(self, path):
        command = [self.clang, *COMPILE.split(), *TO_IR.split(), f"-I{self.include}", str(path)]
        compiled = subprocess.run(command, capture_output=True, text=True, check=False)
        if compiled.returncode:
            self.refused(path, compiled.stderr)
            return
        module = Module(compiled.stdout)
        before = len(self.findings.rows)
        self.globals(path, module)
        for function in module.functions.values():
            self.types(path, module, function)
            self.calls(path, module, function)
        self.additions(path, module)
        for group in module.strongly_connected():
            where = module.place(module.functions[group[0]].head) or path
            self.findings.add(where, "recursion", " -> ".join(group))
        # A circle or an unknown callee can't be inlined away; its own finding says more than the loops behind it.
        if len(self.findings.rows) == before:
            self.loops(path, module, compiled.stdout)

    def refused(self, path, messages):
        for line in messages.split("\n"):
            match = re.match(r"(\S+?:\d+):\d+: (?:fatal )?error: (.*)", line)
            if not match:
                continue
            place, message = match.groups()
            kind = "does not compile"
            if "exceptions disabled" in message:
                kind = "exception"
            elif "rtti" in message.lower():
                kind = "rtti"
            self.findings.add(place, kind, message)
        if "error:" not in messages:
            self.findings.add(path, "does not compile", messages.strip())

    def globals(self, path, module):
        for line in module.globals:
            name = line.split(" ", 1)[0]
            if name.startswith("@_ZTV"):
                self.findings.add(path, "virtual call", f"{name} is a table of virtual functions")
            elif name == "@llvm.global_ctors":
                self.findings.add(path, "dynamic initialisation", "an object outside of the entry point needs code to be initialised")
            elif re.search(r"= (?:dso_local )?external\b", line):
                self.findings.add(path, "unresolved external", name)
            if FLOAT.search(types_only(line)):
                self.findings.add(path, "float", f"{name} is a floating-point object")

    def types(self, path, module, function):
        for line in [function.head, *function.lines]:
            bare = types_only(line)
            place = module.place(line) or module.place(function.head) or path
            if FLOAT.search(bare):
                self.findings.add(place, "float", FLOAT.search(bare).group(0))
            if any(int(width) > 64 for width in WIDE.findall(bare)):
                self.findings.add(place, "wide integer", "more than 64 bits")
            if re.search(r"= alloca\b.*, i\d+ %", line):
                self.findings.add(place, "dynamic stack", "an array whose size is not constant")

    def calls(self, path, module, function):
        for callee, line in function.calls():
            place = module.place(line) or path
            if callee is None:
                self.findings.add(place, "indirect call", "through a pointer")
            elif callee == "asm":
                self.findings.add(place, "inline assembly", "")
            elif HEAP.match(callee):
                self.findings.add(place, "heap", callee)
            elif callee.startswith("llvm.mem"):
                if not re.search(r", i\d+ \d+, i1 ", line):
                    self.findings.add(place, "unbounded loop", f"{callee} of a size that is not constant")
            elif callee not in module.functions and not callee.startswith("llvm.") and callee not in (MARKER, ADDITIONS_ONLY):
                self.findings.add(place, "unresolved external", callee)

    def additions(self, path, module):
        marked = [f for f in module.functions.values() if any(callee == ADDITIONS_ONLY for callee, _ in f.calls())]
        self.additions_only |= {f.name for f in marked}
        below, seen = marked, set()
        while below:
            function = below.pop()
            if function.name in seen:
                continue
            seen.add(function.name)
            below += [module.functions[callee] for callee, _ in function.calls() if callee in module.functions]
            for line in function.lines:
                operation = NOT_AN_ADDITION.search(line)
                if operation:
                    place = module.place(line) or path
                    self.findings.add(place, "not an addition", f"`{operation.group(1)}` where only additions are promised")

    def loops(self, path, module, text):
        entries = [f.name for f in module.functions.values() if not re.search(r"\b(linkonce|internal|private|available)", f.linkage)]
        if not entries:
            self.findings.add(path, "no entry point", "a kernel has one function of external linkage")
            return
        # A bound found in a function as it stands holds wherever it is called. Only what this leaves open is worth the time of
        # putting everything into the entry point, where the arguments of a call may give the bound.
        for threshold in INLINE_THRESHOLDS:
            open_loops, streaming = self.unbounded(path, entries, text, threshold)
            if not open_loops:
                break
        self.streaming += streaming
        for place, kind, message in open_loops:
            self.findings.add(place, kind, message)

    def unbounded(self, path, entries, text, threshold):
        command = [
            self.opt,
            "-S",
            f"-passes=internalize,{PASSES}",
            f"-internalize-public-api-list={','.join(entries)}",
            f"-inline-threshold={threshold}",
            f"-inlinehint-threshold={threshold}",
            "-disable-loop-unrolling",
        ]
        run = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
        if run.returncode:
            return [(path, "does not compile", f"opt: {run.stderr.strip()[:200]}")], []
        inlined = Module(run.stdout)
        found, streaming = [], []
        for name, report in split_reports(run.stderr):
            function = inlined.functions.get(name)
            if function:
                self.function_loops(path, inlined, function, report, found, streaming)
        return found, streaming

    def function_loops(self, path, module, function, report, found, streaming):
        blocks = function.blocks()
        exempt = {}
        members = innermost(report["loops"])
        for block, lines in blocks.items():
            for line in lines:
                if f"@{MARKER}(" in line and block in members:
                    exempt[members[block]] = module.place(line) or str(path)
        for header, count in report["counts"].items():
            if count is not None and count < LARGEST_COUNT:
                continue
            if header in exempt:
                streaming.append(f"streaming loop at {exempt[header]}")
                continue
            lines = blocks.get(header, [])
            place = next((p for p in map(module.place, lines) if p), path)
            what = "no constant bound" if count is None else f"{count} turns are only the width of its counter"
            found.append((place, "unbounded loop", f"{what} (in {function.name})"))


def split_reports(text):
    """(function, {"loops": [(depth, [blocks])], "counts": {header: largest count or None}}) from opt's printed analyses."""
    reports = {}
    name = None
    # The loops of a function are printed before its name is, their counts after it.
    loops = []
    for line in text.split("\n"):
        match = re.match(r"\s*(?:Parallel )?Loop at depth (\d+) containing: (.*)", line)
        if match:
            blocks = [re.sub(r"<\w+>", "", b).strip().lstrip("%").strip('"') for b in match.group(2).split(",")]
            loops.append((int(match.group(1)), blocks))
            continue
        match = re.match(r"Determining loop execution counts for: @(.*)", line)
        if match:
            name = match.group(1).strip('"')
            reports[name] = {"loops": loops, "counts": {}}
            loops = []
            continue
        if name is None:
            continue
        match = re.match(r"Loop %(.*?): .*max backedge-taken count(?: is (.*)|\.)", line)
        if match and "Predicted" not in line:
            header = match.group(1).strip('"')
            value = match.group(2)
            number = int(value) if value and re.fullmatch(r"-?\d+", value.strip()) else None
            reports[name]["counts"][header] = None if number is None or number < 0 else number
    return reports.items()


def innermost(loops):
    """block -> header of the innermost loop that holds it"""
    owner = {}
    for _, blocks in sorted(loops, key=lambda entry: entry[0]):
        for block in blocks:
            owner[block] = blocks[0]
    return owner


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--include", type=Path, default=project_root())
    parser.add_argument("--list", action="store_true", help="print the streaming loops too")
    parser.add_argument("files", type=Path, nargs="*")
    arguments = parser.parse_args()
    os.chdir(arguments.include)
    files = arguments.files or sorted(Path("hls/top").glob("*.cpp"))
    findings = Findings("synthesizability")
    checker = Checker(arguments.include, findings)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(checker.check, files))
    if arguments.list:
        print("\n".join(sorted(set(checker.streaming))))
    return findings.finish(
        f"{len(files)} entry points, {len(set(checker.streaming))} streaming loops, {len(checker.additions_only)} functions of additions only"
    )


if __name__ == "__main__":
    sys.exit(main())
