"""The model top: the engine's circuit among its buses, run through its registers. Its words and counters are golden's, and what its state
register says is wrong is one line. $RELIEVO_WRONG has hosts that do what a host may not."""
import json
import os
import subprocess
import sys
import unittest

import command_line
from command_line import SMALL

WRONG = os.environ["RELIEVO_WRONG"]
BUILT = os.environ["RELIEVO_TOP"] == "1"
OUTPUTS = ["-o", "out.ply", "--image", "out.png", "--report", "out.json", "--vectors", "out.vec"]
# What each error says: the field, what it was and what is right.
ERRORS = {
    "map-size-zero": "map.width x map.height are 0 x 32, where 1..8192 each are right",
    "map-size-too-large": "map.width x map.height are 32 x 8193, where 1..8192 each are right",
    "max-generation-too-large": "pass.max_generation is 13, where this build has 12 at most",
    "early-last": "the last base triangle came after 8, where expected_triangles is 9",
    "missing-last": "base triangle 8 of 8 came without last and tlast",
    "last-disagrees": "base triangle 2 has only one of last and tlast",
    "coordinate-outside-map": "the base triangle after 2 has a texture coordinate outside the map of 32 x 32 texels",
    "start-while-busy": "start was written while a mesh was running",
    "map-early-last": "tlast came before the last texel of a map of 32 x 32",
    "map-missing-last": "the last texel of a map of 32 x 32 came without tlast",
    "stopped": "stop was written before the packet was over",
    "memory-error": "a map memory answered a read with an error",
}
SCENES = [
    ["--mesh", "plane:2", "--displacement", "half-donut:64", "--tests", "nt,sht,pt,vt,ct"],
    ["--mesh", "plane:1", "--displacement", "ramp:1,9", "--address", "wrap,clamp"],
    ["--mesh", "cylinder:4,2", "--displacement", "sine:64,32", "--cull", "--queue", "fifo", "--stall", "30", "--idle", "30"],
    ["--mesh", "sphere:2", "--displacement", "sine:33,17", "--tests", "pt,ht,vt,ct", "--latency", "1-60", "--bursty", "--seed", "7"],
]


@unittest.skipUnless(BUILT, "a build without the register block has no top")
class top(command_line.command_line):
    def refused_by(self, program, *arguments, names):
        command_line.RELIEVO, kept = program, command_line.RELIEVO
        try:
            return self.refused(*arguments, names=names)
        finally:
            command_line.RELIEVO = kept

    def test_its_words_are_golden_s_whatever_the_traffic(self):
        for scene in SCENES:
            with self.subTest(scene=scene):
                out, _ = self.done("compare", *scene, "--models", "golden,top", "--report", "out.json")
                self.assertRegex(out, r"top = golden: [\d,]+ triangles, 0 words differ")
                report = json.loads(self.bytes_of("out.json"))
                self.assertEqual((report["equal"], report["words_different"]), (True, {"top": 0}))
                self.assertGreater(report["top"]["cycles"], report["edge_tests"])

    def test_the_report_has_the_registers(self):
        reports = {}
        for model in ("golden", "top"):
            out, _ = self.done("tessellate", *SMALL, "--model", model, "--report", "out.json", "-o", "out.ply")
            reports[model] = json.loads(self.bytes_of("out.json"))
        for key in ("triangles_in", "triangles_out", "edge_tests", "settled_skips", "splits", "vertices", "nt", "sht", "saturations"):
            self.assertEqual(reports["top"][key], reports["golden"][key], key)
        self.assertEqual(reports["top"]["top"]["build"],
                         {"lanes": 1, "sat_reads_per_clock": 3, "profile_samples_per_clock": 1, "queue_depth": 1024, "max_generation": 12})
        # Every word of both maps came out of the builders: a row and some clocks more than there are texels.
        self.assertTrue(1024 < reports["top"]["top"]["map_cycles"] < 1200, reports["top"]["top"])
        self.assertRegex(out, r"clocks +[\d,]+, [\d.]+ an edge test")
        self.done("check", "out.ply", *SMALL)

    def test_what_it_put_out_runs_again(self):
        self.done("tessellate", *SMALL, "--model", "top", "--vectors", "top.vec")
        for model in ("golden", "top"):
            self.assertIn("0 differ", self.done("replay", "top.vec", "--model", model)[0])
        self.done("replay", "unit.vec", "--record", "displace", "--count", "5")
        self.refused("replay", "unit.vec", "--model", "top", names=["--model", "top"])

    def test_more_generations_than_it_was_built_with(self):
        line = "relievo: edge engine: " + ERRORS["max-generation-too-large"] + "\n"
        for command in (["tessellate", "--model", "top", *OUTPUTS], ["compare", "--models", "golden,top", *OUTPUTS[:6]],
                        ["check", "--model", "top"], ["bench", "--report", "out.json"]):
            done = self.run_raw(*command, *SMALL, "--tests", "vt,ct", "--view-threshold", "1000", "--max-generation", "13")
            self.assertEqual((done.returncode, done.stderr.decode()), (2, line), command)
            self.assertEqual(self.all_files(), {}, command)

    def test_every_error_of_the_state_register(self):
        for error, text in ERRORS.items():
            with self.subTest(error=error):
                line = self.refused_by(WRONG, "tessellate", *SMALL, "--model", "host-" + error, *OUTPUTS, names=text)
                self.assertTrue(line.startswith("relievo: edge engine: "), line)
                done = subprocess.run([WRONG, "compare", *SMALL, "--models", "golden,host-" + error, *OUTPUTS[:6]], cwd=self.folder,
                                      capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr, self.all_files()), (2, line, {}))

    def test_a_memory_that_is_too_slow_for_the_watchdog(self):
        out, err = self.run_to(1, "tessellate", *SMALL, "--model", "top", "--latency", "5000", "--watchdog", "500", "--report", "out.json")
        self.assertRegex(out, r"^top: (table|quad|place|normal)_rsp: an answer does not come, \d+ are awaited; nothing moved for \d+ clocks, "
                              r"and the mesh is not done; \d+ base triangles and 0 texels wait, clock \d+\n$")
        self.assertEqual((err, self.all_files()), ("", {}))

    def test_it_has_no_waveform(self):
        self.refused("tessellate", *SMALL, "--model", "top", "--trace", "out.fst", names=["--trace", "rtl"])


class absent(command_line.command_line):
    @unittest.skipIf(BUILT, "this build has it")
    def test_a_build_without_it_says_so(self):
        self.refused("tessellate", *SMALL, "--model", "top", *OUTPUTS, names=["--model: top", "register block", "scripts/build.sh"])


if __name__ == "__main__":
    ran = unittest.main(exit=False)
    if ran.result.wasSuccessful() and not BUILT:
        print("SKIPPED: the model top needs the register block, which scripts/registers.sh could not make")
        sys.exit(77)
    sys.exit(not ran.result.wasSuccessful())
