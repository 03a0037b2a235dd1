#!/usr/bin/env python3
"""clang-tidy over the sources of hls/ and tb/ in a build folder, which reach every header of hls/, golden/ and tb/.

Most of clang-tidy's time goes into the headers of the standard library and of others, again for every unit. So the sources of
a folder are examined together, as one unit that includes them; a source that does not go with the ones before it (two helpers
of one name) begins or joins another. Units that came out clean and have not changed since are not examined again: their stamps
lie in the build folder. The tests' own sources are left out: most of that time would go into GoogleTest.

usage: tidy.py BUILD_FOLDER [FOLDER]...     of the project, those below it too; hls and tb when none is named
"""

import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from source import Findings, project_root

FINDING = re.compile(r"^(\S+?:\d+):\d+: (?:warning|error): (.*) \[([\w.,-]+)\]$")
ERROR = re.compile(r"^(\S+?):\d+:\d+: (?:fatal )?error: ", re.MULTILINE)
LARGEST_UNIT = 20
CHECKS = "-bugprone-suspicious-include"  # the unit of several sources is one by design


def flags_of(commands):
    """What the sources of a folder are compiled with: include folders, definitions, standard."""
    kept = []
    for command in commands:
        words = shlex.split(command)
        for i, word in enumerate(words):
            pair = [word, words[i + 1]] if word in ("-isystem", "-I", "-D") else [word]
            if re.match(r"-(I|D|isystem|std=)", word) and pair not in kept:
                kept.append(pair)
    return [word for pair in kept for word in pair] + ["-Wno-unknown-pragmas", "-Wno-unknown-warning-option"]


def clang(unit, flags, *more):
    return subprocess.run(["clang++", *flags, *more, str(unit)], capture_output=True, text=True, check=False)


def write_unit(folder, name, number, sources):
    unit = folder / f"{name.replace('/', '_')}_{number}.cpp"
    unit.write_text("".join(f'#include "{source}"\n' for source in sources))
    return unit


def units_of(folder, name, sources, flags):
    """Puts the sources into as few units as compile."""
    units = []
    waiting = sources
    while waiting:
        group, later = waiting[:LARGEST_UNIT], waiting[LARGEST_UNIT:]
        while True:
            unit = write_unit(folder, name, len(units), group)
            refused = clang(unit, flags, "-fsyntax-only", "-w", "-ferror-limit=0").stderr
            wrong = {str(Path(path).resolve()) for path in ERROR.findall(refused)}
            clashing = [source for source in group[1:] if source in wrong]
            if not wrong or len(group) == 1:
                break
            # The first of two of a name stays; where the complaint is in a header that they use, one half goes. What is wrong
            # by itself ends up alone, where clang-tidy says so.
            clashing = clashing or group[(len(group) + 1) // 2 :]
            group = [source for source in group if source not in clashing]
            later = clashing + later
        units.append(unit)
        waiting = later
    return [(unit, flags) for unit in units]


def examine(unit, flags, stamps, settings):
    text = clang(unit, flags, "-E").stdout
    stamp = stamps / hashlib.sha256(settings + " ".join(flags).encode() + text.encode()).hexdigest()
    if stamp.exists():
        return [], False
    config = f"--config-file={project_root() / '.clang-tidy'}"
    headers = r"--header-filter=/(hls|golden|tb)/.*\.[hc]pp$"
    run = subprocess.run(
        ["clang-tidy", "--quiet", config, f"--checks={CHECKS}", headers, str(unit), "--", *flags],
        capture_output=True,
        text=True,
        check=False,
    )
    found = [m.groups() for m in map(FINDING.match, run.stdout.split("\n")) if m]
    if run.returncode and not found:
        found = [(str(unit), (run.stdout + run.stderr).strip()[-400:], "clang-tidy")]
    if not found:
        stamp.touch()
    return found, True


def main():
    root = project_root()
    build = Path(sys.argv[1]).resolve()
    wanted = [root / folder for folder in sys.argv[2:] or ("hls", "tb")]
    commands = build / "compile_commands.json"
    if not commands.is_file():
        subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja"], check=True, stdout=subprocess.DEVNULL)
    folders = {}
    for entry in json.loads(commands.read_text()):
        path = Path(entry["file"])
        if any(path.is_relative_to(folder) for folder in wanted):
            folders.setdefault(str(path.relative_to(root).parent), {})[str(path)] = entry["command"]

    work = build / "clang-tidy"
    stamps = work / "clean"
    stamps.mkdir(parents=True, exist_ok=True)
    settings = (root / ".clang-tidy").read_bytes()
    findings = Findings("clang-tidy")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        made = pool.map(
            lambda item: units_of(work, item[0], sorted(item[1]), flags_of(item[1].values())), sorted(folders.items())
        )
        units = [unit for group in made for unit in group]
        results = list(pool.map(lambda unit: examine(*unit, stamps, settings), units))
    for found, _ in results:
        for place, message, check in found:
            findings.add(place.replace(f"{root}/", ""), check.replace(",-warnings-as-errors", ""), message)
    sources = sum(map(len, folders.values()))
    return findings.finish(f"{sources} sources in {len(units)} units, {sum(fresh for _, fresh in results)} examined")


if __name__ == "__main__":
    sys.exit(main())
