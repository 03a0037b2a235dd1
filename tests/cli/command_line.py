"""What the tests of the command line share: running relievo in a folder of its own, and what a refusal has to look like.

The program is $RELIEVO. A test case is a unittest method of a class derived from command_line; self.folder is its own empty folder and the
working directory of every run. Inputs that a refused run must leave alone are all files that were there before it."""
import os
import pathlib
import subprocess
import tempfile
import unittest

RELIEVO = os.environ.get("RELIEVO", "relievo")

# A scene that takes some 20 ms.
SMALL = ["--mesh", "plane:2", "--displacement", "sine:32"]

QUAD = """v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
f 1/1/1 2/2/1 3/3/1
f 1/1/1 3/3/1 4/4/1
"""


class command_line(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="relievo_cli_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def put(self, name, content):
        path = self.folder / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return name

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def run_raw(self, *arguments):
        return subprocess.run([RELIEVO, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=280)

    def run_to(self, code, *arguments):
        """Runs; the exit code has to be `code`. Gives stdout and stderr as text."""
        done = self.run_raw(*arguments)
        out, err = (text.decode(errors="replace") for text in (done.stdout, done.stderr))
        self.assertEqual(done.returncode, code, f"relievo {arguments}\n{out}\n{err}")
        return out, err

    def done(self, *arguments):
        return self.run_to(0, *arguments)

    def all_files(self):
        return {str(p.relative_to(self.folder)): p.read_bytes() if p.is_file() else None for p in self.folder.rglob("*")}

    def refused(self, *arguments, names):
        """Exit code 2, exactly one line on stderr that names what is wrong, nothing on stdout, no file made, changed or gone."""
        before = self.all_files()
        done = self.run_raw(*arguments)
        err = done.stderr.decode(errors="replace")
        told = f"relievo {arguments}: exit code {done.returncode}\n{err}"
        self.assertEqual(done.returncode, 2, told)
        self.assertEqual(done.stdout, b"", told)
        self.assertTrue(err.startswith("relievo: ") and err.endswith("\n") and err.count("\n") == 1, told)
        for name in [names] if isinstance(names, str) else names:
            self.assertIn(name, err, told)
        self.assertEqual(self.all_files(), before, told)
        return err
