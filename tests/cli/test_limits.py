"""What the report says that the circuit waited for: the rows of the links, and the name of what took the clocks, for a sink and memories that
refuse words, for memories of a long latency, for a full pipeline, and for a mesh too small to fill it. Of a memory that delivers all it can:
tests/cosim/throughput.cpp."""
import json
import re
import unittest

from command_line import SMALL, command_line

LINKS = ["output triangles", "summed-area table requests", "displacement requests", "normal map requests"]


class limits(command_line):
    def limited_by(self, *arguments):
        """Of a small mesh, where no other is named: stdout, the report's part of the circuit, and the limit, which both tell."""
        out, _ = self.done("tessellate", *([] if "--mesh" in arguments else SMALL), "--model", "rtl", "--report", "out.json", *arguments)
        report = json.loads(self.bytes_of("out.json"))["rtl"]
        limit = re.search(r"^ +limited by +(.+)$", out, re.MULTILINE).group(1)
        self.assertEqual(report["limited_by"], limit)
        return out, report, limit

    def test_nothing_in_the_way(self):
        out, report, limit = self.limited_by()
        self.assertEqual(limit, "the way of a triangle through pipeline and memories, of which too few were under way, or a source that rests")
        self.assertEqual(re.findall(r"^ +waited +(.+): ", out, re.MULTILINE), ["base triangles"])
        self.assertEqual([name for name, link in report["links"].items() if link["waited"]], ["base triangles"])

    def test_words_that_are_refused(self):
        out, report, limit = self.limited_by("--stall", "60")
        self.assertEqual(re.findall(r"^ +waited +(.+): ", out, re.MULTILINE), ["base triangles", *LINKS])
        # The one that waited most, of those that the bench lets wait.
        shares = {name: link["waited"] / (link["moved"] + link["waited"] + link["idle"]) for name, link in report["links"].items()}
        worst = max(LINKS, key=shares.get)
        self.assertEqual(limit, f"{worst}: refused in {100 * shares[worst]:.0f} % of the clocks")
        self.assertGreater(shares[worst], 0.3)

    def test_memories_that_take_long(self):
        out, report, limit = self.limited_by("--latency", "400")
        self.assertRegex(limit, r"^(summed-area table|displacement|normal map) answers: latency, no more are awaited at once$")
        for name in ("summed-area table", "displacement", "normal map"):
            self.assertRegex(out, rf"memory +{name} answers: in \d+ % of the clocks, \d+ awaited on average, 128 at most\n")

    def test_a_full_pipeline(self):
        _, report, limit = self.limited_by("--mesh", "plane:4", "--displacement", "sine:64")
        self.assertEqual(limit, "no memory: the pipeline takes an edge in nearly every clock")
        self.assertLess(report["cycles_per_edge_test"], 1.1)


if __name__ == "__main__":
    unittest.main()
