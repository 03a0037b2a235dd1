#!/usr/bin/env python3
"""clang-tidy over a build folder's own translation units, as many at a time as there are processors, findings printed once.

A header is looked at with every unit that includes it, so its findings come many times; they are printed once. Units whose
text and flags have not changed since they last came out clean are not looked at again: their stamps lie in the build folder.

usage: tidy.py BUILD_FOLDER
"""

import hashlib
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from source import Findings, project_root

FINDING = re.compile(r"^(\S+?:\d+):\d+: (?:warning|error): (.*) \[([\w.,-]+)\]$")


def stamp_of(entry, settings):
    """A digest of the preprocessed unit and the settings, or None when it does not preprocess."""
    command = [word for word in entry["command"].split() if word != "-c"]
    at = command.index("-o")
    command[at : at + 2] = ["-E", "-o", "-"]
    text = subprocess.run(command, cwd=entry["directory"], capture_output=True, check=False)
    if text.returncode:
        return None
    return hashlib.sha256(settings + entry["command"].encode() + text.stdout).hexdigest()


def examine(entry, build, stamps, settings):
    stamp = stamp_of(entry, settings)
    if stamp and (stamps / stamp).exists():
        return [], False
    run = subprocess.run(
        ["clang-tidy", "--quiet", f"-p={build}", "--extra-arg=-Wno-unknown-warning-option", entry["file"]],
        capture_output=True,
        text=True,
        check=False,
    )
    found = [m.groups() for m in map(FINDING.match, run.stdout.split("\n")) if m]
    if run.returncode and not found:
        found = [(entry["file"], (run.stdout + run.stderr).strip()[-400:], "clang-tidy")]
    if stamp and not found:
        (stamps / stamp).touch()
    return found, True


def main():
    root = project_root()
    build = Path(sys.argv[1]).resolve()
    commands = build / "compile_commands.json"
    if not commands.is_file():
        subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja"], check=True, stdout=subprocess.DEVNULL)
    entries = {e["file"]: e for e in json.loads(commands.read_text()) if Path(e["file"]).is_relative_to(root)}
    entries = [e for f, e in sorted(entries.items()) if not Path(f).is_relative_to(build)]
    stamps = build / "clang-tidy-clean"
    stamps.mkdir(exist_ok=True)
    settings = (root / ".clang-tidy").read_bytes()
    findings = Findings("clang-tidy")
    examined = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for found, fresh in pool.map(lambda e: examine(e, build, stamps, settings), entries):
            examined += fresh
            for place, message, check in found:
                findings.add(Path(place).relative_to(root) if place.startswith(str(root)) else place, check, message)
    return findings.finish(f"{len(entries)} units, {examined} examined")


if __name__ == "__main__":
    sys.exit(main())
