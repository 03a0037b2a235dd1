"""A word that differs: compare names unit, field, both words, base triangle and path of splits, and a command that runs just that again and
finds it again. The program is $RELIEVO_WRONG, which has models that are wrong on purpose."""
import json
import os
import re
import shlex
import unittest

import command_line
from command_line import SMALL

command_line.RELIEVO = os.environ["RELIEVO_WRONG"]
SCENE = [*SMALL, "--scale=-0.2", "--max-generation", "4"]
WORDS = r"golden 0x[0-9a-f]{6} \(-?[\d.e-]+\), {model} 0x[0-9a-f]{6} \(-?[\d.e-]+\); 2 of its 69 words differ"


class difference(command_line.command_line):
    def first_difference(self, *arguments):
        """What a comparison that fails says: the line of the difference, the command."""
        out, _ = self.run_to(1, *arguments)
        found = re.search(r"^first difference: (.*)\nreplay: (.*)\n", out, re.MULTILINE)
        self.assertTrue(found, out)
        return found.groups()

    def path_of(self, line):
        return re.search(r"\(base triangle 5, path ([0-3]+)\)", line).group(1)

    def again(self, command):
        words = shlex.split(command)
        self.assertEqual(words[0], command_line.RELIEVO)
        return self.first_difference(*words[1:])

    def test_a_word_is_told_with_its_unit_and_where_it_is(self):
        paths = []
        for model in ("wrong-word", "wrong-order"):
            with self.subTest(model=model):
                line, command = self.first_difference("compare", *SCENE, "--models", "golden," + model, "--report", "out.json", "-o", "out.ply")
                self.assertIn("unit displace, field v[2].displaced_p[1]: ", line)
                self.assertRegex(line, WORDS.replace("{model}", model))
                self.assertTrue(command.endswith(" --base-triangle 5"), command)
                self.assertNotIn("out.", command)
                report = json.loads(self.bytes_of("out.json"))["first_difference"]
                self.assertEqual((report["unit"], report["field"], report["base_triangle"]), ("displace", "v[2].displaced_p[1]", 5))
                self.assertEqual((report["path"], report["replay"]), (self.path_of(line), command))
                self.assertEqual(sorted(report["words"]), sorted(["golden", model]))
                paths.append(self.path_of(line))
                # The same word, and nothing else is run.
                alone, once_more = self.again(command)
                self.assertEqual(alone.split("(", 1)[1], line.split("(", 1)[1])
                self.assertEqual(once_more, command)
                words = shlex.split(command)[1:]
                out, _ = self.run_to(1, *words)
                self.assertRegex(out, r"triangles +1 in")
                self.assertRegex(out, re.escape(model) + r" != golden: [\d,]+ triangles, 2 words differ")
        self.assertEqual(paths[0], paths[1])

    def test_the_path_is_golden_s_although_golden_is_not_compared(self):
        with_golden, _ = self.first_difference("compare", *SCENE, "--models", "golden,wrong-order")
        without, command = self.first_difference("compare", *SCENE, "--models", "hls,wrong-order")
        self.assertEqual(self.path_of(without), self.path_of(with_golden))
        self.assertIn("hls 0x", self.again(command)[0])

    def test_a_triangle_that_one_side_has_not(self):
        line, command = self.first_difference("compare", *SCENE, "--models", "golden,wrong-split")
        self.assertRegex(line, r"\(base triangle 5, path [0-3]+\), unit pass_or_tessellate: wrong-split has no such triangle$")
        self.assertEqual(self.again(command)[0].split("(", 1)[1], line.split("(", 1)[1])

    def test_what_takes_other_triangles_is_not_told_to_be_alone(self):
        line, told = self.first_difference("compare", *SCENE, "--models", "golden,wrong-rarely")
        self.assertIn("base triangle 5, path", line)
        command, why = told.split(" (", 1)
        self.assertIn("base triangle 5 alone does not differ", why)
        self.assertNotIn("--base-triangle", command)
        self.assertEqual(self.again(command)[0], line)

    def test_a_base_triangle_has_to_exist(self):
        for number in ("-1", "8", "99999999999", "x"):
            with self.subTest(number=number):
                for command in ("compare", "tessellate"):
                    self.refused(command, *SCENE, "--base-triangle=" + number, names="--base-triangle")
        self.refused("compare", *SCENE, "--base-triangle", "1", "--measure-error", names=["--measure-error", "--base-triangle"])


if __name__ == "__main__":
    unittest.main()
