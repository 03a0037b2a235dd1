#!/usr/bin/env python3
"""The mirror: a unit has the same name and path in every tree.

  hls/<layer>/x.hpp    <->  golden/<layer>/x.hpp    for surface, edge, sweep, patch
  hls/<layer>/x.hpp     ->  tests/<layer>/x.cpp     records, which hold no formula, excepted
  hls/core/x.hpp        ->  tests/core/x.cpp
  hls/top/x.cpp         ->  tests/top/x.cpp
  hls/<layer>/x.hpp     ->  rtl/<layer>/x.sv and tests/<layer>/x_rtl.cpp, core too; records and what is no circuit excepted;
                            of a layer that has circuits at all: rtl/<layer> is there

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
    "hls/core/additions_only.hpp": "a marker that expands to nothing; the lint's mutants hold it",
    "hls/surface/map_regs.hpp": "a record",
    "hls/edge/triangle.hpp": "a record",
    "hls/edge/engine_regs.hpp": "a record",
    "hls/edge/counters.hpp": "a record",
    "hls/sweep/remeshed.hpp": "records",
    "hls/sweep/vertex_data.hpp": "records",
    "hls/sweep/world_data.hpp": "records",
    "hls/sweep/engine_data.hpp": "records",
}
# Headers of one tree alone, and why the other has none of that name.
NO_TWIN = {
    "golden/edge/decision_bounds.hpp": "how far golden may lie from the ideal",
    "golden/edge/redecide.hpp": "the ideal's second opinion on golden's decisions",
    "golden/edge/redecision_summary.hpp": "its summary for the report",
    "golden/edge/edge_trace.hpp": "what an observer sees of an edge; a circuit has none",
    "golden/surface/memories.hpp": "the memories that a kernel has as ports",
    "golden/sweep/interpolated_vertex.hpp": "a vertex from its name; in the kernel the walk carries the data by additions",
    "hls/sweep/walk_data.hpp": "what the walk adds; golden multiplies, in interpolated_vertex",
    "hls/sweep/walk_registers.hpp": "how the walk holds its vertices; golden has lists",
    "hls/sweep/walked_edge.hpp": "the walk's counters; golden divides",
}
# Kernel headers that are no circuit, and what the circuit has in their place.
NO_CIRCUIT = {
    "hls/core/formats.hpp": "rtl/core/formats_pkg.sv is printed from it",
    "hls/core/record.hpp": "packed structs, printed",
    "hls/core/packed.hpp": "packed structs, printed",
    "hls/core/fixed.hpp": "signed words and the cell round_to",
    "hls/core/fixed_ap.hpp": "another tool's type",
    "hls/core/fixed_ac.hpp": "another tool's type",
    "hls/core/fixed_tool.hpp": "what those two share",
    "hls/core/synthesis.hpp": "macros alone",
    "hls/core/port.hpp": "one choice of types",
    "hls/core/stream.hpp": "valid and ready, and the cell stream_fifo",
    "hls/core/streaming_loop.hpp": "a marker",
    "hls/core/additions_only.hpp": "a marker",
    "hls/core/vector.hpp": "the cell multiply and sums of its products",
    "hls/surface/map_regs.hpp": "a record",
    "hls/surface/vertex.hpp": "a record; its order is rtl/surface/vertex_order.sv",
    "hls/edge/triangle.hpp": "a record",
    "hls/edge/engine_regs.hpp": "a record",
    "hls/edge/counters.hpp": "a record",
    "hls/sweep/remeshed.hpp": "records",
    "hls/sweep/vertex_data.hpp": "records",
    "hls/sweep/world_data.hpp": "records",
    "hls/sweep/base_triangle_clip.hpp": "to be built, issue 5",
    "hls/sweep/engine_data.hpp": "records",
    "hls/sweep/difference_vertices.hpp": "to be built, issue 5",
    "hls/sweep/engine.hpp": "to be built, issue 5",
    "hls/sweep/view_volume_clip.hpp": "to be built, issue 5",
    "hls/sweep/grid_transform.hpp": "to be built, issue 5",
    "hls/sweep/near_clip.hpp": "to be built, issue 5",
    "hls/sweep/perspective_correction.hpp": "to be built, issue 5",
    "hls/sweep/perspective_preparation.hpp": "to be built, issue 5",
    "hls/sweep/z_table.hpp": "to be built, issue 5",
    "hls/sweep/walk_data.hpp": "part of the walk's circuit",
    "hls/sweep/walk_registers.hpp": "part of the walk's circuit, walk_names",
    "hls/sweep/walked_edge.hpp": "part of the walk's circuit, walk_edges and walk_strips",
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

    def need_circuit(path):
        circuit = Path("rtl", *path.parts[1:]).with_suffix(".sv")
        test = Path("tests", *path.parts[1:-1], f"{path.stem}_rtl.cpp")
        for twin, why in ((circuit, "a kernel has a circuit"), (test, "a circuit has a test of its own")):
            if not (root / twin).is_file():
                findings.add(path, "circuit", f"{why}: {twin} is missing")

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
    for path in core + kernels:
        if (root / "rtl" / path.parts[1]).is_dir() and str(path) not in NO_CIRCUIT:
            need_circuit(path)
    for excepted in [*NO_TEST, *NO_TWIN, *NO_CIRCUIT]:
        if root == project_root() and not (root / excepted).is_file():
            findings.add("scripts/lint/mirror.py", "mirror", f"the exception for {excepted} names a file that is not there")
    return findings.finish(f"{len(kernels) + len(definitions) + len(core) + len(tops)} files")


if __name__ == "__main__":
    sys.exit(main())
