#!/usr/bin/env python3
"""What the comment at the top of every module of rtl/ says.

  first line        MODULE: what it does
  contract: FILE    the kernel whose words it gives; asked of a module that is the twin of hls/<tree>/<module>.hpp
  latency N         in clocks, or of what it depends on
  initiation interval
  registered        which paths are; or `as FILE.sv`, whose header says it

usage: headers.py [--root FOLDER]
"""

import argparse
import re
import sys
from pathlib import Path

from circuit import header, modules, packages
from source import Findings, project_root

REGISTERED = re.compile(r"\bregister(?:s|ed)?\b|\bcombinational\b", re.IGNORECASE)
AS = re.compile(r"\bas (?:[\w/]+/)?(\w+)\.sv\b")
CONTRACT = re.compile(r"contract: (hls/[\w/]+\.hpp)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=project_root())
    root = parser.parse_args().root
    findings = Findings("headers")
    for path in packages(root) + modules(root):
        lines = header(root / path)
        if not lines or not lines[0].startswith(f"{path.stem}: "):
            findings.add(path, "header", f"the first line is not `// {path.stem}: ...`")
    for path in modules(root):
        lines = header(root / path)
        contracts = CONTRACT.findall("\n".join(lines))
        twin = Path("hls", *path.parts[1:]).with_suffix(".hpp")
        if (root / twin).is_file() and str(twin) not in contracts:
            findings.add(path, "contract", f"does not name its contract: `contract: {twin}`")
        for contract in contracts:
            if not (root / contract).is_file():
                findings.add(path, "contract", f"its contract {contract} is not there")
        text = " ".join(lines[1:])
        if not re.search(r"\blatency\b", text, re.IGNORECASE):
            findings.add(path, "latency", "does not say its latency")
        if not re.search(r"\binitiation intervals?\b", text, re.IGNORECASE):
            findings.add(path, "initiation interval", "does not say its initiation interval")
        said = [text] + [" ".join(header(other)[1:]) for name in AS.findall(text) for other in (root / "rtl").glob(f"*/{name}.sv")]
        if not any(map(REGISTERED.search, said)):
            findings.add(path, "registered", "does not say which paths are registered")
    return findings.finish(f"{len(modules(root))} modules")


if __name__ == "__main__":
    sys.exit(main())
