"""The sweep engine on the command line: models, reports and outputs of small scenes; what it does not take is refused in one line."""
import json
import unittest

from command_line import QUAD, command_line


def scene(mesh="plane:2", grid="10"):
    return ["--engine", "sweep", "--mesh", mesh, "--displacement", "sine:32", "--viewport", "320x240", "--grid", grid]


SWEEP = scene()
COUNTERS = ["triangles_in", "cut", "outside", "overflows", "pieces", "rejected", "primitives", "quads", "vertices", "triangles_out",
            "unseen", "saturations", "screen_saturations", "grid_saturations", "zero_vectors"]
THROUGH = [*scene("quad.obj"), "--eye", "0,0,0.4", "--at", "1,0,0", "--near", "0.1", "--far", "4"]

# Option, value, and what the line has to name.
BAD = [("--grid", "0", "--grid"), ("--grid", "-5", "--grid"), ("--grid", "0.5", "--grid"), ("--grid", "8192", "--grid"), ("--grid", "nan", "--grid"),
       ("--grid", "x", "--grid"), ("--near", "0", "--near"), ("--near", "-1", "--near"), ("--near", "1e-5", "--near"), ("--near", "nan", "--near"),
       ("--far", "0", "--far"), ("--far", "-1", "--far"), ("--far", "inf", "--far"), ("--fov", "0", "--fov"), ("--fov", "180", "--fov"),
       ("--fov", "-20", "--fov"), ("--fov", "200", "--fov"), ("--viewport", "0x0", "--viewport"),
       ("--model", "rtl", "no circuit"), ("--model", "top", "--model"), ("--tests", "nt", "--tests"), ("--cull", None, "--cull"),
       ("--max-generation", "3", "--max-generation"), ("--normal-threshold", "0.1", "--normal-threshold"),
       ("--vectors", "out.vec", "--vectors"), ("--base-triangle", "8", "--base-triangle")]


class sweep(command_line):
    def report_of(self, *arguments):
        out, _ = self.done(*arguments, "--report", "out.json")
        return out, json.loads(self.bytes_of("out.json"))

    def test_every_model_counts_the_same_and_says_so(self):
        reports = {}
        for model in ("ideal", "golden", "hls"):
            out, reports[model] = self.report_of("tessellate", *SWEEP, "--model", model)
            self.assertRegex(out, r"triangles +8 in, [\d,]+ out")
            self.assertRegex(out, r"primitives +[\d,]+, [\d,]+ of them quads")
            self.assertEqual("additions" in out, model == "hls")
            self.assertEqual(reports[model]["scene"]["engine"], "sweep")
            self.assertEqual(reports[model]["scene"]["grid"], 10)
            self.assertNotIn("tests", reports[model]["scene"])
        for name in COUNTERS:
            self.assertEqual(reports["golden"][name], reports["hls"][name], name)
        hls = reports["hls"]
        self.assertEqual(hls["triangles_out"] + hls["unseen"], hls["primitives"] + hls["quads"])
        self.assertGreater(hls["quads"], 100)
        self.assertGreater(hls["additions"], hls["quads"])

    def test_a_finer_grid_makes_more(self):
        sizes = []
        for grid in ("45", "20", "5"):
            sizes.append(self.report_of("tessellate", *scene(grid=grid))[1]["triangles_out"])
        self.assertGreater(sizes[1], 3 * sizes[0])
        self.assertGreater(sizes[2], 10 * sizes[1])

    def test_what_lies_before_the_near_plane_is_cut(self):
        self.put("quad.obj", QUAD)
        out, report = self.report_of("compare", *THROUGH)
        self.assertRegex(out, r"clipped +\d+ outside, [12] cut, \d+ pieces")
        self.assertIs(report["equal"], True)
        self.assertGreater(report["cut"], 0)
        self.assertGreater(report["unseen"], 0)
        for model in ("ideal", "golden", "hls"):
            self.done("check", "--model", model, *THROUGH)

    def test_models_are_equal_and_whole(self):
        for mesh in ("plane:2", "cylinder:5,2", "sphere:4", "octahedron", "teapot:1"):
            with self.subTest(mesh=mesh):
                self.assertRegex(self.done("compare", *scene(mesh))[0], r"hls = golden: [\d,]+ triangles, 0 words differ")
                for model in ("golden", "hls"):
                    self.done("check", "--model", model, *scene(mesh))

    def test_meshes_pictures_and_the_error_of_the_surface(self):
        out, report = self.report_of("tessellate", *SWEEP, "-o", "out.ply", "-o", "out.obj", "-o", "out.glb", "--image", "out.png",
                                     "--measure-error")
        fine = self.report_of("tessellate", *scene(grid="3"), "--measure-error")[1]
        self.assertLess(fine["error"]["mesh"]["world"]["rms"], 0.5 * report["error"]["mesh"]["world"]["rms"])
        self.done("check", "out.ply")
        self.done("tessellate", "--mesh", "out.ply", "--displacement", "sine:32", "--scale", "0.001", "--texel-size", "0.06,0.06", "-o", "again.ply")

    def test_what_cannot_be_is_refused(self):
        for option, value, named in BAD:
            with self.subTest(option=option, value=value):
                others = [word for pair in zip(SWEEP[::2], SWEEP[1::2]) if pair[0] != option for word in pair]
                given = [option] if value is None else [option + "=" + value]
                self.refused("tessellate", *others, *given, "-o", "out.ply", "--report", "out.json", names=named)

    def test_planes_that_cannot_be_are_refused(self):
        self.refused("tessellate", *SWEEP, "--near", "2", "--far", "1", names=["--near", "--far"])
        self.refused("tessellate", *SWEEP, "--near", "1", "--far", "1", names=["--near", "--far"])
        eye = ["--eye", "0,-3,0", "--at", "0,0,0", "--near", "0.01", "--far", "4"]
        self.refused("compare", *scene(grid="1"), *eye, "--fov", "1", names=["--near", "--far", "--grid", "16383"])
        self.refused("check", "--model", "hls", *scene(grid="1"), *eye, "--fov", "1", names=["--near", "--far", "--grid", "16383"])

    def test_what_is_the_edge_engines_alone_is_refused(self):
        self.refused("compare", *SWEEP, "--rate", names="--rate")
        self.refused("compare", *SWEEP, "--decisions", names="--decisions")
        self.refused("bench", *SWEEP, names="--engine")
        self.refused("tessellate", "--mesh", "plane:2", "--grid", "5", names="--grid")


if __name__ == "__main__":
    unittest.main()
