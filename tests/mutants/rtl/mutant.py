"""The texts of the circuits' mutants, NAME.mutant.

    what is broken, in a line
    test FOLDER/UNIT CASE[:CASE]...     the program's source, tests/FOLDER/UNIT_rtl.cpp or tests/cosim/UNIT.cpp, and who must notice
    says TEXT                           stands in what the failing test prints
    model PREFIX...                     the Verilated models in which it can be switched on; left out where the unit has one, and in cosim
                                        where that is Vengine_small
    file rtl/TREE/MODULE.sv
    <<<<
    the original text, which occurs once in the file
    ====
    the broken one
    >>>>

A text is an expression, an `assign` with the same left side in both, or procedural statements that end with `;`.
"""

import re
import zlib
from dataclasses import dataclass
from pathlib import Path

PATTERN = re.compile(
    r"(?P<why>[^\n]+)\ntest (?P<test>\S+) (?P<cases>\S+)\nsays (?P<says>[^\n]+)\n"
    r"(?:model (?P<models>[^\n]+)\n)?file (?P<file>rtl/\S+\.sv)\n"
    r"<<<<\n(?P<original>.*)\n====\n(?P<broken>.*?)\n?>>>>\n",
    re.DOTALL,
)


class Broken(Exception):
    """The gate or a mutant is not in order."""


@dataclass(frozen=True)
class Mutant:
    name: str
    why: str
    test: str
    cases: str
    says: str
    file: str
    original: str
    broken: str

    @property
    def number(self):
        """What the circuit's switch is compared with: the same for a name wherever it is asked for, and not 0, which is none."""
        return zlib.crc32(self.name.encode()) & 0x7FFFFFFF | 1


def read_mutant(path):
    path = Path(path)
    match = PATTERN.fullmatch(path.read_text())
    if not match:
        raise Broken(f"{path} is no mutant: what is broken, test, says, perhaps model, file, <<<<, ====, >>>>")
    fields = match.groupdict()
    del fields["models"]
    return Mutant(path.stem, **fields)


def occurs_once(mutant, source):
    """Why the mutant cannot be woven into the source, or nothing."""
    count = source.count(mutant.original)
    if count != 1:
        return f"its original text occurs {count} times in {mutant.file}, not once: bring the mutant up to date"
    return ""
