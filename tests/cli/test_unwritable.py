"""Outputs that cannot be written are refused before the work; what was there stays as it was."""
import json
import os
import stat
import unittest

from command_line import SMALL, command_line


class unwritable(command_line):
    def test_a_missing_folder_or_a_folder_is_named(self):
        (self.folder / "folder.ply").mkdir()
        (self.folder / "folder.json").mkdir()
        self.put("file", "no folder")
        for option, name in (("-o", "missing/out.ply"), ("-o", "folder.ply"), ("-o", "file/out.ply"), ("--report", "missing/out.json"),
                             ("--report", "folder.json"), ("--image", "missing/out.png"), ("--vectors", "missing/out.vec"),
                             ("--vectors", "folder.ply"), ("-o", ""), ("-o", "n" * 300 + ".ply"), ("-o", "n" * 250 + ".ply")):
            with self.subTest(option=option, name=name):
                self.refused("tessellate", *SMALL, "-o", "first.ply", "--report", "first.json", option, name,
                             names=name if option in ("-o", "--vectors", "--image") else "")

    def test_an_unknown_or_doubled_name_is_named(self):
        for name in ("out.stl", "out", "out.ply.gz", ".ply/out"):
            self.refused("tessellate", *SMALL, "-o", "first.obj", "-o", name, names=name)
        self.refused("tessellate", *SMALL, "-o", "out.obj", "--image", "out.jpg", names="out.jpg")
        self.refused("tessellate", *SMALL, "-o", "out.ply", "--report", "out.ply", names="out.ply")

    def test_the_other_commands_ask_before_they_work_too(self):
        self.done("tessellate", *SMALL, "-o", "mesh.ply")
        for command in (["compare", *SMALL], ["check", "mesh.ply"], ["error", "mesh.ply", *SMALL], ["bench", *SMALL]):
            with self.subTest(command=command[0]):
                self.refused(*command, "--report", "missing/out.json", names="missing/out.json")
        for command in (["map", "sat", "sine:8"], ["map", "normals", "sine:8"], ["map", "generate", "sine:8"]):
            with self.subTest(command=command):
                self.refused(*command, "-o", "missing/out", names="missing/out")
        self.refused("map", "levels", "sine:8", "--kind", "averaged", "-o", "missing/out.exr", names="missing/out.exr")
        self.refused("replay", "missing/out.vec", "--record", "displace", names="missing/out.vec")

    def test_a_refused_run_leaves_earlier_results_alone(self):
        for name in ("out.ply", "out.obj", "out.png", "out.json", "out.vec"):
            self.put(name, "earlier")
        outputs = ["-o", "out.ply", "-o", "out.obj", "--image", "out.png", "--report", "out.json", "--vectors", "out.vec"]
        self.refused("tessellate", *SMALL, *outputs, "--max-generation", "16", names="--max-generation")
        self.refused("tessellate", *SMALL, *outputs, "--mesh", "missing.obj", names="")
        self.refused("tessellate", "--mesh", "missing.obj", *outputs, names="missing.obj")
        self.refused("tessellate", *SMALL, *outputs, "-o", "missing/out.ply", names="missing/out.ply")

    def test_earlier_results_are_replaced_by_a_good_run(self):
        self.put("out.ply", "earlier")
        self.done("tessellate", *SMALL, "-o", "out.ply")
        self.assertTrue(self.bytes_of("out.ply").startswith(b"ply\n"))
        self.assertEqual(set(self.all_files()), {"out.ply"})

    @unittest.skipIf(os.geteuid() == 0, "the superuser may write everywhere")
    def test_a_folder_without_permission_is_refused(self):
        (self.folder / "locked").mkdir(mode=0o555)
        self.refused("tessellate", *SMALL, "-o", "locked/out.ply", names="locked/out.ply")

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_full_device_is_refused_and_stays_a_device(self):
        self.refused("tessellate", *SMALL, "--report", "/dev/full", names="/dev/full")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))

    @unittest.skipUnless(os.path.exists("/dev/stdout"), "there is no /dev/stdout")
    def test_a_pipe_is_written_to(self):
        out, _ = self.done("check", "--model", "hls", *SMALL, "--report", "/dev/stdout")
        self.assertTrue(json.JSONDecoder().raw_decode(out, out.index("{"))[0]["clean"])

    def test_a_link_keeps_pointing_where_it_points(self):
        (self.folder / "folder").mkdir()
        (self.folder / "out.ply").symlink_to("folder/real.ply")
        for _ in range(2):
            self.done("tessellate", *SMALL, "-o", "out.ply")
            self.assertTrue((self.folder / "out.ply").is_symlink())
            self.assertTrue(self.bytes_of("folder/real.ply").startswith(b"ply\n"))


if __name__ == "__main__":
    unittest.main()
