"""The bench around somebody else's circuit: good ones pass in every traffic with latency and interval as their headers say; each broken copy
is refused for what is broken; unusable input is refused in one line."""
import os
import subprocess
import tempfile
import unittest

DISPLACE, VIEW_TEST, RELIEVO = (os.environ[name] for name in ("DISPLACE", "VIEW_TEST", "RELIEVO"))
WORD = r"displace: record \d+, field {field}: hls 0x[0-9a-f]+ \([^)]+\), rtl 0x[0-9a-f]+ \([^)]+\), clock \d+; idle \d+ %, stall \d+ %, seed 1\n"
SPOILT = {
    "word": WORD.format(field=r"p\[1\]"),
    "regs": WORD.format(field=r"(p\[[012]\]|saturated)"),
    "padding": r"displace: out_r: the bits beside the word are not zero, word 0, clock \d+; ",
    "drop": r"displace: out_r: valid fell before the word was taken, clock \d+; idle 0 %, stall 40 %",
    "change": r"displace: out_r: the word changed before it was taken, clock \d+; idle 0 %, stall 40 %",
    "lost": WORD.format(field=r"(p\[[012]\]|saturated)"),
    "twice": WORD.format(field=r"(p\[[012]\]|saturated)"),
    "hang": r"displace: nothing moved for 10000 clocks; in_r: a word waits after 200; out_r: idle after 200; clock \d+",
    "reset": r"displace: out_r: valid in reset, clock \d+",
    "slow": r"displace: a word takes 2\.\d+ clocks, where 1 is promised",
    "axi": r"displace: s_axi_control: a write was answered with an error, clock \d+",
}


def run(code, *command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == code, (command, done)
    return done.stdout, done.stderr


class foreign(unittest.TestCase):
    def test_good_circuits_pass(self):
        out, _ = run(0, DISPLACE)
        # 16 bursts of 625, and 10 corners of each of 7 words before 3 backgrounds, in 4 kinds of traffic.
        self.assertEqual(out, "displace: 40840 words, 0 differ; latency 13 clocks, 1.000 clocks a word\n")
        out, _ = run(0, VIEW_TEST, "--vectors", "1600", "--seed", "7")
        self.assertRegex(out, r"^view_test: \d+ words, 0 differ; latency 7 clocks, 1.000 clocks a word\n$")

    def test_broken_copies_are_refused(self):
        for kind, said in SPOILT.items():
            with self.subTest(kind=kind):
                out, err = run(1, DISPLACE, "+spoil=" + kind)
                self.assertRegex(out, said)
                self.assertEqual(err, "")
        run(0, DISPLACE, "+spoil=slow", "--interval", "2.5")

    def test_a_word_comes_with_what_went_in(self):
        out, _ = run(1, DISPLACE, "+spoil=word")
        for field in ("p[0]", "n[2]", "d", "regs.scale", "regs.bias"):
            self.assertRegex(out, rf"(?m)^  {field.replace('[', chr(92) + '[')} = 0x[0-9a-f]+ \(")

    def test_recorded_words(self):
        with tempfile.TemporaryDirectory() as folder:
            run(0, RELIEVO, "replay", "unit.vec", "--record", "displace", "--count", "3000", "--seed", "4", cwd=folder)
            out, _ = run(0, DISPLACE, "unit.vec", cwd=folder)
            self.assertRegex(out, r"^displace: 12000 words, 0 differ")
            out, _ = run(1, DISPLACE, "unit.vec", "+spoil=regs", cwd=folder)
            self.assertRegex(out, r"^displace: record \d+, field .*: recorded 0x")
            run(0, RELIEVO, "replay", "other.vec", "--record", "bump", cwd=folder)
            for file, said in (("other.vec", "holds words of bump"), ("missing.vec", "missing.vec")):
                out, err = run(2, DISPLACE, file, cwd=folder)
                self.assertEqual(out, "")
                self.assertRegex(err, rf"^displace: .*{said}.*\n$")

    def test_unusable_options(self):
        for option in ("--vectors=1", "--seed=x", "--interval=x", "--none"):
            _, err = run(2, DISPLACE, option)
            self.assertEqual(err.count("\n"), 1)
            self.assertIn(option.split("=")[0], err)


if __name__ == "__main__":
    unittest.main()
