"""Reads as much of textual LLVM IR (version 14) as the synthesizability lint asks for: functions, calls, source places."""

import re

_STRING = re.compile(r'c?"(?:[^"\\]|\\.)*"')
_NAME = r'(?:"(?:[^"\\]|\\.)+"|[\w.$-]+)'
_DEFINE = re.compile(rf"^define\b(?P<linkage>[^@]*?)@(?P<name>{_NAME})\(")
_CALL = re.compile(r"(?:^\s*|= |\btail |\bmusttail |\bnotail )(?:call|invoke|callbr) (?P<rest>.*)")
_CALLEE = re.compile(rf"(?P<sigil>[@%])(?P<name>{_NAME})\(")
_DBG = re.compile(r"!dbg !(\d+)")
_LABEL = re.compile(rf"^(?P<name>{_NAME}):")


def plain(name):
    return name[1:-1] if name.startswith('"') else name


def types_only(line):
    """A line without strings, names and metadata, so that only types and instructions are left."""
    line = _STRING.sub("", line.split(", !", 1)[0])
    return re.sub(rf"[@%!#]{_NAME}", "", line)


class Function:
    def __init__(self, name, linkage, head):
        self.name = name
        self.linkage = linkage
        self.head = head
        self.lines = []

    def calls(self):
        """(callee or None when it is not known, the line) of each call."""
        for line in self.lines:
            match = _CALL.search(_STRING.sub('""', line) if "asm" not in line else line)
            if not match or line.lstrip().startswith(";"):
                continue
            rest = match.group("rest")
            if re.search(r"\basm\b", rest):
                yield "asm", line
                continue
            callee = _CALLEE.search(rest)
            yield (plain(callee.group("name")) if callee and callee.group("sigil") == "@" else None), line

    def blocks(self):
        """name -> lines"""
        name, found = "entry", {}
        for line in self.lines:
            label = _LABEL.match(line)
            if label:
                name = plain(label.group("name"))
            found.setdefault(name, []).append(line)
        return found


class Module:
    def __init__(self, text):
        self.functions = {}
        self.globals = []
        self.metadata = {}
        function = None
        for line in text.split("\n"):
            if function:
                if line.startswith("}"):
                    function = None
                else:
                    function.lines.append(line)
            elif line.startswith("define"):
                match = _DEFINE.match(line)
                function = Function(plain(match.group("name")), match.group("linkage"), line)
                self.functions[function.name] = function
            elif line.startswith("@"):
                self.globals.append(line)
            elif line.startswith("!"):
                number, _, rest = line.partition(" = ")
                self.metadata[number[1:]] = rest

    def _field(self, node, field):
        match = re.search(rf"\b{field}: (?:!(\d+)|(\d+)|\"([^\"]*)\")", self.metadata.get(node, ""))
        return next((group for group in match.groups() if group), None) if match else None

    def place(self, line):
        """file:line of an instruction, or of a function's definition line; None when the compiler left none."""
        match = _DBG.search(line)
        if not match:
            return None
        node = match.group(1)
        number = self._field(node, "line")
        file = None
        while node and not file:
            file = self._field(node, "file")
            node = self._field(node, "scope")
        name = self._field(file, "filename") if file else None
        return f"{name}:{number}" if name else None

    def strongly_connected(self):
        """The groups of functions that call each other in a circle (Tarjan)."""
        graph = {f.name: [c for c, _ in f.calls() if c in self.functions] for f in self.functions.values()}
        index, low, stack, on_stack, groups = {}, {}, [], set(), []

        def visit(root):
            work = [(root, iter(graph[root]))]
            index[root] = low[root] = len(index)
            stack.append(root)
            on_stack.add(root)
            while work:
                node, successors = work[-1]
                for successor in successors:
                    if successor not in index:
                        index[successor] = low[successor] = len(index)
                        stack.append(successor)
                        on_stack.add(successor)
                        work.append((successor, iter(graph[successor])))
                        break
                    if successor in on_stack:
                        low[node] = min(low[node], index[successor])
                else:
                    work.pop()
                    if work:
                        low[work[-1][0]] = min(low[work[-1][0]], low[node])
                    if low[node] == index[node]:
                        group = []
                        while not group or group[-1] != node:
                            group.append(stack.pop())
                            on_stack.discard(group[-1])
                        if len(group) > 1 or node in graph[node]:
                            groups.append(sorted(group))

        for name in graph:
            if name not in index:
                visit(name)
        return groups
