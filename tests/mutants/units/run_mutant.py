#!/usr/bin/env python3
"""Breaks one kernel and expects its unit test to notice.

usage: run_mutant.py MUTANT --source ROOT --work FOLDER --baseline UNIT_TESTS --vectors N -- COMPILE COMMAND ...

A mutant is a text: a line that says what is broken, `test LAYER/UNIT`, `file hls/...`, then the original text between <<<< and ====
and the broken one between ==== and >>>>. The original must occur exactly once: a mutant that no longer fits its kernel is an error.

The broken header alone is written into FOLDER, which the compiler searches before ROOT; tests/LAYER/UNIT.cpp is compiled against it
and run. The mutant is rejected when an assertion of that run fails (a crash alone, a timeout or the compiler's refusal is not enough),
and when the same test cases pass in UNIT_TESTS with the same vectors.
"""

import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path


class Broken(Exception):
    """The gate or the mutant itself is not in order."""


def read_mutant(path):
    match = re.fullmatch(r"(.+)\ntest (\S+)\nfile (\S+)\n<<<<\n(.*)\n====\n(.*?)\n?>>>>\n", path.read_text(), re.DOTALL)
    if not match:
        raise Broken(f"{path} is no mutant: what is broken, test, file, <<<<, ====, >>>>")
    return match.groups()


def run(command, seconds):
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds, check=False)
    except subprocess.TimeoutExpired as late:
        raise Broken(f"{command[0]} did not end within {seconds} s") from late
    return done.returncode, done.stdout.decode(errors="replace")


def failing_tests(output):
    return sorted(set(re.findall(r"^\[  FAILED  \] ([\w/]+\.\w+)", output, re.MULTILINE)))


def reject(args):
    why, test, name, original, broken = read_mutant(args.mutant)
    print(f"{args.mutant.stem}: {why}")
    kernel = (args.source / name).read_text()
    if kernel.count(original) != 1:
        raise Broken(f"its original text occurs {kernel.count(original)} times in {name}, not once: bring the mutant up to date")
    overlay = args.work / args.mutant.stem
    shutil.rmtree(overlay, ignore_errors=True)
    header = overlay / name
    header.parent.mkdir(parents=True, exist_ok=True)
    header.write_text(kernel.replace(original, broken))

    program = overlay / "unit_test"
    values = {"@OVERLAY@": overlay, "@TEST@": args.source / "tests" / f"{test}.cpp", "@PROGRAM@": program}
    command = args.compile
    for mark, value in values.items():
        command = [word.replace(mark, str(value)) for word in command]
    code, output = run(command, 300)
    if code != 0:
        raise Broken(f"it does not compile:\n{output}")

    vectors = ["--vectors", str(args.vectors)]
    code, output = run([str(program), "--gtest_brief=1"] + vectors, 120)
    program.unlink()
    failing = failing_tests(output)
    if code == 0 or not failing:
        raise Broken(f"tests/{test}.cpp does not notice it (exit code {code}):\n{output[-2000:]}")
    code, output = run([str(args.baseline), "--gtest_brief=1", "--gtest_filter=" + ":".join(failing)] + vectors, 120)
    if code != 0:
        raise Broken(f"the same cases fail without it too:\n{output[-2000:]}")
    print("noticed by " + ", ".join(failing))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mutant", type=Path)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--baseline", type=Path, required=True)
    parser.add_argument("--vectors", type=int, default=2000)
    parser.add_argument("compile", nargs="+", help="after --: the compiler and its options, with @OVERLAY@, @TEST@ and @PROGRAM@")
    try:
        reject(parser.parse_args())
    except Broken as reason:
        sys.exit(f"not rejected: {reason}")


if __name__ == "__main__":
    main()
