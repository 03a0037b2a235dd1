#!/usr/bin/env python3
"""Verilator's lint, all warnings, on every module of rtl/ taken alone as the top; rtl/waivers.vlt says what is let pass and why.

usage: verilator.py [FILE]...     these modules instead, with what they name of rtl/
"""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from circuit import code, made_of, modules
from source import Findings, project_root

REGISTERS = re.compile(r"\b\w+_regblock\b")
FINDING = re.compile(r"^%(?:Warning|Error)(?:-(\w+))?: ([^:\s]+:\d+):\d+: (.*)")


def main():
    root = project_root()
    files = [Path(file).resolve() for file in sys.argv[1:]] or [root / path for path in modules(root)]
    findings = Findings("verilator")
    registers = subprocess.run(["scripts/registers.sh"], check=False, cwd=root).returncode
    if registers == 77:
        # Nothing to hold them against.
        files = [file for file in files if not any(REGISTERS.search(code(root / path)) for path in made_of(root, file))]
    elif registers:
        return registers

    def lint(file):
        path = file.relative_to(root) if file.is_relative_to(root) else file
        command = ["verilator", "--lint-only", "-Wall", "-sv", "rtl/waivers.vlt", *map(str, made_of(root, path))]
        return subprocess.run([*command, "--top-module", file.stem], capture_output=True, text=True, check=False, cwd=root)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = list(pool.map(lint, files))
    for file, run in zip(files, runs):
        matches = [m for m in map(FINDING.match, run.stderr.split("\n")) if m]
        for match in matches:
            rule, place, message = match.groups()
            findings.add(place, (rule or "error").lower(), message)
        if run.returncode and not matches:
            findings.add(file, "error", run.stderr.strip()[:400])
    return findings.finish(f"{len(files)} modules")


if __name__ == "__main__":
    sys.exit(main())
