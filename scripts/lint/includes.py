#!/usr/bin/env python3
"""Who may include what, and which words the kernels do not know.

  hls/      includes hls/ alone; of the standard library only <cstdint>, <climits> and <cstddef>, and anything else
            (an assertion, a queue) between #ifndef RELIEVO_SYNTHESIS and #endif; the headers of a synthesis tool only in
            hls/core, where a tool's types are given the project's names. No float, exception, heap, virtual, RTTI.
  golden/   includes golden/, GLM, the standard library, and of hls/ only core/formats.hpp and core/record.hpp.
  layers    core <- surface <- edge, sweep, patch (which do not know each other) <- top.
  tb/       is included by tb/ and tests/ alone; tests/ by nobody else.

usage: includes.py [--root FOLDER]
"""

import argparse
import re
import sys
from pathlib import Path

from source import Findings, code_lines, project_root, sources

KERNEL_STANDARD = {"cstdint", "climits", "cstddef"}
TOOL_HEADER = re.compile(r"^(ap_\w+|hls_\w+|ac_\w+)\.h$")
GOLDEN_FROM_HLS = {"hls/core/formats.hpp", "hls/core/record.hpp"}
# layer -> layers it may include
LAYERS = {
    "core": {"core"},
    "surface": {"core", "surface"},
    "edge": {"core", "surface", "edge"},
    "sweep": {"core", "surface", "sweep"},
    "patch": {"core", "surface", "patch"},
    "top": {"core", "surface", "edge", "sweep", "patch", "top"},
}
FORBIDDEN = {
    "float": "float",
    "double": "float",
    "throw": "exception",
    "try": "exception",
    "catch": "exception",
    "new": "heap",
    "delete": "heap",
    "malloc": "heap",
    "virtual": "virtual",
    "dynamic_cast": "rtti",
    "typeid": "rtti",
    "__int128": "wide integer",
    "goto": "goto",
}
WORD = re.compile(r"\b(?:" + "|".join(map(re.escape, FORBIDDEN)) + r")\b")
DELETED = re.compile(r"=\s*delete\b")
FLOAT_LITERAL = re.compile(r"(?<![\w.])(?:\d+\.\d*|\.\d+|\d+[eE][+-]?\d+)(?:[eE][+-]?\d+)?[fFlL]?(?![\w.])")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
DIRECTIVE = re.compile(r"^\s*#\s*(ifndef|ifdef|if|elif|else|endif)\b(.*)")
NOT_SYNTHESIS = re.compile(r"^\s*!\s*defined\s*\(?\s*RELIEVO_SYNTHESIS\s*\)?\s*$")


class Regions:
    """Follows the conditionals of a file: is this line compiled in simulation alone?"""

    def __init__(self):
        self.stack = []

    def step(self, line):
        match = DIRECTIVE.match(line)
        if not match:
            return
        word, rest = match.groups()
        if word == "endif":
            if self.stack:
                self.stack.pop()
        elif word in ("else", "elif"):
            # The branch after `#ifdef RELIEVO_SYNTHESIS` is simulation; the one after `#ifndef RELIEVO_SYNTHESIS` is not.
            if self.stack:
                self.stack[-1] = "simulation" if word == "else" and self.stack[-1] == "synthesis" else "any"
        elif word == "ifndef" and rest.strip() == "RELIEVO_SYNTHESIS" or word == "if" and NOT_SYNTHESIS.match(rest):
            self.stack.append("simulation")
        elif word == "ifdef" and rest.strip() == "RELIEVO_SYNTHESIS" or word == "if" and rest.split() == ["defined(RELIEVO_SYNTHESIS)"]:
            self.stack.append("synthesis")
        else:
            self.stack.append("any")

    def simulation(self):
        return "simulation" in self.stack


def check_kernel_include(findings, place, path, quoted, angled, simulation):
    if quoted:
        if not quoted.startswith("hls/"):
            findings.add(place, "include", f'hls/ includes hls/ alone, not "{quoted}"')
    elif TOOL_HEADER.match(angled):
        if path.parts[1] != "core":
            findings.add(place, "include", f"only hls/core gives a tool's types their names here, so <{angled}> does not belong")
    elif not simulation and angled not in KERNEL_STANDARD:
        findings.add(place, "include", f"<{angled}> in a kernel: only {sorted(KERNEL_STANDARD)} outside #ifndef RELIEVO_SYNTHESIS")


def check_golden_include(findings, place, quoted, angled):
    if quoted and not quoted.startswith("golden/") and quoted not in GOLDEN_FROM_HLS:
        findings.add(place, "include", f'golden/ is written from the definition: "{quoted}" is not for it')
    if angled and not angled.startswith("glm/") and not re.fullmatch(r"[a-z_0-9]+", angled):
        findings.add(place, "include", f"golden/ includes GLM and the standard library, not <{angled}>")


def check_layer(findings, place, path, quoted):
    parts = Path(quoted).parts
    if len(path.parts) < 3 or path.parts[0] not in ("hls", "golden") or parts[0] not in ("hls", "golden") or len(parts) < 3:
        return
    if path.parts[1] not in LAYERS:
        findings.add(place, "layer", f"{path.parts[1]} is no layer")
    elif parts[1] not in LAYERS[path.parts[1]]:
        findings.add(place, "layer", f'{path.parts[1]} must not know {parts[1]}: "{quoted}"')


def check_words(findings, place, line, simulation):
    if line.lstrip().startswith("#"):
        return
    for match in WORD.finditer(DELETED.sub("", line)):
        word = match.group(0)
        # A simulation-only part may use the heap and exceptions of the host; numbers stay integers everywhere.
        if not simulation or FORBIDDEN[word] == "float":
            findings.add(place, FORBIDDEN[word], f"`{word}` in a kernel")
    if FLOAT_LITERAL.search(line):
        findings.add(place, "float", "a floating-point literal in a kernel")


def check_file(findings, root, path):
    regions = Regions()
    tree = path.parts[0]
    for number, line in enumerate(code_lines((root / path).read_text(encoding="utf-8")), 1):
        place = f"{path}:{number}"
        regions.step(line)
        include = INCLUDE.match(line)
        if include:
            quoted, angled = include.groups()
            if quoted and quoted.startswith("."):
                findings.add(place, "include", f'paths start at the root of the project, not "{quoted}"')
            if quoted and quoted.startswith("tests/") and tree != "tests":
                findings.add(place, "include", f'nothing but tests/ includes tests/: "{quoted}"')
            if quoted and quoted.startswith("tb/") and tree not in ("tb", "tests"):
                findings.add(place, "include", f'nothing but tb/ and tests/ includes tb/: "{quoted}"')
            if tree == "hls":
                check_kernel_include(findings, place, path, quoted, angled, regions.simulation())
            if tree == "golden":
                check_golden_include(findings, place, quoted, angled)
            if quoted:
                check_layer(findings, place, path, quoted)
        elif tree == "hls":
            check_words(findings, place, line, regions.simulation())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=project_root())
    root = parser.parse_args().root
    findings = Findings("include rules")
    files = sources(root, "hls", "golden", "tb", "tests")
    files = [p for p in files if p.parts[:2] != ("tests", "mutants")]
    for path in files:
        check_file(findings, root, path)
    return findings.finish(f"{len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
