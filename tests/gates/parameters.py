#!/usr/bin/env python3
"""Build parameters that a circuit is not made for must be refused when it is made, by the line that says what would be right.
Of a module all at once, as Verilator tells of each: 51 entries are one too few for 16 generations.

usage: parameters.py      from anywhere; modules that need the register block are left out without it"""
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/lint"))
from circuit import generated, made_of  # noqa: E402  (a folder of scripts, no package)

REFUSED = {
    "rtl/edge/profile_test.sv": {"SamplesPerClock=8": "SamplesPerClock is 1, 4 or 16", "InFlight=7": "InFlight is 8 at least"},
    "rtl/edge/engine.sv": {
        "Lanes=2": "Lanes is 1 or 3",
        "QueueDepth=51": "QueueDepth is 3 MaxGeneration + 4 at least",
        "MaxGeneration=16": "MaxGeneration is 15 at most",
        "InFlight=7": "InFlight is 8 at least",
    },
    "rtl/top/edge_engine.sv": {
        "LANES=2": "LANES is 1 or 3",
        "QUEUE_DEPTH=51": "QUEUE_DEPTH is 3 MAX_GENERATION + 4 at least",
        "MAX_GENERATION=16": "MAX_GENERATION is 15 at most",
        "SAT_READS_PER_CLOCK=2": "SAT_READS_PER_CLOCK is 1, 3, 4 or 12",
        "PROFILE_SAMPLES_PER_CLOCK=8": "PROFILE_SAMPLES_PER_CLOCK is 1, 4 or 16",
        "IN_FLIGHT=7": "IN_FLIGHT is 8 at least",
    },
}


def main():
    wrong = 0
    for module, lines in REFUSED.items():
        if module.startswith("rtl/top/") and not generated(ROOT, "*_regblock.sv"):
            continue
        path = Path(module)
        command = ["verilator", "--lint-only", "-sv", "rtl/waivers.vlt", *map(str, made_of(ROOT, path)), "--top-module", path.stem]
        run = subprocess.run([*command, *(f"-G{parameter}" for parameter in lines)], capture_output=True, text=True, check=False, cwd=ROOT)
        for parameter, line in lines.items():
            if run.returncode == 0 or f": {line}\n" not in run.stderr:
                wrong += 1
                print(f"{module}, {parameter}: exit code {run.returncode}, where it is to be refused with '{line}'\n{run.stderr}")
    print(f"{wrong} wrong parameters let pass")
    return wrong != 0


if __name__ == "__main__":
    sys.exit(main())
