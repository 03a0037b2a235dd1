#!/usr/bin/env python3
"""The mirror: a unit has the same name and path in every tree.

  hls/<layer>/x.hpp    <->  golden/<layer>/x.hpp    for surface, edge, sweep, patch
  hls/<layer>/x.hpp     ->  tests/<layer>/x.cpp     records, which hold no formula, excepted
  hls/core/x.hpp        ->  tests/core/x.cpp
  hls/top/x.cpp         ->  tests/top/x.cpp

usage: mirror.py [--root FOLDER]
"""

import argparse
import sys
from pathlib import Path

from source import Findings, project_root, sources

LAYERS = ("surface", "edge", "sweep", "patch")
# Headers that are no unit, and why they need no test under their own name.
NO_TEST = {
    "hls/core/formats.hpp": "held by tests/core/error_budget.cpp",
    "hls/core/record.hpp": "names fields; every other test walks its list",
    "hls/core/fixed_ap.hpp": "another tool's type, held against fixed by scripts/portability.sh",
    "hls/core/fixed_ac.hpp": "another tool's type, held against fixed by scripts/portability.sh",
    "hls/core/fixed_tool.hpp": "what those two share",
    "hls/core/synthesis.hpp": "macros alone",
    "hls/core/port.hpp": "one choice of types; every entry point's test goes through it",
    "hls/core/streaming_loop.hpp": "a marker that expands to nothing; the lint's mutants hold it",
    "hls/surface/map_regs.hpp": "a record",
    "hls/edge/triangle.hpp": "a record",
    "hls/edge/engine_regs.hpp": "a record",
    "hls/edge/counters.hpp": "a record",
}
# Headers of golden/ alone, and why there is no kernel of that name.
NO_TWIN = {
    "golden/edge/decision_bounds.hpp": "how far golden may lie from the ideal",
    "golden/edge/redecide.hpp": "the ideal's second opinion on golden's decisions",
    "golden/edge/redecision_summary.hpp": "its summary for the report",
    "golden/edge/edge_trace.hpp": "what an observer sees of an edge; a circuit has none",
    "golden/surface/memories.hpp": "the memories that a kernel has as ports",
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=project_root())
    root = parser.parse_args().root
    findings = Findings("mirror")

    def need(path, twin, why):
        if str(path) not in NO_TWIN and not (root / twin).is_file():
            findings.add(path, "mirror", f"{why}: {twin} is missing")

    def need_test(path):
        if str(path) not in NO_TEST:
            need(path, Path("tests", *path.parts[1:]).with_suffix(".cpp"), "a unit has a test of its own")

    kernels = sources(root, *(f"hls/{layer}" for layer in LAYERS), suffixes=(".hpp",))
    for path in kernels:
        need(path, Path("golden", *path.parts[1:]), "a kernel has a golden twin")
        need_test(path)
    definitions = sources(root, *(f"golden/{layer}" for layer in LAYERS), suffixes=(".hpp",))
    for path in definitions:
        need(path, Path("hls", *path.parts[1:]), "a definition has a kernel")
    core = sources(root, "hls/core", suffixes=(".hpp",))
    tops = sources(root, "hls/top", suffixes=(".cpp",))
    for path in core + tops:
        need_test(path)
    for excepted in [*NO_TEST, *NO_TWIN]:
        if root == project_root() and not (root / excepted).is_file():
            findings.add("scripts/lint/mirror.py", "mirror", f"the exception for {excepted} names a file that is not there")
    return findings.finish(f"{len(kernels) + len(definitions) + len(core) + len(tops)} files")


if __name__ == "__main__":
    sys.exit(main())
