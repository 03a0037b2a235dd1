#!/usr/bin/env python3
"""Switches one mutant of a circuit on and expects its test to notice.

usage: run_mutant.py MUTANT --source ROOT --program TEST_PROGRAM
       run_mutant.py --none MUTANT... --program TEST_PROGRAM [--vectors N]

The program is the unit's test, linked with models that have the mutants woven in (weave.py). The mutant is rejected when one of the
cases that it names fails and says what it must say: a crash, a timeout or another failure is not enough. It ends there, so it may draw as
many vectors as the unit's own test. With --none the switch is off, and the cases of all the mutants named must pass, with N vectors; with
all of them the circuit as it is passes in its own test.
"""

import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

from mutant import Broken, occurs_once, read_mutant


def run(args, number, cases):
    command = [str(args.program), "--gtest_brief=1", f"--gtest_filter={cases}"]
    if number:
        command.append("--gtest_fail_fast")
    environment = {**os.environ, "RELIEVO_MUTANT": str(number)}
    if not number:
        environment["RELIEVO_VECTORS"] = str(args.vectors)
    try:
        done = subprocess.run(
            command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=args.seconds, check=False
        )
    except subprocess.TimeoutExpired as late:
        raise Broken(f"{args.program.name} did not end within {args.seconds} s") from late
    return done.returncode, done.stdout.decode(errors="replace")


def reject(args):
    mutant = read_mutant(args.mutants[0])
    print(f"{mutant.name}: {mutant.why}")
    reason = occurs_once(mutant, (args.source / mutant.file).read_text())
    if reason:
        raise Broken(reason)
    code, output = run(args, mutant.number, mutant.cases)
    failing = sorted(set(re.findall(r"^\[  FAILED  \] ([\w/]+\.[\w/]+)", output, re.MULTILINE)))
    if code == 0:
        raise Broken(f"{mutant.cases} does not notice it:\n{output[-2000:]}")
    if not failing:
        raise Broken(f"no test failed, but the program ended with {code}:\n{output[-2000:]}")
    lines = [line.strip() for line in output.split("\n") if mutant.says in line]
    if not lines:
        raise Broken(f"{', '.join(failing)} fails, but does not say `{mutant.says}`:\n{output[:4000]}")
    print(f"noticed by {', '.join(failing)}: {lines[0][:400]}")


def accept(args):
    # Each alone: SystemC elaborates one bench a process.
    cases = sorted({case for path in args.mutants for case in read_mutant(path).cases.split(":")})
    for case in cases:
        code, output = run(args, 0, case)
        ran = re.search(r"^\[==========\] (\d+) tests? .*ran", output, re.MULTILINE)
        if code or not ran or int(ran[1]) < 1:
            raise Broken(f"{case} with no mutant switched on:\n{output[-2000:]}")
    print(f"{len(cases)} cases pass")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mutants", type=Path, nargs="+")
    parser.add_argument("--none", action="store_true")
    parser.add_argument("--source", type=Path)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--vectors", type=int, default=5000)
    parser.add_argument("--seconds", type=int, default=120)
    args = parser.parse_args()
    try:
        (accept if args.none else reject)(args)
    except Broken as reason:
        sys.exit(f"not rejected: {reason}" if not args.none else f"not accepted: {reason}")


if __name__ == "__main__":
    main()
