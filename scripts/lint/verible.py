#!/usr/bin/env python3
"""Verible's style rules on rtl/: all but those that .rules.verible_lint switches off, each with its reason.

Its formatter is no gate: it breaks every instance into a line a port, and the cells of a pipeline stand one a line here.

usage: verible.py VERIBLE_VERILOG_LINT [FILE]...
"""

import re
import subprocess
import sys
from pathlib import Path

from source import Findings, project_root

RULE = re.compile(r"^(\S+?:\d+):[\d-]+: (.*?)(?: \[Style: .*)? \[([\w-]+)\]$")
SYNTAX = re.compile(r"^(?:\S+: )?(\S+?:\d+):[\d-]+: (syntax error .*)$")


def main():
    root = project_root()
    files = sys.argv[2:] or sorted(str(path.relative_to(root)) for path in (root / "rtl").glob("*/*.sv"))
    run = subprocess.run(
        [Path(sys.argv[1]).absolute(), "--ruleset", "all", "--rules_config", ".rules.verible_lint", *files],
        capture_output=True,
        text=True,
        check=False,
        cwd=root,
    )
    findings = Findings("verible")
    for line in run.stdout.split("\n") + run.stderr.split("\n"):
        rule, syntax = RULE.match(line), SYNTAX.match(line)
        if rule:
            findings.add(rule.group(1), rule.group(3).replace("-", " "), rule.group(2))
        elif syntax:
            findings.add(syntax.group(1), "syntax error", syntax.group(2))
    if run.returncode and not findings.rows:
        findings.add(".rules.verible_lint", "verible", (run.stdout + run.stderr).strip()[:400])
    return findings.finish(f"{len(files)} files")


if __name__ == "__main__":
    sys.exit(main())
