"""What is run for each figure: rows of the table, in its order.

A row: key (also its file's name), figure, variant (the table's words), args (relievo tessellate), and optionally
  views     {suffix: further options}: pictures drawn by the run itself; "" is docs/figures/<key>.png
  closeups  the same, drawn from the finished mesh with another camera
  error     False: not measured
  keep      the mesh stays in out/figures/<key>.ply, for later rows
  cited     figures of others, for comparison
  water     (base N, low, high): counts the triangles of base quads that hold samples from low to high alone
"""

TERRAIN = "tests/data/jacksboro_403x344.png"
JACKSBORO = ["--mesh", "plane:8", "--displacement", TERRAIN, "--sample-range", "236,1076"]
WIREFRAME = ["--wireframe"]


def camera(eye, at, fov, viewport):
    return ["--eye", eye, "--at", at, "--fov", str(fov), "--viewport", viewport]


def tests(names, normal=None, height=None, profile=None, view=None, generation=None):
    options = {"--normal-threshold": normal, "--height-threshold": height, "--profile-threshold": profile,
               "--view-threshold": view, "--max-generation": generation}
    return ["--tests", names] + [word for name, value in options.items() if value is not None for word in (name, f"{value:g}")]


def figure_5():
    eye = camera("-1.15,-2.4,1.35", "0.06,-0.09,-0.02", 37, "460x270")
    for key, name in (("bump", "bump"), ("ripple", "ripple")):
        for kind, words, which in (("nt", "normal test alone", tests("nt,ct", normal=0.15)),
                                   ("sht", "summed height test alone", tests("sht,ct", height=40000)),
                                   ("both", "both", tests("nt,sht,ct", normal=0.15, height=40000)),
                                   ("pt", "profile test", tests("pt", profile=1500))):
            yield {"key": f"figure-5-{key}-{kind}", "figure": "Figure 5", "variant": f"{name}, {words}",
                   "args": ["--mesh", "plane:1", "--displacement", f"out/figures/{key}.pgm"] + which + eye, "views": {"": WIREFRAME}}


def sinusoid():
    eye = camera("-1.15,-2.4,1.35", "0.06,-0.09,-0.02", 37, "460x270")
    for kind, words, which in (("both", "both tests", tests("nt,sht,ct", normal=0.1, height=40000)),
                               ("pt", "profile test", tests("pt", profile=1500))):
        yield {"key": f"sinusoid-{kind}", "figure": "Sinusoid", "variant": words,
               "args": ["--mesh", "plane:1", "--displacement", "sine", "--address", "wrap"] + which + eye, "views": {"": WIREFRAME}}


def figure_10():
    eye = camera("0,-2.2,1.95", "0,-0.06,0.02", 34, "640x380")
    for kind, words, which in (("nt", "normal test alone", tests("nt,ct", normal=0.35, generation=5)),
                               ("sht", "summed height test alone", tests("sht,ct", height=200000, generation=5)),
                               ("both", "both", tests("nt,sht,ct", normal=0.35, height=200000, generation=5)),
                               ("pt", "profile test", tests("pt", profile=4300))):
        yield {"key": f"figure-10-{kind}", "figure": "Figure 10", "variant": words,
               "args": ["--mesh", "plane:3", "--displacement", "half-donut"] + which + eye, "views": {"": WIREFRAME}}


def jacksboro():
    eye = camera("-0.5,-2.3,1.5", "0.01,-0.11,0.03", 30, "1000x480")
    for triangles, threshold, greedy in ((6571, 47.1, (15.9, 50)), (23940, 19.9, (7.1, 20)), (57119, 10.5, (3.8, 10))):
        row = {"key": f"jacksboro-pt-{triangles}", "figure": "Jacksboro", "variant": f"profile test, {threshold:g} m",
               "args": JACKSBORO + tests("pt", profile=threshold), "cited": {"greedy_rms": greedy[0], "greedy_max": greedy[1]}}
        if triangles == 23940:
            row["args"] += eye
            row["split"] = "jacksboro"
        yield row
    for triangles, normal, height in ((6417, 1.88, 376), (20697, 1.04, 207)):
        yield {"key": f"jacksboro-paper-{triangles}", "figure": "Jacksboro",
               "variant": f"the paper's four tests, {normal:g} and {height} m·texels",
               "args": JACKSBORO + tests("nt,sht,vt,ct", normal=normal, height=height, view=1)}


def figure_11a():
    args = ["--mesh", "plane:24", "--displacement", "out/figures/lake.pgm", "--sample-range", "236,1076", "--scale", "0.2"]
    eye = camera("2.2,-1.5,1.7", "0.1,0.0,-0.03", 34, "640x400")
    yield {"key": "figure-11-a", "figure": "Figure 11 a", "variant": "Jacksboro, flooded to 420 m", "water": (24, 420, 420),
           "args": args + tests("nt,sht,vt,ct", normal=0.9, height=500, view=4) + eye, "views": {"": WIREFRAME, "-shaded": []}}


def figure_11b():
    eye = camera("2.2,-4.6,2.9", "0.16,0,0.66", 24, "640x400")
    yield {"key": "figure-11-b", "figure": "Figure 11 b", "variant": "half donut on the teapot's 28 patches",
           "args": ["--mesh", "teapot:4", "--displacement", "half-donut", "--scale", "0.07"] +
                   tests("nt,sht,vt,ct", normal=0.3, height=100000, view=3, generation=5) + eye, "views": {"": WIREFRAME, "-shaded": []}}


def figure_11c():
    eye = camera("0,-2.2,1.95", "0,-0.06,0.02", 34, "640x380")
    yield {"key": "figure-11-c-first", "figure": "Figure 11 c", "variant": "first map: half donut over the plane", "keep": True,
           "args": ["--mesh", "plane:3", "--displacement", "half-donut"] +
                   tests("nt,sht,ct", normal=0.25, height=100000, generation=5) + eye, "views": {"": WIREFRAME}}
    yield {"key": "figure-11-c", "figure": "Figure 11 c", "variant": "second map: studs over that mesh",
           "args": ["--mesh", "out/figures/figure-11-c-first.ply", "--displacement", "out/figures/studs.pgm", "--scale", "0.03"] +
                   tests("nt,sht,ct", normal=0.2, height=30000) + eye, "views": {"": []}}


def figure_9(key, name, args, which, direction, at, near, closeup):
    """Three distances of the same vt threshold; the meshes drawn small, as seen, and again from near by."""
    for i, distance in enumerate(near):
        eye = ",".join(f"{a + distance * d:g}" for a, d in zip(at, direction))
        yield {"key": f"{key}-{'abc'[i]}", "figure": "Figure 9", "variant": f"{name}, distance {distance:g}", 
               "args": args + which + camera(eye, ",".join(map(str, at)), 28, "420x420"),
               "views": {"": []}, "closeups": {"-mesh": closeup + WIREFRAME}}


def vase():
    return figure_9("figure-9", "vase", ["--mesh", "cylinder:30,30", "--displacement", "out/figures/vase.pgm", "--address", "wrap,clamp",
                                         "--scale", "1", "--bias", "-0.9"],
                    tests("nt,sht,vt,ct", normal=0.25, height=20000, view=6), (0, -0.952, 0.305), (0, 0, -0.03), (5, 10, 20),
                    camera("0,-2.6,0.9", "0,0,0.05", 26, "420x420"))


def coordinate_test():
    scenes = (("checker", "checker, 8 × 8 squares", ["--mesh", "plane:8", "--displacement", "checker"], 0.3, 400000, 7),
              ("text", "text", ["--mesh", "plane:8", "--displacement", "text"], 0.3, 400000, 7),
              ("jacksboro", "Jacksboro", JACKSBORO, 0.3, 500, 7),
              ("donut", "half donut", ["--mesh", "plane:8", "--displacement", "half-donut"], 0.3, 400000, 7),
              ("sine", "sine", ["--mesh", "plane:8", "--displacement", "sine"], 0.3, 400000, 7),
              ("vase", "vase", ["--mesh", "cylinder:30,30", "--displacement", "out/figures/vase.pgm", "--address", "wrap,clamp",
                                "--scale", "1", "--bias", "-0.9"], 0.3, 100000, 6))
    for key, name, args, normal, height, generation in scenes:
        for kind, words in (("nt,sht", "without ct"), ("nt,sht,ct", "with ct")):
            yield {"key": f"ct-{key}-{'on' if 'ct' in kind else 'off'}", "figure": "Tex coord test",
                   "variant": f"{name}, generation limit {generation}, {words}",
                   "args": args + tests(kind, normal, height, generation=generation)}


def committed():
    for rows in (figure_5(), sinusoid(), figure_10(), jacksboro(), figure_11a(), figure_11b(), figure_11c(), vase(), coordinate_test()):
        yield from rows


def crater(low, high):
    args = ["--mesh", "plane:24", "--displacement", "out/figures/crater.pgm", "--sample-range", f"{low},{high}"]
    eye = camera("1.3,-2.1,1.6", "-0.02,-0.08,-0.02", 32, "640x400")
    yield {"key": "figure-11-a-crater", "figure": "Figure 11 a", "variant": "Crater Lake", "water": (24, 1880, 1895),
           "args": args + tests("nt,sht,vt,ct", normal=0.6, height=500, view=4) + eye, "views": {"": WIREFRAME, "-shaded": []}}


def head(path):
    args = ["--mesh", "cylinder:30,30", "--displacement", path, "--address", "wrap,clamp", "--scale", "1.00528", "--bias", "-0.8711"]
    yield from figure_9("figure-9-head", "head", args, tests("nt,sht,vt,ct", normal=0.25, height=20000, view=6), (-0.9, -0.42, 0.1),
                        (0, 0, -0.08), (5, 10, 20), camera("-2.5,-1.2,0.1", "-0.2,0,-0.15", 24, "420x420"))
    for kind, words in (("nt,sht", "without ct"), ("nt,sht,ct", "with ct")):
        yield {"key": f"ct-head-{'on' if 'ct' in kind else 'off'}", "figure": "Tex coord test",
               "variant": f"head, generation limit 6, {words}", "args": args + tests(kind, 0.1, 20000, generation=6)}
