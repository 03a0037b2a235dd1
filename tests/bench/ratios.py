#!/usr/bin/env python3
"""Promises about the speed of simulation, as ratios, so that they hold on any machine:
fixed is as fast as int64_t written by hand, a unit is many times as fast as with sc_fixed_fast, and a circuit in its SystemC bench takes
at most twice the time of a bare loop around the same model.

usage: ratios.py RELIEVO_BENCHMARK
"""

import json
import subprocess
import sys

# slower, faster, at least, in words
PROMISES = [
    ("displace_sc_fixed_fast", "displace_fixed", 10.0, "displace with sc_fixed_fast takes {:.0f} times as long as with fixed"),
    ("multiply_accumulate_int64", "multiply_accumulate_fixed", 0.7, "a multiply-accumulate by hand takes {:.2f} times as long as with fixed"),
    ("circuit_loop/small", "circuit_systemc/small", 0.5, "the engine's circuit in a bare loop takes {:.2f} times as long as in SystemC"),
]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    names = sorted({name for promise in PROMISES for name in promise[:2]})
    command = [sys.argv[1], "--benchmark_format=json", "--benchmark_repetitions=5", "--benchmark_min_time=0.1",
               "--benchmark_filter=^(" + "|".join(names) + ")$"]
    report = json.loads(subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True).stdout)
    best = {}
    for run in report["benchmarks"]:
        if run.get("error_occurred"):
            sys.exit(f"{run['name']}: {run['error_message']}")
        if run["run_type"] == "iteration":
            best[run["run_name"]] = min(best.get(run["run_name"], float("inf")), run["cpu_time"])
    failed = False
    for slower, faster, least, words in PROMISES:
        ratio = best[slower] / best[faster]
        failed |= ratio < least
        print(words.format(ratio) + f" (at least {least:g})" + (": too little" if ratio < least else ""))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
