"""Displacement maps of the figures, as 16-bit .pgm: formulas of the texel's place, and changes to maps of others.

Row 0 of a file is the top; y = 0 of a formula is the bottom, as v. Heights of formulas are 0..1.
"""
import math
import struct

import png


def write_pgm(path, width, height, rows):
    """rows: from the top, each a list of samples 0..65535."""
    with open(path, "wb") as file:
        file.write(b"P5\n%d %d\n65535\n" % (width, height))
        for row in rows:
            file.write(struct.pack(">%dH" % width, *row))


def read_pgm(path):
    """Width, height and rows of a 16-bit binary .pgm."""
    data = open(path, "rb").read()
    fields, at = [], 0
    while len(fields) < 4:
        end = data.index(b"\n", at)
        fields += data[at:end].split(b"#")[0].split()
        at = end + 1
    width, height = int(fields[1]), int(fields[2])
    samples = struct.unpack(">%dH" % (width * height), data[at:at + 2 * width * height])
    return width, height, [list(samples[y * width:(y + 1) * width]) for y in range(height)]


def from_formula(path, width, height, formula):
    def sample(x, y):
        return round(65535 * min(1.0, max(0.0, formula(x, y))))
    write_pgm(path, width, height, ([sample(x, height - 1 - row) for x in range(width)] for row in range(height)))


def bump(x, _):
    """Figure 5 a: one hump in the middle of the edge; upright normals at both ends and on its top."""
    c = (x - 127.5) / 80
    return (1 + math.cos(math.pi * c)) / 2 if abs(c) < 1 else 0.0


def ripple(x, _):
    """Figure 5 b: point-symmetric about the edge's middle, flat at its ends; every average is one half."""
    c = (x - 127.5) / 84
    return 0.5 + 0.5 * math.sin(3 * math.pi * c) * math.sqrt(math.cos(math.pi * c / 2)) if abs(c) < 1 else 0.5


def vase(x, y):
    """A turned vase, 512 x 456 like the scan of Figure 9, closed around u: profile, mouldings, flutes, scales."""
    u, v = x / 512, y / 455

    def hump(centre, width):
        return math.exp(-((v - centre) / width) ** 2)

    def between(low, high, soft):
        return min(1.0, max(0.0, (v - low) / soft)) * min(1.0, max(0.0, (high - v) / soft))

    radius = 0.30 + 0.42 * hump(0.42, 0.24) + 0.16 * hump(1.0, 0.06) + 0.26 * hump(0, 0.10)
    radius += 0.035 * sum(hump(c, 0.012) for c in (0.16, 0.655, 0.69, 0.93))
    radius += 0.035 * between(0.18, 0.36, 0.05) * abs(math.sin(28 * math.pi * u))
    row = (v - 0.38) / 0.0417
    across = (18 * u + (0.5 if math.floor(row) % 2 else 0.0)) % 1 - 0.5
    scale = math.hypot(across, row % 1 - 0.5) / 0.45
    return radius + 0.05 * between(0.38, 0.63, 0.02) * math.sqrt(max(0.0, 1 - scale * scale))


def studs(x, y):
    """Round studs in a triangular pattern, 16 across."""
    u, v = 16 * x / 511, 16 * y / 511 * 2 / math.sqrt(3)
    height = 0.0
    for row in (math.floor(v) - 1, math.floor(v), math.floor(v) + 1):
        k = u - (row % 2) / 2
        d = math.hypot(k - math.floor(k) - 0.5, (v - row - 0.5) * math.sqrt(3) / 2) / 0.46
        if d < 1:
            height = max(height, (1 + math.cos(math.pi * d)) / 2)
    return height


def flooded(path, source, level):
    """A 16-bit grey .png with everything below `level` (a sample) filled up to it."""
    width, height, rows = png.read_grey16(source)
    write_pgm(path, width, height, ([max(level, s) for s in row] for row in rows))


def stretched(path, source):
    """A .pgm whose samples (metres, say) use the whole 16 bits afterwards. Returns what 0 and 65535 mean."""
    width, height, rows = read_pgm(source)
    low, high = min(map(min, rows)), max(map(max, rows))
    write_pgm(path, width, height, ([round((s - low) * 65535 / (high - low)) for s in row] for row in rows))
    return low, high
