#!/usr/bin/env python3
"""Runs a gate on a broken copy and passes only when the gate refuses it, and for no other reason than the expected ones.

usage: expect_rejected.py "KIND, KIND" COMMAND [ARGUMENT]...

A finding is a line `place: kind: message`, or one of clang's, `place: error: message [kind]`.
"""

import re
import subprocess
import sys

CLANG = re.compile(r"^\S+:\d+:\d+: (?:error|warning): .* \[-?W?([\w.-]+)(?:,-warnings-as-errors)?\]$")
SKIPPED = 77  # the gate could not run, and says why
OURS = re.compile(r"^\S+: ([a-z ]+): ")


def main():
    expected = {kind.strip() for kind in sys.argv[1].split(",")}
    run = subprocess.run(sys.argv[2:], capture_output=True, text=True, check=False)
    sys.stdout.write(run.stdout)
    sys.stdout.write(run.stderr)
    lines = run.stdout.split("\n")
    seen = {m.group(1) for m in (CLANG.match(line) or OURS.match(line) for line in lines) if m}
    if run.returncode == SKIPPED:
        return SKIPPED
    if run.returncode == 0:
        print(f"the gate accepts this; it must refuse it for: {', '.join(sorted(expected))}")
        return 1
    if seen != expected:
        print(f"refused for: {', '.join(sorted(seen)) or 'nothing it names'}; it must be for: {', '.join(sorted(expected))}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
