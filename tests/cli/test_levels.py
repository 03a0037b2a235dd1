"""relievo map levels: the file is a map and its levels, a line tells of each; what cannot be used is one line and no file."""
import re
import struct
import unittest

from command_line import command_line

KINDS = ("averaged", "maximum", "minimum", "variational")


class levels(command_line):
    def lines(self, *arguments):
        """(level, width, height, volume, percent of the averaged level's or None, iterations or None) of each line."""
        out, err = self.done("map", "levels", *arguments)
        self.assertEqual(err, "")
        found = re.findall(r"^ +level (\d+) +(\d+) x (\d+) texels, volume ([\d,]+), mean distance [\d.]+"
                           r"(?:, ([\d.]+) % of the averaged level's [\d,]+)?(?:, ([\d,]+) iterations)?$", out, re.MULTILINE)
        self.assertEqual(len(found) + 1, out.count("\n"), out)
        return [(int(l), int(w), int(h), int(v.replace(",", "")), float(p) if p else None, int(i.replace(",", "")) if i else None)
                for l, w, h, v, p, i in found]

    def test_every_kind_has_every_level(self):
        for kind in KINDS:
            with self.subTest(kind=kind):
                told = self.lines("text:37,20", "--kind", kind, "-o", kind + ".exr")
                self.assertEqual([line[:3] for line in told], [(1, 19, 10), (2, 10, 5), (3, 5, 3), (4, 3, 2), (5, 2, 1), (6, 1, 1)])
                for line in told:
                    self.assertEqual(line[4] is None, kind == "averaged")
                    self.assertEqual(line[5] is None, kind != "variational")
                out, _ = self.done("map", "info", kind + ".exr")
                self.assertRegex(out, rf"size +37 x 20 samples")
                self.assertRegex(out, rf"filter levels +7, {kind}, clamp,clamp, ")
        self.assertEqual(set(self.all_files()), {kind + ".exr" for kind in KINDS})

    def test_variational_levels_are_nearer_to_the_map(self):
        averaged = self.lines("text:90,50", "--kind", "averaged", "-o", "a.exr")
        fitted = self.lines("text:90,50", "--kind", "variational", "-o", "v.exr")
        once = self.lines("text:90,50", "--kind", "variational", "--iterations", "1", "-o", "o.exr")
        for before, after, one in zip(averaged, fitted, once):
            self.assertLessEqual(after[3], before[3])
            self.assertEqual(one[5], 1)
            self.assertLessEqual(after[3], one[3])
        self.assertLess(fitted[0][4], 95)

    def test_volumes_are_in_units_of_the_range(self):
        plain = self.lines("half-donut:64", "--kind", "averaged", "-o", "a.exr")
        ranged = self.lines("half-donut:64", "--kind", "averaged", "--sample-range", "0,6553500", "-o", "a.exr")
        for one, hundred in zip(plain, ranged):
            self.assertAlmostEqual(hundred[3] / one[3], 100, delta=1)

    def test_borders_are_kept_and_change_the_levels(self):
        self.lines("ramp:16,16", "--kind", "averaged", "-o", "clamp.exr")
        self.lines("ramp:16,16", "--kind", "averaged", "--address", "wrap,clamp", "-o", "wrap.exr")
        self.assertRegex(self.done("map", "info", "wrap.exr")[0], r"filter levels +5, averaged, wrap,clamp, 682 bytes")
        self.assertNotEqual(self.bytes_of("clamp.exr"), self.bytes_of("wrap.exr"))

    def test_the_same_map_gives_the_same_bytes_and_the_file_is_a_map(self):
        self.done("map", "generate", "sine:23,40", "-o", "map.png")
        for source, name in (("sine:23,40", "a.exr"), ("map.png", "b.exr"), ("b.exr", "c.exr")):
            self.lines(source, "--kind", "variational", "-o", name)
        self.assertEqual(self.bytes_of("a.exr"), self.bytes_of("b.exr"))
        self.assertEqual(self.bytes_of("a.exr"), self.bytes_of("c.exr"))
        for source, name in (("map.png", "png.ply"), ("a.exr", "exr.ply")):
            self.done("tessellate", "--mesh", "plane:2", "--displacement", source, "-o", name)
        self.assertEqual(self.bytes_of("png.ply"), self.bytes_of("exr.ply"))

    def test_bad_options_are_refused(self):
        good = ["map", "levels", "sine:16"]
        self.refused(*good, "--kind", "mean", "-o", "out.exr", names=["--kind", "'mean'", "averaged, maximum, minimum or variational"])
        self.refused(*good, "-o", "out.exr", names="--kind")
        self.refused(*good, "--kind", "averaged", names="--output")
        for name in ("out.png", "out", "exr", "out.exr.gz"):
            self.refused(*good, "--kind", "averaged", "-o", name, names=[name, ".exr"])
        for name in ("missing/out.exr", ""):
            self.refused(*good, "--kind", "averaged", "-o", name, names=name)
        for value in ("0", "-1", "x", "1.5", "99999999999"):
            self.refused(*good, "--kind", "variational", "--iterations", value, "-o", "out.exr", names="--iterations")
        self.refused(*good, "--kind", "maximum", "--iterations", "3", "-o", "out.exr", names=["--iterations", "variational"])
        self.refused(*good, "--kind", "averaged", "--address", "mirror", "-o", "out.exr", names="--address")
        self.refused(*good, "--kind", "averaged", "--sample-range", "5,5", "-o", "out.exr", names="--sample-range")
        self.refused(*good, "--kind", "averaged", "--sample-range", "5", "-o", "out.exr", names="--sample-range")

    def test_unreadable_maps_are_refused_and_earlier_files_stay(self):
        self.put("out.exr", "earlier")
        self.put("text.png", "no picture")
        self.put("cut.pgm", b"P5\n4 4\n65535\n" + bytes(7))
        for name in ("missing.png", "text.png", "cut.pgm", "sine:9000", "wave"):
            with self.subTest(name=name):
                self.refused("map", "levels", name, "--kind", "averaged", "-o", "out.exr", names=name)

    def test_damaged_level_files_are_refused(self):
        self.lines("text:30,20", "--kind", "minimum", "-o", "good.exr")
        good = self.bytes_of("good.exr")
        checksum = good.index(b"levelChecksum\0int\0") + len(b"levelChecksum\0int\0") + 4
        for what, content, names in (
                ("cut", good[:-9], ""),
                ("cut in the tiles", good[:len(good) // 2], ""),
                ("another kind", good.replace(b"minimum", b"minimax"), "minimax"),
                ("another border", good.replace(b"clamp,clamp", b"clamp,klamp"), "klamp"),
                ("another checksum", good[:checksum] + struct.pack("<I", 1) + good[checksum + 4:], "checksum")):
            with self.subTest(what=what):
                self.put("bad.exr", content)
                self.refused("map", "info", "bad.exr", names=["bad.exr", names])


if __name__ == "__main__":
    unittest.main()
