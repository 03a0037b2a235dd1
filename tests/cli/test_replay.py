"""Recorded vectors: they run again, a changed word is found and named, a damaged file is refused."""
import re
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
        for model in ("golden", "hls"):
            out, _ = self.done("replay", "good.vec", "--model", model)
            self.assertRegex(out, r"engine: [\d,]+ records, 0 differ")

    def test_a_tampered_word_is_found_and_its_field_named(self):
        def tamper(line):
            words = line.split()
            words[1] = format(int(words[1], 16) ^ 1, "x")
            return " ".join(words)

        record = 3
        self.put("bad.vec", self.changed(self.lines("o")[record], tamper))
        for model in ("golden", "hls"):
            out, _ = self.run_to(1, "replay", "bad.vec", "--model", model)
            self.assertIn(f"record {record}, field v[0].p[0]:", out)
            self.assertIn("1 differ", out)

    def test_a_missing_record_is_found(self):
        self.put("bad.vec", self.changed(self.lines("o")[-1], lambda line: "").rstrip() + "\n")
        out, _ = self.run_to(1, "replay", "bad.vec")
        self.assertRegex(out, r"recorded, [\d,]+ put out")

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
            ("lines out of order", self.good + self.good.splitlines()[texels] + "\n", "texels"),
            ("UTF-16", self.good[:400].encode("utf-16"), "line 1"),
            ("windows line ends", self.good.replace("\n", "\r\n"), "line 1"),
        ]
        for what, content, named in cases:
            with self.subTest(what=what):
                self.put("bad.vec", content)
                self.refused("replay", "bad.vec", names=["bad.vec", named])

    def test_a_model_or_a_file_that_is_not_there(self):
        for model in ("ideal", "rtl", "foo", ""):
            self.refused("replay", "good.vec", "--model", model, names="--model")
        self.refused("replay", "missing.vec", names="missing.vec")


if __name__ == "__main__":
    unittest.main()
