#!/usr/bin/env python3
"""Holes that scripts/rtl_coverage.py --check must refuse, and what it must let pass: each a small tree with one circuit, its points and a
coverage file.

usage: coverage.py RTL_COVERAGE.py
"""

import subprocess
import sys
import tempfile
from pathlib import Path

CIRCUIT = "module cell (\n  input logic [11:0] a\n);\n  if (a) b = 1'b0;\n  logic [999:0] wide;\nendmodule\n"
POINTS = "module cell_cover;\n  full: cover property (@(posedge clk_i) full);\nendmodule\n"
LINE = ("rtl/core/cell.sv", 4, "v_branch/cell", "if")
SIGNAL = ("rtl/core/cell.sv", 2, "v_toggle/cell", "a[1]")
OTHER_BIT = ("rtl/core/cell.sv", 2, "v_toggle/cell", "a[11]")
POINT = ("tests/cover/cell_cover.sv", 2, "v_user/cell_cover", "full")
EXPLAINED = {
    "line": "[[hole]]\nmodule = \"cell\"\nline = \"if (a) b = 1'b0;\"\nwhy = \"because\"\n",
    "bit": '[[hole]]\nmodule = "cell"\nsignal = "a[1]"\nwhy = "because"\n',
    "bits": '[[hole]]\nmodule = ["cell"]\nsignal = "a[1*]"\nwhy = "because"\n',
    "a list": '[[hole]]\nmodule = "cell"\nsignal = ["a[1]", "a[11]"]\nwhy = "because"\n',
    "other bits": '[[hole]]\nmodule = "cell"\nsignal = "a"\nwhy = "because"\n',
    "point": '[[hole]]\nmodule = "cell"\npoint = "full"\nwhy = "because"\n',
    "no such point": '[[hole]]\nmodule = "cell"\npoint = "empty"\nwhy = "because"\n',
}
# What was counted how often, which explanations there are, and the kinds of findings that must come.
CASES = {
    "everything reached": ([(LINE, 1), (SIGNAL, 1), (POINT, 1)], [], set()),
    "a bit that never changed": ([(LINE, 1), (SIGNAL, 0), (OTHER_BIT, 1), (POINT, 1)], [], {"signal"}),
    "a bit that changed in another test": ([(SIGNAL, 0), (SIGNAL, 1)], [], set()),
    "a bit that changed before reset alone": ([(SIGNAL, 2), (SIGNAL, 2, ".begin")], [], {"signal"}),
    "a bit that changed before reset and after": ([(SIGNAL, 3), (SIGNAL, 2, ".begin")], [], set()),
    "a line reached before reset": ([(LINE, 1), (LINE, 1, ".begin")], [], set()),
    "a bit that is explained": ([(SIGNAL, 0), (OTHER_BIT, 1)], ["bit"], set()),
    "bits that are explained": ([(SIGNAL, 0), (OTHER_BIT, 0)], ["bits"], set()),
    "a list of bits": ([(SIGNAL, 0), (OTHER_BIT, 0)], ["a list"], set()),
    "a list of which one bit is not there": ([(SIGNAL, 0)], ["a list"], {"explanation"}),
    "a bit beside the one that is explained": ([(SIGNAL, 0), (OTHER_BIT, 0)], ["bit"], {"signal"}),
    "an explanation for another bit": ([(SIGNAL, 0)], ["other bits"], {"signal", "explanation"}),
    "an explanation of bits that changed, with more vectors perhaps": ([(SIGNAL, 1), (OTHER_BIT, 1)], ["bits"], set()),
    "an explanation of a bit that is not there": ([(OTHER_BIT, 1)], ["bit"], {"explanation"}),
    "holes that are explained": ([(LINE, 0), (POINT, 0)], ["line", "point"], set()),
    "reached in another test": ([(LINE, 0), (LINE, 1), (POINT, 0), (POINT, 2)], [], set()),
    "a line never reached": ([(LINE, 0), (POINT, 1)], [], {"line"}),
    "a point never reached": ([(LINE, 1), (POINT, 0)], [], {"point"}),
    "both": ([(LINE, 0), (POINT, 0)], [], {"line", "point"}),
    "an explanation of what is reached": ([(LINE, 1), (POINT, 1)], ["point"], {"explanation"}),
    "an explanation of what is not there": ([(LINE, 1), (POINT, 1)], ["no such point"], {"explanation"}),
    "an explanation that says too little": ([(LINE, 1), (POINT, 0)], ['[[hole]]\nmodule = "cell"\npoint = "full"\n'], None),
}


def row(point, count):
    path, line, page, what = point
    fields = {"f": path, "l": line, "n": 1, "page": page, "o": what, "h": ".cell"}
    return "C '" + "".join(f"\1{key}\2{value}" for key, value in fields.items()) + f"' {count}\n"


def main():
    failed = False
    for name, (counted, explained, expected) in CASES.items():
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path, text in (("rtl/core/cell.sv", CIRCUIT), ("tests/cover/cell_cover.sv", POINTS)):
                (root / path).parent.mkdir(parents=True)
                (root / path).write_text(text)
            (root / "tests/cover/explained.toml").write_text("".join(EXPLAINED.get(e, e) for e in explained))
            # One file a count, as tests leave them.
            files = []
            for i, (point, count, *at) in enumerate(counted):
                files.append(root / f"{i}{''.join(at)}.dat")
                files[-1].write_text("# SystemC::Coverage-3\n" + row(point, count))
            run = subprocess.run([sys.executable, sys.argv[1], "--check", "--root", root, *files], capture_output=True, text=True, check=False)
        seen = {line.split(": ")[1] for line in run.stdout.split("\n") if line.count(": ") >= 2 and not line.startswith(" ")}
        # A signal too wide to be counted is named where any is counted.
        named = "rtl/core/cell.sv: wide" in run.stdout or not any(point in (SIGNAL, OTHER_BIT) for point, *_ in counted)
        good = run.returncode == 1 and "explained.toml: a hole has" in run.stderr if expected is None else (
            seen == expected and run.returncode == (1 if expected else 0) and named)
        if not good:
            failed = True
            print(f"{name}: exit code {run.returncode}, findings {sorted(seen)}, expected {expected}\n{run.stdout}{run.stderr}")
    print(f"{len(CASES)} cases, {'FAILED' if failed else 'passed'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
