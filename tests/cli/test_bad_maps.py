"""Displacement maps that cannot be used, in each of the formats, through every command that reads one."""
import struct
import unittest
import zlib

from command_line import command_line


def png(width, height, depth=16, colour=0, rows=None, magic=b"\x89PNG\r\n\x1a\n"):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    samples = {0: 1, 2: 3, 4: 2, 6: 4}.get(colour, 1)
    if rows is None:
        rows = (b"\0" + bytes((width * samples * depth + 7) // 8)) * height
    return (magic + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


GOOD = png(4, 4)

BAD_PNG = [
    ("no bytes", b""),
    ("wrong magic", png(4, 4, magic=b"\x89PNX\r\n\x1a\n")),
    ("magic alone", GOOD[:8]),
    ("cut in the header", GOOD[:20]),
    ("cut in the data", GOOD[:-20]),
    ("checksum", GOOD[:40] + bytes([GOOD[40] ^ 1]) + GOOD[41:]),
    ("no columns", png(0, 4)),
    ("no rows", png(4, 0)),
    ("too wide", png(8193, 1)),
    ("too high", png(1, 8193)),
    ("enormous", png(2000000000, 2000000000, rows=b"")),
    ("rows missing", png(4, 4, rows=b"\0" * 18)),
    ("text", b"P5\n2 2\n255\n0000"),
]

BAD_PGM = [
    ("no bytes", b""),
    ("wrong magic", b"P9\n2 2\n255\n0000"),
    ("a colour picture", b"P6\n1 1\n255\n000"),
    ("cut in the header", b"P5\n2"),
    ("no columns", b"P5\n0 2\n255\n"),
    ("too large", b"P5\n8193 1\n255\n" + bytes(8193)),
    ("enormous", b"P5\n99999999999 99999999999\n255\n0"),
    ("negative", b"P5\n-2 2\n255\n0000"),
    ("no maximum", b"P5\n2 2\n0\n0000"),
    ("maximum too large", b"P5\n2 2\n65536\n" + bytes(8)),
    ("samples missing", b"P5\n2 2\n65535\n" + bytes(7)),
    ("sample above the maximum", b"P2\n2 2\n10\n1 2 3 11\n"),
    ("no number", b"P2\n2 2\n10\n1 2 x 3\n"),
    ("UTF-16", "P2\n2 2\n10\n1 2 3 4\n".encode("utf-16")),
]


def exr(values, width, height, kind=2, channels=(b"Y",), version=2):
    def attribute(name, form, data):
        return name + b"\0" + form + b"\0" + struct.pack("<I", len(data)) + data

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = b"\x76\x2f\x31\x01" + struct.pack("<I", version)
    header += attribute(b"channels", b"chlist", b"".join(c + b"\0" + struct.pack("<IIii", kind, 0, 1, 1) for c in channels) + b"\0")
    header += attribute(b"compression", b"compression", b"\0") + attribute(b"dataWindow", b"box2i", window)
    header += attribute(b"displayWindow", b"box2i", window) + attribute(b"lineOrder", b"lineOrder", b"\0")
    header += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)) + attribute(b"screenWindowCenter", b"v2f", bytes(8))
    header += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)) + b"\0"
    row = width * len(channels) * 4
    first = len(header) + 8 * height
    table = b"".join(struct.pack("<Q", first + y * (8 + row)) for y in range(height))
    rows = b"".join(struct.pack("<II", y, row) + struct.pack(f"<{width * len(channels)}f", *values[y * width * len(channels):][:width * len(channels)])
                    for y in range(height))
    return header + table + rows


FLAT = exr([0.5] * 4, 2, 2)

BAD_EXR = [
    ("no bytes", b""),
    ("wrong magic", b"\0" + FLAT[1:]),
    ("magic alone", FLAT[:4]),
    ("cut in the header", FLAT[:60]),
    ("cut in the data", FLAT[:-5]),
    ("not a number", exr([0.5, float("nan"), 0.5, 0.5], 2, 2)),
    ("infinite", exr([0.5, float("inf"), 0.5, 0.5], 2, 2)),
    ("above the range", exr([0.5, 1.5, 0.5, 0.5], 2, 2)),
    ("below the range", exr([0.5, -0.5, 0.5, 0.5], 2, 2)),
    ("two channels", exr([0.5] * 8, 2, 2, channels=(b"A", b"B"))),
    ("too wide", exr([0.5] * 8193, 8193, 1)),
    ("integers", exr([0.5] * 4, 2, 2, kind=0)),
    ("deep", exr([0.5] * 4, 2, 2, version=2 | 0x800)),
]


class bad_maps(command_line):
    def refuse_all(self, extension, cases):
        for what, content in cases:
            with self.subTest(what=what):
                name = self.put("map." + extension, content)
                self.refused("tessellate", "--mesh", "plane:1", "--displacement", name, "-o", "out.ply", "--report", "out.json",
                             names=name)
                self.refused("map", "info", name, names=name)

    def test_png(self):
        self.refuse_all("png", BAD_PNG)

    def test_pgm(self):
        self.refuse_all("pgm", BAD_PGM)

    def test_exr(self):
        self.refuse_all("exr", BAD_EXR)

    def test_the_good_ones_are_good(self):
        for name, content in (("good.png", GOOD), ("good.pgm", b"P5\n2 2\n65535\n" + bytes(8)), ("windows.pgm", b"P2\r\n2 2\r\n10\r\n1 2 3 4\r\n"),
                              ("good.exr", FLAT)):
            with self.subTest(name=name):
                self.put(name, content)
                self.done("tessellate", "--mesh", "plane:1", "--displacement", name, "-o", "out.ply")

    def test_what_the_normals_and_the_table_are_made_of_is_checked_as_well(self):
        self.put("map.png", GOOD[:-20])
        for command in ("sat", "normals"):
            self.refused("map", command, "map.png", "-o", "out", names="map.png")

    def test_names_that_are_no_map(self):
        (self.folder / "folder.png").mkdir()
        self.put("map.tiff", GOOD)
        for name in ("missing.png", "folder.png", "map.tiff", "missing/map.exr"):
            with self.subTest(name=name):
                self.refused("tessellate", "--displacement", name, "-o", "out.ply", names=name)
                self.refused("map", "info", name, names=name)


if __name__ == "__main__":
    unittest.main()
