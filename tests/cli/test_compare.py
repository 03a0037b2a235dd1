"""relievo compare: golden and hls put out equal words on small scenes of every kind, and the report says what the architecture promises."""
import json
import unittest

from command_line import QUAD, SMALL, command_line

KEYS = ["triangles_in", "triangles_out", "edge_tests", "splits", "queue_high_water", "saturations", "screen_saturations", "zero_vectors"]

SCENES = [
    ["--mesh", "plane:3", "--displacement", "half-donut:64"],
    ["--mesh", "plane:3", "--displacement", "checker:64", "--tests", "nt,sht,pt,vt,ct"],
    ["--mesh", "plane:2", "--displacement", "constant:16"],
    ["--mesh", "plane:2", "--displacement", "maximum:16", "--address", "wrap"],
    ["--mesh", "plane:1", "--displacement", "ramp:1,1"],
    ["--mesh", "plane:1", "--displacement", "ramp:1,9", "--address", "wrap,clamp"],
    ["--mesh", "plane:2", "--displacement", "sine:33,17", "--height-mode", "average", "--queue", "fifo"],
    ["--mesh", "cylinder:8,2", "--displacement", "sine:64,32", "--cull"],
    ["--mesh", "sphere:4", "--displacement", "sine:64,32", "--tests", "pt,ht,vt,ct"],
    ["--mesh", "octahedron", "--displacement", "text:64", "--scale", "-0.1", "--bias", "0.05"],
    ["--mesh", "teapot:1", "--displacement", "half-donut:32"],
    ["--mesh", "quad.obj", "--displacement", "sine:32", "--eye", "0,0,0", "--at", "1,0,0", "--sample-range", "0,10"],
    ["--mesh", "plane:2", "--displacement", "sine:32", "--tests", "none"],
    ["--mesh", "plane:2", "--displacement", "sine:32", "--max-generation", "0"],
]


class compare(command_line):
    def test_golden_and_hls_are_equal(self):
        self.put("quad.obj", QUAD)
        for scene in SCENES:
            with self.subTest(scene=scene):
                out, _ = self.done("compare", *scene, "--models", "golden,hls", "--report", "out.json")
                self.assertRegex(out, r"hls = golden: [\d,]+ triangles, 0 words differ")
                report = json.loads(self.bytes_of("out.json"))
                for key in KEYS:
                    self.assertIn(key, report)
                self.assertIs(report["equal"], True)
                self.assertEqual(report["words_different"], {"hls": 0})
                self.assertEqual(report["saturations"], 0)
                self.assertEqual(len(report["splits"]), 4)
                self.assertGreater(report["triangles_in"], 0)

    def test_every_model_reports_the_same_counters(self):
        reports = {}
        for model in ("ideal", "golden", "hls"):
            self.done("tessellate", *SMALL, "--model", model, "--report", model + ".json")
            reports[model] = json.loads(self.bytes_of(model + ".json"))
            for key in KEYS:
                self.assertIn(key, reports[model])
            self.assertEqual(reports[model]["model"], model)
        for key in KEYS:
            self.assertEqual(reports["golden"][key], reports["hls"][key])

    def test_warnings_go_to_stderr_once_and_do_not_fail(self):
        roof = QUAD.replace("v -1 1 0", "v -1 1 1").replace("vn 0 0 1", "vn 0 0 1\nvn 0 1 1").replace("3/3/1 4/4/1", "3/3/2 4/4/2")
        self.put("roof.obj", roof)
        for command in (["compare"], ["tessellate", "--model", "ideal"], ["check", "--model", "golden"], ["bench"]):
            with self.subTest(command=command):
                done = self.run_raw(*command, "--mesh", "roof.obj", "--displacement", "sine:16", "--max-generation", "1")
                err = done.stderr.decode()
                self.assertNotEqual(done.returncode, 2, err)
                self.assertEqual(err.count("\n"), 1, err)
                self.assertTrue(err.startswith("relievo: warning: "), err)

    def test_bench_reports_every_model(self):
        self.done("bench", "--mesh", "plane:1", "--displacement", "sine:16", "--report", "out.json")
        models = json.loads(self.bytes_of("out.json"))["models"]
        for model in ("ideal", "golden", "hls"):
            self.assertGreater(models[model]["edge_tests_per_second"], 0)


if __name__ == "__main__":
    unittest.main()
