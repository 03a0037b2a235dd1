"""What the source lints share: findings, and C++ text without comments and literals, line by line."""

import re
import sys
from pathlib import Path

# One alternative each: raw string, string, character, block comment, line comment.
_NOISE = re.compile(
    r'R"([^ ()\\\t\n]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|/\*.*?\*/|//[^\n]*', re.DOTALL
)
_DIGIT_SEPARATOR = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")


def code_lines(text):
    """The lines of a C++ file with comments gone and literals emptied; #include lines keep their path."""
    kept = []

    def blank(match):
        token = match.group(0)
        newlines = "\n" * token.count("\n")
        if token.startswith("/"):
            return " " + newlines
        line_start = text.rfind("\n", 0, match.start()) + 1
        if text[line_start : match.start()].lstrip().startswith("#"):
            return token
        return '""' + newlines

    text = _DIGIT_SEPARATOR.sub("", text)
    for line in _NOISE.sub(blank, text).split("\n"):
        kept.append(line)
    return kept


def sources(root, *folders, suffixes=(".hpp", ".cpp")):
    """All C++ files of these folders, sorted, as paths relative to root."""
    found = []
    for folder in folders:
        base = root / folder
        if base.is_dir():
            found += [p.relative_to(root) for p in base.rglob("*") if p.suffix in suffixes and p.is_file()]
    return sorted(found)


class Findings:
    """Collects findings, prints them as `place: kind: message`, and turns them into an exit code."""

    def __init__(self, name):
        self.name = name
        self.rows = []

    def add(self, place, kind, message):
        row = f"{place}: {kind}: {message}"
        if row not in self.rows:
            self.rows.append(row)

    def finish(self, checked):
        for row in self.rows:
            print(row)
        print(f"{self.name}: {checked}, {len(self.rows)} findings", file=sys.stderr)
        return 1 if self.rows else 0


def project_root():
    return Path(__file__).resolve().parents[2]
