"""relievo map: what it writes has the right size and, where that is quickly said, the right content; maps of the largest size fit."""
import math
import os
import resource
import struct
import subprocess
import time
import unittest

from command_line import RELIEVO, command_line

MIB = 1 << 20


class maps(command_line):
    def test_generated_maps_are_pictures_of_16_bits(self):
        for name, width, height in (("half-donut", 256, 256), ("sine:17", 17, 17), ("checker:8,3", 8, 3), ("text:40,9", 40, 9),
                                    ("constant:1,1", 1, 1), ("maximum:2,5", 2, 5), ("ramp:7,1", 7, 1)):
            with self.subTest(name=name):
                self.done("map", "generate", name, "-o", "map.png")
                png = self.bytes_of("map.png")
                self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
                self.assertEqual(struct.unpack(">IIBB", png[16:26]), (width, height, 16, 0))
                self.assertRegex(self.done("map", "info", "map.png")[0], rf"size +{width} x {height} samples")

    def test_a_written_map_is_the_same_map(self):
        self.done("map", "generate", "sine:40,30", "-o", "map.png")
        for command in ("sat", "normals"):
            self.done("map", command, "map.png", "-o", "file." + command)
            self.done("map", command, "sine:40,30", "-o", "name." + command)
            self.assertEqual(self.bytes_of("file." + command), self.bytes_of("name." + command))
        for command in ("", "map.png"):
            self.done("tessellate", "--mesh", "plane:2", "--displacement", command or "sine:40,30", "-o", (command or "name") + ".ply")
        self.assertEqual(self.bytes_of("name.ply"), self.bytes_of("map.png.ply"))

    def test_info_says_range_and_memory(self):
        out, _ = self.done("map", "info", "ramp:11,4", "--sample-range", "100,200")
        self.assertRegex(out, r"size +11 x 4 samples")
        self.assertRegex(out, r"samples +0 \.\. 65535")
        self.assertIn("100.000 .. 200.000, mean 150.000", out)
        self.assertIn("88 bytes, table 220, normals 264", out)

    def test_the_table_sums_up_the_map(self):
        width, height = 13, 7
        self.done("map", "sat", f"maximum:{width},{height}", "-o", "map.sat")
        table = self.bytes_of("map.sat")
        self.assertEqual(len(table), 5 * width * height)
        for y in range(height):
            for x in range(width):
                at = 5 * (y * width + x)
                self.assertEqual(int.from_bytes(table[at:at + 5], "little"), 65535 * (x + 1) * (y + 1))

    def test_normals_are_a_picture_of_unit_vectors(self):
        width, height = 24, 10
        self.done("map", "normals", f"ramp:{width},{height}", "--scale", "0.5", "-o", "map.ppm")
        head = f"P6\n{width} {height}\n65535\n".encode()
        ppm = self.bytes_of("map.ppm")
        self.assertTrue(ppm.startswith(head))
        words = struct.unpack(f">{3 * width * height}H", ppm[len(head):])
        # The plane is 2 wide, so the ramp of 0.5 rises by 0.25 for each unit along x.
        length = math.hypot(1, 0.25)
        for i in range(0, len(words), 3):
            normal = [(w - 32768) / 16384 for w in words[i:i + 3]]
            for got, right in zip(normal, (-0.25 / length, 0, 1 / length)):
                self.assertAlmostEqual(got, right, delta=2e-3)

    @unittest.skipIf(os.environ.get("RELIEVO_SANITIZED") == "1", "a sanitizer's own memory would be measured")
    def test_the_largest_map_fits_its_own_size_and_a_constant(self):
        self.done("map", "generate", "sine:8192,8192", "-o", "map.png")
        begun = time.monotonic()
        with open(self.folder / "err", "wb") as err:
            run = subprocess.Popen([RELIEVO, "tessellate", "--mesh", "plane:8", "--displacement", "map.png", "--model", "hls",
                                    "--max-generation", "2", "-o", "out.ply"], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=err)
            _, status, used = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual((run.returncode, self.bytes_of("err")), (0, b""))
        texels = 8192 * 8192
        # Samples of 2 bytes; table and normals in words of 8.
        bound = texels * (2 + 8 + 8) + 200 * MIB
        print(f"8192 x 8192: {used.ru_maxrss // 1024} of {bound // MIB} MiB, {time.monotonic() - begun:.1f} s")
        self.assertLess(used.ru_maxrss * 1024, bound)

    @unittest.skipIf(os.environ.get("RELIEVO_SANITIZED") == "1", "a sanitizer needs more address space than that")
    def test_too_little_memory_is_one_clear_line(self):
        for mib in (100, 400, 900):
            with self.subTest(mib=mib):
                run = subprocess.run([RELIEVO, "tessellate", "--mesh", "plane:1", "--displacement", "constant:8192,8192", "--model", "hls",
                                      "--max-generation", "1", "-o", "out.ply"], cwd=self.folder, stdin=subprocess.DEVNULL,
                                     capture_output=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (mib * MIB, mib * MIB)))
                self.assertEqual((run.returncode, run.stdout), (2, b""), run.stderr)
                self.assertRegex(run.stderr.decode(), r"\Arelievo: out of memory[^\n]*\n\Z")
                self.assertEqual(self.all_files(), {})


if __name__ == "__main__":
    unittest.main()
