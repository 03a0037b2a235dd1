"""Options that cannot be used: exit code 2, one line that names the option, nothing left behind."""
import unittest

from command_line import SMALL, command_line

# Option, value, and what the line has to name when that is not the option.
BAD = [
    ("--model", "foo"), ("--model", "RTL"), ("--model", ""), ("--engine", "foo"), ("--engine", "patch"),
    ("--mesh", "foo"), ("--mesh", "plane:0"), ("--mesh", "plane:-1"), ("--mesh", "plane:2,2"), ("--mesh", "plane:x"),
    ("--mesh", "plane:99999999999"), ("--mesh", "octahedron:3"), ("--mesh", ""),
    ("--displacement", "foo"), ("--displacement", "sine:0"), ("--displacement", "sine:8193"), ("--displacement", "sine:8,8193"),
    ("--displacement", "sine:8,8,8"), ("--displacement", "sine:1e3"), ("--displacement", ""),
    ("--scale", "nan"), ("--scale", "inf"), ("--scale", "1e30"), ("--scale", "abc"), ("--scale", "1\n2"), ("--bias", "nan"), ("--bias", "-1e10"),
    ("--sample-range", "1"), ("--sample-range", "1,1"), ("--sample-range", "1,nan"), ("--sample-range", "a,b"),
    ("--sample-range", "0,1,2"), ("--sample-range", "-1e308,1e308"),
    ("--texel-size", "0,1"), ("--texel-size", "-1,1"), ("--texel-size", "1"), ("--texel-size", "inf,1"), ("--texel-size", "1e-30,1"),
    ("--address", "mirror"), ("--address", "clamp,"), ("--address", "clamp,wrap,wrap"),
    ("--eye", "0,0"), ("--eye", "0,0,inf"), ("--eye", "1e9,0,0"), ("--eye", "x,y,z"), ("--at", "0,0,nan"),
    ("--up", "0,0,0"), ("--up", "1,2"),
    ("--fov", "0"), ("--fov", "180"), ("--fov", "-40"), ("--fov", "nan"),
    ("--near", "0"), ("--near", "-1"), ("--near", "nan"), ("--far", "0"), ("--far", "inf"),
    ("--viewport", "0x10"), ("--viewport", "10"), ("--viewport", "8192x8192"), ("--viewport", "-1x5"), ("--viewport", "99999999999x1"),
    ("--tests", "foo"), ("--tests", "nt,,vt"), ("--tests", ""), ("--tests", "NT"),
    ("--normal-threshold", "-0.1"), ("--normal-threshold", "1e6"), ("--normal-threshold", "nan"),
    ("--height-threshold", "-1"), ("--height-threshold", "1e30"), ("--height-threshold", "nan"), ("--height-mode", "mean"),
    ("--profile-threshold", "-1"), ("--profile-threshold", "1e9"), ("--profile-threshold", "inf"),
    ("--highlight-threshold", "5"), ("--highlight-threshold", "nan"),
    ("--half-vector", "0,0,0"), ("--half-vector", "1,1"), ("--half-vector", "nan,0,1"),
    ("--view-threshold", "-1"), ("--view-threshold", "1e9"), ("--view-threshold", "nan"),
    ("--max-generation", "16"), ("--max-generation", "-1"), ("--max-generation", "2.5"), ("--max-generation", "99999999999"),
    ("--queue", "random"),
    ("--stall", "100"), ("--stall", "-1"), ("--idle", "100"), ("--idle", "x"), ("--seed", "x"), ("--watchdog", "x"),
    ("--trace", "out.fst"), ("--trace", "out.vcd"), ("--trace-from", "5"), ("--trace-cycles", "5"), ("--trace-cycles", "x"),
    ("--latency", "0"), ("--latency", "5-2"), ("--latency", "1-20000"), ("--latency", "x"), ("--latency", "3-"),
]


class bad_options(command_line):
    def test_unusable_values_name_their_option(self):
        for option, value in BAD:
            with self.subTest(option=option, value=value):
                scene = [word for pair in zip(SMALL[::2], SMALL[1::2]) if pair[0] != option for word in pair]
                named = value if value and option in ("--mesh", "--displacement") else "" if option in ("--mesh", "--displacement") else option
                given = [option + "=" + value] if value else [option, ""]
                self.refused("tessellate", *scene, *given, "-o", "out.ply", "--report", "out.json", names=named)

    def test_the_other_commands_refuse_the_same_way(self):
        self.done("tessellate", *SMALL, "-o", "mesh.ply")
        for command in (["compare"], ["check", "mesh.ply"], ["error", "mesh.ply"], ["bench"]):
            for option, value in (("--max-generation", "16"), ("--tests", "foo"), ("--fov", "180"), ("--scale", "nan")):
                with self.subTest(command=command, option=option):
                    self.refused(*command, *SMALL, option, value, "--report", "out.json", names=option)

    def test_a_camera_that_sees_nothing_is_refused(self):
        self.refused("tessellate", *SMALL, "--eye", "1,2,3", "--at", "1,2,3", "-o", "out.ply", names=["--eye", "--at"])
        self.refused("tessellate", *SMALL, "--eye", "0,0,5", "--at", "0,0,0", "--up", "0,0,1", "-o", "out.ply", names="--up")
        self.refused("tessellate", *SMALL, "--near", "2", "--far", "1", "-o", "out.ply", names=["--near", "--far"])

    def test_models_that_cannot_be_compared_are_refused(self):
        for models in ("golden", "", "golden,foo", "golden,ideal", "ideal,hls", "golden,"):
            with self.subTest(models=models):
                self.refused("compare", *SMALL, "--models", models, "--report", "out.json", names="--models" if models != "golden,foo" else "foo")

    def test_check_needs_a_mesh_or_a_model_not_both(self):
        self.refused("check", names="check")
        self.done("tessellate", *SMALL, "-o", "mesh.ply")
        self.refused("check", "mesh.ply", "--model", "golden", names="--model")
        self.refused("check", "--model", "foo", *SMALL, names="--model")
        self.refused("error", names="MESH")
        self.refused("replay", names="FILE")

    def test_what_ideal_does_not_have_cannot_be_written(self):
        self.refused("tessellate", *SMALL, "--model", "ideal", "-o", "out.obj", "--vectors", "out.vec", names="--vectors")
        self.refused("tessellate", *SMALL, "--model", "ideal", "-o", "out.obj", "-o", "out.ply", "--raw", names="--raw")
        self.refused("tessellate", *SMALL, "-o", "out.obj", "--raw", names="--raw")

    def test_a_map_generator_has_to_exist(self):
        for name in ("foo", "sine:8193", "sine:0", "checker:4,4,4", "Sine"):
            with self.subTest(name=name):
                self.refused("map", "generate", name, "-o", "map.png", names=name)

    def test_units_to_record_have_to_exist(self):
        self.refused("replay", "out.vec", "--record", "foo", names="--record")
        self.refused("replay", "out.vec", "--record", "displace", "--count", "0", names="--count")
        self.refused("replay", "out.vec", "--record", "displace", "--count", "-1", names="--count")


if __name__ == "__main__":
    unittest.main()
