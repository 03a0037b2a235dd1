#!/usr/bin/env python3
"""Verilates a circuit with mutants woven into it, so that it can take the place of the model without them in a test program.

usage: verilate.py --header HEADER --groups N --depfile FILE --out FOLDER --prefix PREFIX -- VERILATOR OPTION ...

FOLDER gets the model and group_0.cpp .. group_N-1.cpp, which include all of its sources. HEADER is that of the model without mutants, which
the test program was compiled with: both must be the same to the letter.
"""

import argparse
import subprocess
import sys
from pathlib import Path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--header", type=Path, required=True)
    parser.add_argument("--groups", type=int, required=True)
    parser.add_argument("--depfile", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--prefix", required=True)
    parser.add_argument("verilator", nargs="+", help="after --: the command, to which --Mdir is added")
    args = parser.parse_args()
    out = args.out
    out.mkdir(parents=True, exist_ok=True)
    for old in [*out.glob("*.cpp"), *out.glob("*.h")]:
        old.unlink()
    done = subprocess.run([*args.verilator, "--prefix", args.prefix, "--Mdir", str(out)], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{done.stdout}{done.stderr}")
    header = out / f"{args.prefix}.h"
    if header.read_text() != args.header.read_text():
        sys.exit(f"{header} and {args.header} differ: a test program compiled with one cannot run the other")
    sources = sorted(out.glob("*.cpp"), key=lambda p: p.stat().st_size, reverse=True)
    groups = [[0, []] for _ in range(args.groups)]
    for source in sources:
        smallest = min(groups, key=lambda group: group[0])
        smallest[0] += source.stat().st_size
        smallest[1].append(f'#include "{source.name}"\n')
    for i, (_, lines) in enumerate(groups):
        (out / f"group_{i}.cpp").write_text('extern "C" int relievo_active_mutant();\n' + "".join(sorted(lines)))
    # Verilator's own list names all it made; of use is what it read.
    read = (out / f"{args.prefix}__ver.d").read_text().split(":", 1)[1].split()
    args.depfile.write_text(f"{out / 'group_0.cpp'}: " + " ".join(read) + "\n")


if __name__ == "__main__":
    main()
