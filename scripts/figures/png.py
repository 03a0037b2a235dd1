"""As much of PNG as the figures need: 16-bit grey maps in; 8-bit pictures in and out, to join two of them."""
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _read(path):
    data = open(path, "rb").read()
    if data[:8] != SIGNATURE:
        raise ValueError(f"{path}: not a PNG file")
    chunks, at = {}, 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        chunks[kind] = chunks.get(kind, b"") + data[at + 8:at + 8 + length]
        at += 12 + length
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    pixel = {0: 1, 2: 3, 3: 1}.get(colour, 0) * depth // 8
    if not pixel or interlaced:
        raise ValueError(f"{path}: grey, palette or RGB without interlacing is needed")
    return width, height, depth, colour, chunks, _unfiltered(zlib.decompress(chunks[b"IDAT"]), width * pixel, pixel)


def _paeth(a, b, c):
    pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def _unfiltered(data, stride, pixel):
    rows, above = [], bytearray(stride)
    for at in range(0, len(data), stride + 1):
        kind, row = data[at], bytearray(data[at + 1:at + 1 + stride])
        for i in range(stride if kind else 0):
            a = row[i - pixel] if i >= pixel else 0
            b, c = above[i], above[i - pixel] if i >= pixel else 0
            row[i] = row[i] + (0, a, b, (a + b) // 2, _paeth(a, b, c))[kind] & 255
        rows.append(row)
        above = row
    return rows


def read_grey16(path):
    """Width, height, rows of samples 0..65535."""
    width, height, depth, colour, _, rows = _read(path)
    if (depth, colour) != (16, 0):
        raise ValueError(f"{path}: a 16-bit grey picture is needed")
    return width, height, [list(struct.unpack(">%dH" % width, row)) for row in rows]


def read_rgb(path):
    """Width, height, rows of (r, g, b)."""
    width, height, depth, colour, chunks, rows = _read(path)
    if depth != 8 or colour == 0:
        raise ValueError(f"{path}: an 8-bit palette or RGB picture is needed")
    if colour == 2:
        return width, height, [[tuple(row[i:i + 3]) for i in range(0, 3 * width, 3)] for row in rows]
    table = [tuple(chunks[b"PLTE"][i:i + 3]) for i in range(0, len(chunks[b"PLTE"]), 3)]
    return width, height, [[table[i] for i in row] for row in rows]


def write_palette(path, width, height, rows):
    """Rows of (r, g, b), at most 256 different ones."""
    colours = sorted({c for row in rows for c in row}, key=sum)
    if len(colours) > 256:
        raise ValueError(f"{path}: {len(colours)} colours, a palette holds 256")
    index = {c: i for i, c in enumerate(colours)}
    coded = [bytes(index[c] for c in row) for row in rows]
    # Without filters, or each pixel less the one to its left, whichever is smaller.
    plain = b"".join(b"\0" + row for row in coded)
    left = b"".join(b"\1" + bytes([row[0]]) + bytes(b - a & 255 for a, b in zip(row, row[1:])) for row in coded)
    packed = min((zlib.compress(d, 9) for d in (plain, left)), key=len)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)) +
                   chunk(b"PLTE", b"".join(map(bytes, colours))) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def split(path, left, right, slant=0.25):
    """One picture: `left` before a slanting line through the middle, `right` behind it."""
    width, height, a = read_rgb(left)
    _, _, b = read_rgb(right)
    rows = []
    for y in range(height):
        x = min(width, max(0, round(0.5 * width + slant * (0.5 * height - y))))
        rows.append(a[y][:x] + b[y][x:])
    write_palette(path, width, height, rows)
