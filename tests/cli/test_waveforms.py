"""Waveforms from the command line: every command that runs the circuit writes the window that was asked for, and a save file that names it; a
window that is none is refused. What is in the file is for tests/cosim/waveforms.cpp."""
import struct
import unittest

from command_line import SMALL, command_line

RTL = [*SMALL, "--max-generation", "2"]


class waveforms(command_line):
    def window_of(self, name):
        """First and last time of an FST file, in picoseconds: its first block is the header."""
        kind, length, first, last = struct.unpack_from(">BQQQ", self.bytes_of(name))
        self.assertEqual((kind, length), (0, 329))
        return first, last

    def test_the_window_is_the_one_asked_for(self):
        self.done("tessellate", *RTL, "--model", "hls", "--vectors", "in.vec")
        for number, command in enumerate((["tessellate", *RTL, "--model", "rtl"], ["compare", *RTL, "--models", "golden,rtl"],
                                          ["replay", "in.vec", "--model", "rtl"])):
            with self.subTest(command=command[0]):
                before = set(self.all_files())
                name = f"out {number}.fst"
                self.done(*command, "--trace", name, "--trace-from", "200", "--trace-cycles", "33")
                self.assertEqual(self.window_of(name), (200 * 1000 - 500, 232 * 1000))
                save = self.bytes_of(f"out {number}.gtkw").decode().splitlines()
                self.assertEqual(save[0], f'[dumpfile] "{self.folder / name}"')
                self.assertIn("TOP.engine.in_valid_i", save)
                self.assertEqual(set(self.all_files()) - before, {name, f"out {number}.gtkw"})

    def test_the_words_are_the_same_with_and_without(self):
        self.done("tessellate", *RTL, "--model", "rtl", "--vectors", "without.vec")
        self.done("tessellate", *RTL, "--model", "rtl", "--vectors", "with.vec", "--trace", "out.fst")
        self.assertEqual(self.bytes_of("with.vec"), self.bytes_of("without.vec"))

    def test_a_window_that_is_none_is_refused(self):
        run = ["tessellate", *RTL, "--model", "rtl", "-o", "out.ply"]
        for option, value in (("--trace-from", "0"), ("--trace-from", "-5"), ("--trace-cycles", "0"), ("--trace-from", "x"),
                              ("--trace-from", "100000000")):
            with self.subTest(option=option, value=value):
                self.refused(*run, "--trace", "out.fst", f"{option}={value}", names=option)
        self.refused(*run, "--trace-cycles", "5", names=["--trace-cycles", "--trace FILE.fst"])
        self.refused(*run, "--trace", "out.vcd", names=["--trace", "out.vcd"])
        self.refused(*run, "--trace", "nowhere/out.fst", names="nowhere/out.fst")
        self.refused("tessellate", *RTL, "--model", "hls", "--trace", "out.fst", names=["--trace", "rtl"])

    def test_a_run_that_fails_leaves_what_led_there(self):
        out, _ = self.run_to(1, "tessellate", *RTL, "--model", "rtl", "--latency", "1000", "--watchdog", "100", "--trace", "out.fst")
        clock = int(out.rsplit(" ", 1)[1])
        self.assertEqual(self.window_of("out.fst"), (500, clock * 1000))


if __name__ == "__main__":
    unittest.main()
