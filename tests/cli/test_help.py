"""Every subcommand explains itself; every option that the architecture promises exists; what does not exist is refused."""
import unittest

from command_line import command_line

SCENE = ["--mesh", "--displacement", "--scale", "--bias", "--sample-range", "--texel-size", "--address", "--eye", "--at", "--up", "--fov",
         "--near", "--far", "--viewport"]
EDGE = ["--tests", "--normal-threshold", "--height-threshold", "--height-mode", "--profile-threshold", "--highlight-threshold",
        "--half-vector", "--view-threshold", "--max-generation", "--queue", "--cull"]
SWEEP = ["--engine", "--grid"]
CIRCUIT = ["--stall", "--idle", "--latency", "--seed", "--trace", "--trace-from", "--trace-cycles"]
OUTPUT = ["-o", "--raw", "--report", "--image", "--wireframe"]
OPTIONS = {
    ("tessellate",): ["--model", "--vectors", "--base-triangle"] + CIRCUIT + SCENE + EDGE + SWEEP + OUTPUT,
    ("compare",): ["--models", "--base-triangle"] + CIRCUIT + SCENE + EDGE + SWEEP + OUTPUT,
    ("check",): ["MESH", "--base", "--model", "--report"] + SCENE + EDGE + SWEEP,
    ("error",): ["MESH", "--report"] + SCENE + EDGE + SWEEP,
    ("replay",): ["FILE", "--model", "--only"] + CIRCUIT,
    ("bench",): ["--report"] + SCENE + EDGE + SWEEP,
    ("map",): ["info", "sat", "normals", "levels", "generate"],
    ("map", "info"): ["FILE", "--sample-range"],
    ("map", "sat"): ["FILE", "-o", "--address"],
    ("map", "normals"): ["FILE", "-o", "--scale", "--texel-size", "--address"],
    ("map", "levels"): ["FILE", "-o", "--kind", "--address", "--sample-range", "--iterations"],
    ("map", "generate"): ["NAME", "-o"],
}


class help_texts(command_line):
    def test_every_command_has_help_with_an_example(self):
        for command in [(), *OPTIONS]:
            with self.subTest(command=command):
                out, err = self.done(*command, "--help")
                self.assertRegex(out, r"Examples?: relievo " + (command[0] if command else ""))
                self.assertEqual(err, "")

    def test_every_option_of_the_architecture_is_there(self):
        for command, options in OPTIONS.items():
            words = self.done(*command, "--help")[0].replace(",", " ").replace("|", " ").split()
            for option in options:
                with self.subTest(command=command, option=option):
                    self.assertIn(option, words)

    def test_the_main_help_lists_every_command(self):
        out, _ = self.done("--help")
        for command in OPTIONS:
            self.assertIn(command[0], out)

    def test_unknown_options_and_commands_are_refused(self):
        for command in OPTIONS:
            with self.subTest(command=command):
                self.refused(*command, "--no-such-option", names="")
        self.refused("no-such-command", names="")
        self.refused(names="subcommand")
        self.refused("map", names="subcommand")
        self.assertIn("--no-such-option", self.refused("tessellate", "--no-such-option", names=""))

    def test_an_option_without_its_value_is_refused(self):
        for option in ["--mesh", "--scale", "--eye", "--max-generation", "-o"]:
            with self.subTest(option=option):
                self.refused("tessellate", option, names=option)


if __name__ == "__main__":
    unittest.main()
