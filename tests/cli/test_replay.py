"""Recorded vectors: they run again, a changed word is found and named, a damaged file is refused."""
import os
import re
import shlex
import subprocess
import unittest

from command_line import SMALL, command_line


class replay(command_line):
    def setUp(self):
        super().setUp()
        self.done("tessellate", *SMALL, "--model", "golden", "--vectors", "good.vec")
        self.good = self.bytes_of("good.vec").decode()

    def lines(self, key):
        return [i for i, line in enumerate(self.good.splitlines()) if line.split()[0] == key]

    def changed(self, line, change):
        lines = self.good.splitlines()
        lines[line] = change(lines[line])
        return "\n".join(lines) + "\n"

    def test_every_model_says_the_same(self):
        for model in ("golden", "hls", "rtl"):
            out, _ = self.done("replay", "good.vec", "--model", model)
            self.assertRegex(out, r"engine: [\d,]+ records, 0 differ")

    def test_what_the_circuit_put_out_runs_again(self):
        # Its triangles overtake each other, which the file says.
        self.done("tessellate", *SMALL, "--model", "rtl", "--vectors", "rtl.vec")
        self.assertNotEqual(self.bytes_of("rtl.vec").decode().replace("order free\n", ""), self.good)
        for model in ("golden", "hls", "rtl"):
            self.assertIn("0 differ", self.done("replay", "rtl.vec", "--model", model)[0])
        self.done("replay", "good.vec", "--model", "rtl", "--stall", "40", "--idle", "30", "--latency", "1-50", "--seed", "3")

    def test_one_base_triangle_alone(self):
        out, _ = self.done("replay", "good.vec")
        everything = int(re.search(r"engine: ([\d,]+) records", out).group(1).replace(",", ""))
        alone = [self.done("replay", "good.vec", "--only", str(i), "--model", model)[0] for i in range(8) for model in ("hls", "rtl")]
        counts = [int(re.search(r"engine: (\d+) records, 0 differ", out).group(1)) for out in alone]
        self.assertEqual(sum(counts), 2 * everything)
        for number in ("8", "-1", "x"):
            self.refused("replay", "good.vec", "--only=" + number, names="--only")

    def test_a_tampered_word_is_found_and_its_field_named(self):
        def tamper(line):
            words = line.split()
            words[1] = format(int(words[1], 16) ^ 1, "x")
            return " ".join(words)

        record = 3
        self.put("bad.vec", self.changed(self.lines("o")[record], tamper))
        for model in ("golden", "hls", "rtl"):
            out, _ = self.run_to(1, "replay", "bad.vec", "--model", model)
            self.assertRegex(out, rf"triangle {record} of recorded \(base triangle \d, path [0-3]+\), unit calculate_new_p, field v\[0\].p\[0\]: recorded "
                                  rf"0x[0-9a-f]+ \([^)]+\), {model} 0x[0-9a-f]+ \([^)]+\); 1 of its 69 words differ")
            self.assertIn(" 1 differ", out)
            # The command that it names runs that base triangle alone and finds the same.
            command = shlex.split(re.search(r"^replay: (.*)$", out, re.MULTILINE).group(1))
            self.assertEqual(command[-2], "--only")
            again, _ = self.run_to(1, *command[1:])
            self.assertEqual(re.search(r"path.*", again).group(), re.search(r"path.*", out).group())

    def test_a_missing_record_is_found(self):
        self.put("bad.vec", self.changed(self.lines("o")[-1], lambda line: "").rstrip() + "\n")
        for model in ("hls", "rtl"):
            out, _ = self.run_to(1, "replay", "bad.vec", "--model", model)
            self.assertRegex(out, r"base triangle 7, path [0-3]+\), unit pass_or_tessellate: recorded has no such triangle")

    def test_a_circuit_that_hangs_has_failed_a_check(self):
        for command in (["replay", "good.vec"], ["tessellate", *SMALL, "--report", "out.json"]):
            out, err = self.run_to(1, *command, "--model", "rtl", "--latency", "1000", "--watchdog", "100")
            self.assertRegex(out, r"rtl: nothing moved for \d+ clocks, and displacement answers do not come, \d+ are awaited; all links:.* clock \d+")
            self.assertEqual(err, "")
        self.assertNotIn("out.json", self.all_files())

    def test_units_replay_through_their_circuits(self):
        program = os.environ.get("RELIEVO_UNITS_RTL")
        units = re.search(r"known are (.*)", self.refused("replay", "unit.vec", "--record", "no-such-unit", names="--record")).group(1).split(", ")
        for unit in units:
            with self.subTest(unit=unit):
                self.done("replay", "unit.vec", "--record", unit, "--count", "2000", "--seed", "5")
                # The command line itself has the engine alone, and says who has the units.
                self.refused("replay", "unit.vec", "--model", "rtl", names=["rtl", "relievo_units_rtl"])
                if program:
                    run = subprocess.run([program, "replay", "unit.vec", "--model", "rtl"], cwd=self.folder, capture_output=True, text=True)
                    self.assertEqual((run.returncode, run.stdout), (0, f"{unit}: 2,000 records, 0 differ (rtl, seed 5)\n"))
                    tampered = self.bytes_of("unit.vec").decode().splitlines()
                    at = [i for i, line in enumerate(tampered) if line.startswith("o ")][1234]
                    words = tampered[at].split()
                    words[1] = format(int(words[1], 16) ^ 1, "x")
                    tampered[at] = " ".join(words)
                    self.put("unit.vec", "\n".join(tampered) + "\n")
                    run = subprocess.run([program, "replay", "unit.vec", "--model", "rtl"], cwd=self.folder, capture_output=True, text=True)
                    self.assertEqual(run.returncode, 1)
                    self.assertIn(f"first difference: record 1234, unit {unit}, field ", run.stdout)
                    command = shlex.split(re.search(r"^replay: (.*)$", run.stdout, re.MULTILINE).group(1))
                    self.assertEqual(command[-2:], ["--only", "1234"])
                    again = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
                    self.assertEqual(again.returncode, 1)
                    self.assertIn(run.stdout.splitlines()[0], again.stdout)

    def test_units_record_and_replay(self):
        err = self.refused("replay", "unit.vec", "--record", "no-such-unit", names="--record")
        units = re.search(r"known are (.*)", err).group(1).split(", ")
        self.assertGreater(len(units), 5)
        for unit in units:
            with self.subTest(unit=unit):
                self.done("replay", "unit.vec", "--record", unit, "--count", "200", "--seed", "7")
                self.assertIn("0 differ", self.done("replay", "unit.vec")[0])

    def test_a_seed_gives_the_same_vectors(self):
        for name in ("a.vec", "b.vec"):
            self.done("replay", name, "--record", "displace", "--count", "50", "--seed", "9")
        self.done("replay", "c.vec", "--record", "displace", "--count", "50", "--seed", "10")
        self.assertEqual(self.bytes_of("a.vec"), self.bytes_of("b.vec"))
        self.assertNotEqual(self.bytes_of("a.vec"), self.bytes_of("c.vec"))

    def test_damaged_files_are_refused(self):
        regs, texels, first, out = self.lines("regs")[0], self.lines("texels")[0], self.lines("i")[0], self.lines("o")[0]
        cases = [
            ("no bytes", "", "empty"),
            ("wrong magic", "relievo-vector" + self.good[15:], "line 1"),
            ("later version", self.good.replace("relievo-vectors 1", "relievo-vectors 2", 1), "line 1"),
            ("unknown unit", self.good.replace("unit engine", "unit motor", 1), "motor"),
            ("other formats", re.sub(r"formats \w+", "formats 1234", self.good, count=1), "formats"),
            ("formats no hash", re.sub(r"formats \w+", "formats xyz", self.good, count=1), "xyz"),
            ("no seed", self.good.replace("seed 0\n", "", 1), "seed"),
            ("cut in a line", self.good[:-3], "cut off"),
            ("cut after the inputs", "\n".join(self.good.splitlines()[:out]) + "\n", "no vectors"),
            ("a word missing", self.changed(first, lambda line: line.rsplit(" ", 1)[0]), "line"),
            ("a word too many", self.changed(first, lambda line: line + " 0"), "more words"),
            ("a word too wide", self.changed(first, lambda line: "i fffffffff" + line[line.index(" ", 2):]), "bits"),
            ("no hex", self.changed(out, lambda line: "o zz" + line[line.index(" ", 2):]), "zz"),
            ("a row of the map missing", self.changed(texels, lambda line: "").replace("\n\n", "\n"), "line"),
            ("map without a size", self.changed(regs, lambda line: "regs 0" + line[line.index(" ", 5):]), "map size"),
            ("an order that is none", self.good.replace("seed 0\n", "seed 0\norder any\n", 1), "order"),
            ("lines out of order", self.good + self.good.splitlines()[texels] + "\n", "texels"),
            ("UTF-16", self.good[:400].encode("utf-16"), "line 1"),
            ("windows line ends", self.good.replace("\n", "\r\n"), "line 1"),
        ]
        for what, content, named in cases:
            with self.subTest(what=what):
                self.put("bad.vec", content)
                self.refused("replay", "bad.vec", names=["bad.vec", named])

    def test_a_model_or_a_file_that_is_not_there(self):
        for model in ("ideal", "foo", ""):
            self.refused("replay", "good.vec", "--model", model, names="--model")
        self.refused("replay", "missing.vec", names="missing.vec")


if __name__ == "__main__":
    unittest.main()
