"""What tessellate writes: the same bytes every time, words and numbers that belong together, meshes that check clean, measure alike and can
be the base of a second pass."""
import json
import pathlib
import re
import struct
import unittest

from command_line import SMALL, command_line

SCENES = [
    ["--mesh", "plane:2", "--displacement", "half-donut:64", "--tests", "nt,sht,pt,vt,ct"],
    ["--mesh", "sphere:3", "--displacement", "sine:32"],
    ["--mesh", "cylinder:6,2", "--displacement", "sine:32", "--scale", "0.1"],
    ["--mesh", "octahedron", "--displacement", "text:48", "--scale", "0.1", "--max-generation", "4"],
    ["--mesh", "teapot:1", "--displacement", "half-donut:32", "--scale", "0.1", "--max-generation", "3"],
]
SIZES = {"double": ("d", 8), "int": ("i", 4), "uint": ("I", 4), "float": ("f", 4), "uchar": ("B", 1)}


def fractions():
    """Fractional bits of each format, from the table of formats."""
    table = (pathlib.Path(__file__).parents[2] / "hls/core/formats.hpp").read_text()
    return {name: int(width) - int(integer) for name, width, integer in re.findall(r"X\((\w+), +(\d+), +(-?\d+),", table)}


def read_ply(data):
    """Comments and vertices (a dictionary each) of a .ply of ours."""
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    fields = [line.split()[1:] for line in lines if line.startswith("property") and "list" not in line and "base_triangle" not in line]
    form = struct.Struct("<" + "".join(SIZES[kind][0] for kind, _ in fields))
    names = [name for _, name in fields]
    return [line for line in lines if line.startswith("comment")], [dict(zip(names, v)) for v in form.iter_unpack(body[:count * form.size])]


class outputs(command_line):
    def error_of(self, report):
        return json.loads(self.bytes_of(report))["error"]["mesh"]

    def test_the_same_run_gives_the_same_bytes(self):
        names = ["out.obj", "out.ply", "out.glb", "out.png", "out.vec", "out.json"]
        runs = []
        for _ in range(2):
            self.done("tessellate", *SMALL, "-o", "out.obj", "-o", "out.ply", "-o", "out.glb", "--raw", "--image", "out.png", "--wireframe",
                      "--vectors", "out.vec", "--measure-error", "--report", "out.json")
            self.assertEqual(sorted(self.all_files()), sorted(names))
            runs.append([self.bytes_of(name) for name in names[:-1]] + [json.loads(self.bytes_of("out.json"))])
        for run in runs:
            self.assertGreaterEqual(run[-1].pop("seconds"), 0)
            self.assertEqual([content[:4] for content in run[:5]], [b"# 13", b"ply\n", b"glTF", b"\x89PNG", b"reli"])
        for name, first, second in zip(names, *runs):
            with self.subTest(name=name):
                self.assertEqual(first, second)

    def test_golden_and_hls_write_the_same_files(self):
        for model in ("golden", "hls"):
            self.done("tessellate", *SMALL, "--model", model, "-o", model + ".ply", "--raw", "-o", model + ".obj", "--vectors", model + ".vec")
        for extension in ("ply", "obj", "vec"):
            self.assertEqual(self.bytes_of("golden." + extension), self.bytes_of("hls." + extension))

    def test_raw_words_are_the_numbers(self):
        self.done("tessellate", *SCENES[2], "-o", "raw.ply", "--raw")
        self.done("tessellate", *SCENES[2], "-o", "plain.ply")
        comments, vertices = read_ply(self.bytes_of("raw.ply"))
        words = next(line for line in comments if "world_scale" in line).split()
        scale, centre = float(words[3]), [float(w) for w in words[5:8]]
        width, height = int(words[9]), int(words[10])
        span = [width if words[11] == "wrap" else width - 1, height if words[12] == "wrap" else height - 1]
        bits = fractions()
        for v in vertices:
            for axis, c in zip("xyz", centre):
                self.assertEqual(v[axis], v["raw_" + axis] / 2**bits["position"] / scale + c)
                self.assertEqual(v["p" + axis], v["raw_p" + axis] / 2**bits["position"] / scale + c)
                self.assertEqual(v["n" + axis], v["raw_n" + axis] / 2**bits["unit"])
                self.assertEqual(v["t" + axis], v["raw_t" + axis] / 2**bits["unit"])
            for axis, texels in zip("st", span):
                self.assertAlmostEqual(v[axis], v["raw_" + axis] / 2**bits["coordinate"] / texels, delta=1e-15)
        plain_comments, plain = read_ply(self.bytes_of("plain.ply"))
        self.assertEqual(plain_comments, comments)
        self.assertEqual([{k: v[k] for k in plain[0]} for v in vertices], plain)

    def test_files_check_clean_and_measure_as_the_report_says(self):
        for scene in SCENES:
            with self.subTest(scene=scene):
                self.done("tessellate", *scene, "-o", "out.ply", "-o", "out.obj", "-o", "out.glb", "--measure-error", "--report", "made.json")
                made = self.error_of("made.json")
                self.assertIn("watertight", self.done("check", "out.ply", *scene)[0])
                self.assertIn("watertight", self.done("check", "--model", "hls", *scene)[0])
                for name, relative in (("out.ply", 1e-6), ("out.obj", 1e-6), ("out.glb", 1e-2)):
                    self.done("error", name, *scene, "--report", "read.json")
                    read = self.error_of("read.json")
                    for figure in ("rms", "max", "mean"):
                        self.assertAlmostEqual(read["world"][figure], made["world"][figure], delta=relative * made["world"][figure])

    def test_a_mesh_is_the_base_of_a_second_pass(self):
        first = ["--mesh", "plane:2", "--displacement", "half-donut:64", "--scale", "0.3", "--max-generation", "4"]
        self.done("tessellate", *first, "-o", "first.ply", "-o", "first.obj")
        for name in ("first.ply", "first.obj"):
            with self.subTest(name=name):
                second = ["--mesh", name, "--displacement", "sine:64", "--scale", "0.02", "--max-generation", "2", "--tests", "nt,pt,vt,ct"]
                self.done("tessellate", *second, "-o", "second.ply")
                self.done("check", "second.ply", *second)
                self.done("check", "second.ply", "--base", name)
                self.assertGreater(len(read_ply(self.bytes_of("second.ply"))[1]), len(read_ply(self.bytes_of("first.ply"))[1]))
                self.done("compare", *second)

    def test_a_broken_mesh_is_found(self):
        scene = ["--mesh", "plane:2", "--displacement", "half-donut:32"]
        self.done("tessellate", *scene, "-o", "out.obj")
        self.done("check", "out.obj", *scene)
        lines = self.bytes_of("out.obj").decode().splitlines()
        vertices = [i for i, line in enumerate(lines) if line.startswith("v ")]
        faces = [i for i, line in enumerate(lines) if line.startswith("f ")]
        middle = faces[len(faces) // 2]
        moved = lines[vertices[int(lines[middle].split()[1].split("/")[0]) - 1]].split()
        moved[3] = str(float(moved[3]) + 0.05)
        a, b, c = lines[middle].split()[1:]
        broken = {
            "a corner of one triangle moved": lines[:middle] + [" ".join(moved), f"f {len(vertices) + 1}{a[a.index('/'):]} {b} {c}"] + lines[middle + 1:],
            "a triangle missing": lines[:middle] + lines[middle + 1:],
            "a triangle turned over": lines[:middle] + [f"f {a} {c} {b}"] + lines[middle + 1:],
            "a triangle twice": lines + [lines[middle]],
        }
        for what, text in broken.items():
            with self.subTest(what=what):
                self.put("bad.obj", "\n".join(text) + "\n")
                out, _ = self.run_to(1, "check", "bad.obj", *scene, "--report", "bad.json")
                self.assertIn("NOT watertight", out)
                self.assertIs(json.loads(self.bytes_of("bad.json"))["clean"], False)


if __name__ == "__main__":
    unittest.main()
