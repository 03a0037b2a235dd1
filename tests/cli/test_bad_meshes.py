"""Mesh files that cannot be used, in each of the formats, and those that only look odd."""
import json
import struct
import unittest

from command_line import QUAD, SMALL, command_line

PLY = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float nx
property float ny
property float nz
property float s
property float t
element face 1
property list uchar int vertex_indices
end_header
-1 -1 0 0 0 1 0 0
1 -1 0 0 0 1 1 0
1 1 0 0 0 1 1 1
3 0 1 2
"""


def without(text, start):
    return "".join(line for line in text.splitlines(True) if not line.startswith(start))


# Name, content, what the line names beside the file.
BAD_OBJ = [
    ("no bytes", "", "empty"),
    ("a line break alone", "\n", ""),
    ("cut in a face", QUAD[:-8], ""),
    ("cut in a vertex", QUAD[:12], ""),
    ("no vt", without(QUAD, "vt").replace("1/1/1", "1//1").replace("2/2/1", "2//1").replace("3/3/1", "3//1").replace("4/4/1", "4//1"),
     "texture coordinates"),
    ("no vn", without(QUAD, "vn").replace("/1 ", " ").replace("/1\n", "\n"), "normals"),
    ("no faces", without(QUAD, "f"), "f"),
    ("a face without vt", QUAD.replace("3/3/1 4/4/1", "3//1 4//1"), "texture coordinates"),
    ("position nan", QUAD.replace("v 1 1 0", "v 1 nan 0"), "v"),
    ("position inf", QUAD.replace("v 1 1 0", "v 1 inf 0"), "v"),
    ("position huge", QUAD.replace("v 1 1 0", "v 1 1e20 0"), "1e9"),
    ("position beyond a double", QUAD.replace("v 1 1 0", "v 1 1e999 0"), "v"),
    ("normal nan", QUAD.replace("vn 0 0 1", "vn 0 0 nan"), "vn"),
    ("normal without a length", QUAD.replace("vn 0 0 1", "vn 0 0 0"), "normal"),
    ("coordinate nan", QUAD.replace("vt 1 1", "vt 1 nan"), "vt"),
    ("u above 1", QUAD.replace("vt 1 1", "vt 1.5 1"), "u = 1.5"),
    ("v below 0", QUAD.replace("vt 0 0", "vt 0 -0.25"), "v = -0.25"),
    ("two numbers for a position", QUAD.replace("v 1 1 0", "v 1 1"), "line 3"),
    ("no number", QUAD.replace("v 1 1 0", "v 1 one 0"), "one"),
    ("index out of range", QUAD.replace("4/4/1", "5/4/1"), "out of range"),
    ("vt index out of range", QUAD.replace("4/4/1", "4/5/1"), "out of range"),
    ("vn index out of range", QUAD.replace("4/4/1", "4/4/2"), "out of range"),
    ("index 0", QUAD.replace("4/4/1", "0/4/1"), "out of range"),
    ("negative index out of range", QUAD.replace("4/4/1", "-9/4/1"), "out of range"),
    ("index beyond 2^64", QUAD.replace("4/4/1", "99999999999999999999/4/1"), "index"),
    ("two corners", QUAD.replace(" 4/4/1", ""), "3 corners"),
    ("repeated index", QUAD.replace("3/3/1 4/4/1", "3/3/1 3/3/1"), "degenerate"),
    ("three triangles at an edge", QUAD + "v 0 0 1\nvt 0.5 0.5\nf 1/1/1 3/3/1 5/5/1\n", ""),
    ("four triangles at an edge, each way twice", QUAD + "v 0 0 1\nvt 0.5 0.5\nf 1/1/1 3/3/1 5/5/1\nf 3/3/1 1/1/1 5/5/1\n", "manifold"),
    ("one triangle turned over", QUAD.replace("f 1/1/1 3/3/1 4/4/1", "f 1/1/1 4/4/1 3/3/1"), ""),
    ("mirrored", QUAD.replace("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1", "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1"), "mirrored"),
    ("all of it one point of the map", QUAD.replace("vt 1 0\nvt 1 1\nvt 0 1", "vt 0 0\nvt 0 0\nvt 0 0"), "--texel-size"),
    ("UTF-16", ("\ufeff" + QUAD).encode("utf-16-le"), ""),
    ("UTF-16, big end first", ("\ufeff" + QUAD).encode("utf-16-be"), ""),
    ("a picture", b"\x89PNG\r\n\x1a\n" + bytes(100), ""),
    ("binary rubbish", bytes(range(256)) * 4, ""),
]

BAD_PLY = [
    ("no bytes", "", "empty"),
    ("wrong magic", PLY.replace("ply\n", "plx\n", 1), "ply"),
    ("header cut off", PLY[:60], "header"),
    ("body cut off", PLY[:-12], ""),
    ("no format", PLY.replace("format ascii 1.0\n", ""), "format"),
    ("unknown format", PLY.replace("ascii", "hex"), "hex"),
    ("unknown type", PLY.replace("float x", "real x"), "real"),
    ("count far beyond the file", PLY.replace("vertex 3", "vertex 4000000000"), ""),
    ("count is no number", PLY.replace("vertex 3", "vertex three"), "three"),
    ("no normals", without(PLY, "property float n").replace(" 0 0 1 ", " "), "normals"),
    ("no coordinates", without(without(PLY, "property float s"), "property float t").replace("1 0 0\n", "1\n").replace("1 1 0\n", "1\n")
     .replace("0 0 1 1 1\n", "0 0 1\n"), "texture coordinates"),
    ("position nan", PLY.replace("1 1 0 0 0 1 1 1", "nan 1 0 0 0 1 1 1"), ""),
    ("position huge", PLY.replace("1 1 0 0 0 1 1 1", "1e30 1 0 0 0 1 1 1"), ""),
    ("index out of range", PLY.replace("3 0 1 2", "3 0 1 3"), ""),
    ("negative index", PLY.replace("3 0 1 2", "3 0 1 -1"), ""),
    ("repeated index", PLY.replace("3 0 1 2", "3 0 1 1"), "degenerate"),
    ("two corners", PLY.replace("3 0 1 2", "2 0 1"), ""),
    ("UTF-16", PLY.encode("utf-16"), ""),
]


def glb(document, binary=b""):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    body = struct.pack("<I4s", len(text), b"JSON") + text + (struct.pack("<I4s", len(binary), b"BIN\0") + binary if binary else b"")
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


class bad_meshes(command_line):
    def refuse_all(self, extension, cases):
        for what, content, named in cases:
            with self.subTest(what=what):
                name = self.put("in." + extension, content)
                self.refused("tessellate", "--mesh", name, "--displacement", "sine:16", "-o", "out.ply", "--report", "out.json",
                             "--image", "out.png", "--vectors", "out.vec", names=[named] + ([name] if named != "--texel-size" else []))

    def test_obj(self):
        self.refuse_all("obj", BAD_OBJ)

    def test_ply(self):
        self.refuse_all("ply", BAD_PLY)

    def test_the_good_ones_are_good(self):
        for name, content in (("good.obj", QUAD), ("good.ply", PLY)):
            self.put(name, content)
            self.done("tessellate", "--mesh", name, "--displacement", "sine:16", "-o", "out.ply")
            self.done("check", "out.ply", "--mesh", name, "--displacement", "sine:16")

    def test_files_of_our_own_cut_anywhere_are_refused(self):
        self.done("tessellate", "--mesh", "plane:1", "--displacement", "sine:8", "--max-generation", "0", "-o", "good.ply", "-o", "good.glb")
        for extension in ("ply", "glb"):
            whole = self.bytes_of("good." + extension)
            cuts = [0, 1, 4, 11, 12, 13, 20, 100, len(whole) // 2, len(whole) - 9, len(whole) - 1]
            self.refuse_all(extension, [(f"cut at {cut}", whole[:cut], "") for cut in cuts])

    def test_glb(self):
        self.done("tessellate", "--mesh", "plane:1", "--displacement", "sine:8", "--max-generation", "0", "-o", "good.glb")
        whole = self.bytes_of("good.glb")
        length = struct.unpack_from("<I", whole, 12)[0]
        document, binary = json.loads(whole[20:20 + length]), whole[28 + length:]

        def changed(change):
            copy = json.loads(json.dumps(document))
            change(copy)
            return glb(copy, binary)

        def without_attribute(name):
            return lambda d: d["meshes"][0]["primitives"][0]["attributes"].pop(name)

        def set_accessor(i, key, value):
            return lambda d: d["accessors"][i].update({key: value})

        position = document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]
        self.refuse_all("glb", [
            ("wrong magic", b"glTX" + whole[4:], ""),
            ("wrong version", whole[:4] + struct.pack("<I", 9) + whole[8:], ""),
            ("no JSON", whole[:20] + b"x" * length + whole[20 + length:], ""),
            ("no POSITION", changed(without_attribute("POSITION")), "POSITION"),
            ("no NORMAL", changed(without_attribute("NORMAL")), "normals"),
            ("no TEXCOORD_0", changed(without_attribute("TEXCOORD_0")), "texture coordinates"),
            ("count beyond the buffer", changed(set_accessor(position, "count", 10**9)), ""),
            ("accessor beyond the list", changed(lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(POSITION=99)), ""),
            ("lines", changed(lambda d: d["meshes"][0]["primitives"][0].update(mode=1)), "triangles"),
            ("nan positions", glb(document, struct.pack("<f", float("nan")) * (len(binary) // 4)), ""),
            ("no nodes", changed(lambda d: (d.pop("nodes"), d.pop("scenes"), d.pop("scene", None))), ""),
        ])

    def test_windows_line_ends_tabs_and_a_last_line_without_end_are_fine(self):
        scene = ["--displacement", "sine:16"]
        self.put("unix.obj", QUAD)
        self.put("other.obj", QUAD.replace("\n", "\r\n").replace(" ", "\t").rstrip())
        self.done("tessellate", "--mesh", "unix.obj", *scene, "-o", "unix.ply")
        self.done("tessellate", "--mesh", "other.obj", *scene, "-o", "other.ply")
        self.assertEqual(self.bytes_of("unix.ply"), self.bytes_of("other.ply"))

    def test_a_byte_order_mark_is_fine(self):
        self.put("plain.obj", QUAD)
        self.put("marked.obj", "\ufeff" + QUAD)
        for name in ("plain", "marked"):
            self.done("tessellate", "--mesh", name + ".obj", "--displacement", "sine:16", "-o", name + ".ply")
        self.assertEqual(self.bytes_of("plain.ply"), self.bytes_of("marked.ply"))

    def test_names_that_are_no_mesh(self):
        (self.folder / "folder.obj").mkdir()
        self.put("mesh.stl", QUAD)
        for name in ("missing.obj", "folder.obj", "mesh.stl", "missing/mesh.ply"):
            with self.subTest(name=name):
                self.refused("tessellate", "--mesh", name, "-o", "out.ply", names=name)
                self.refused("check", name, names=name)
                self.refused("check", "--model", "golden", "--mesh", name, names=name)
                self.refused("error", name, *SMALL, names=name)

    def test_check_and_error_refuse_damaged_files_too(self):
        for name, content in (("in.obj", QUAD.replace("4/4/1", "9/9/9")), ("in.ply", PLY[:-12]), ("in.glb", b"glTF")):
            self.put(name, content)
            with self.subTest(name=name):
                self.refused("check", name, "--report", "out.json", names=name)
                self.refused("error", name, *SMALL, "--report", "out.json", names=name)
        self.put("good.obj", QUAD)
        self.refused("check", "good.obj", "--base", "in.obj", names="in.obj")

    def test_a_name_that_is_no_utf8_reaches_the_report(self):
        name = b"\xff\xfe.obj"
        (self.folder / name.decode(errors="surrogateescape")).write_text(QUAD)
        self.done("tessellate", "--mesh", name.decode(errors="surrogateescape"), "--displacement", "sine:16", "--report", "out.json")
        json.loads(self.bytes_of("out.json").decode())


if __name__ == "__main__":
    unittest.main()
