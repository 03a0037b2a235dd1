"""Runs relievo for every row of scenes.py and writes pictures, figures.json and README.md. Called by scripts/figures.sh.

docs/figures/        what the repository keeps
docs/figures/local/  the figures of ../shared/data, where it exists beside the checkout: head and Crater Lake
out/figures/         maps and meshes in between
"""
import argparse
import json
import os
import pathlib
import struct
import subprocess
import sys

sys.dont_write_bytecode = True
import maps  # noqa: E402
import page  # noqa: E402
import png  # noqa: E402
import scenes  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
BETWEEN = pathlib.Path("out/figures")
LARGEST_PICTURE = 200_000  # bytes


class runner:
    """Runs rows; pictures go to `folder`."""

    def __init__(self, relievo, folder):
        self.relievo, self.folder = relievo, folder
        folder.mkdir(parents=True, exist_ok=True)

    def relievo_run(self, *arguments):
        done = subprocess.run([self.relievo, *map(str, arguments)], capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"figures: relievo {' '.join(map(str, arguments))}\n{done.stderr}")

    def picture(self, name, *arguments):
        path = self.folder / f"{name}.png"
        self.relievo_run("tessellate", *arguments, "--image", path)
        self.limit(path)
        return path.name

    def limit(self, path):
        if path.stat().st_size > LARGEST_PICTURE:
            sys.exit(f"figures: {path} has {path.stat().st_size:,} bytes, more than {LARGEST_PICTURE:,}: a smaller viewport is needed")

    def row(self, spec):
        key, args = spec["key"], spec["args"]
        mesh, report = BETWEEN / f"{key}.ply", BETWEEN / f"{key}.json"
        measured = ["--measure-error"] if spec.get("error", True) else []
        self.relievo_run("tessellate", *args, *measured, "-o", mesh, "--report", report)
        out = result(spec, json.loads(report.read_text()))
        if "water" in spec:
            out.update(triangles_on_water(mesh, spec))
        pictures = [self.picture(key + suffix, *args, *more) for suffix, more in spec.get("views", {}).items()]
        # The finished mesh as a base mesh, nothing added and nothing split: the same triangles from another place.
        again = ["--mesh", mesh, "--displacement", "constant:1", "--scale", "0", "--tests", "none"]
        pictures += [self.picture(key + suffix, *again, *more) for suffix, more in spec.get("closeups", {}).items()]
        if "split" in spec:
            halves = []
            for name, more in (("shaded", []), ("wire", ["--wireframe"])):
                halves.append(BETWEEN / f"{spec['split']}-{name}.png")
                self.relievo_run("tessellate", *args, *more, "--image", halves[-1])
            path = self.folder / f"{spec['split']}.png"
            png.split(path, *halves)
            self.limit(path)
            pictures.append(path.name)
        out["pictures"] = pictures
        if not spec.get("keep") and not spec.get("closeups"):
            mesh.unlink()
        return out


def result(spec, report):
    out = {"key": spec["key"], "figure": spec["figure"], "variant": spec["variant"],
           "command": "relievo tessellate " + " ".join(spec["args"]),
           "base_triangles": report["triangles_in"], "triangles": report["triangles_out"], "edge_tests": report["edge_tests"],
           "settled_skips": report["settled_skips"], "queue_high_water": report["queue_high_water"],
           "max_generation": report["scene"]["max_generation"]}
    error = report.get("error")
    if error:
        metres = "--sample-range" in spec["args"]
        out["unit"] = "m" if metres else "world units"
        unit = "physical" if metres else "world"
        out["rms"], out["max"] = error["mesh"][unit]["rms"], error["mesh"][unit]["max"]
        if error.get("uniform_grid"):
            grid = error["uniform_grid"]
            out["uniform"] = {"triangles": grid["triangles"], "rms": grid["error"][unit]["rms"], "max": grid["error"][unit]["max"]}
    if "cited" in spec:
        out["cited"] = spec["cited"]
    return out


def triangles_on_water(mesh, spec):
    """Base quads all of whose samples lie in the range of heights, and the triangles that stand on them in the end."""
    n, low, high = spec["water"]
    args = spec["args"]
    from_m, to_m = map(float, args[args.index("--sample-range") + 1].split(","))
    width, height, rows = maps.read_pgm(args[args.index("--displacement") + 1])
    step = (to_m - from_m) / 65535

    def is_water(i, j):
        xs = range(i * (width - 1) // n, -(-(i + 1) * (width - 1) // n) + 1)
        ys = range(j * (height - 1) // n, -(-(j + 1) * (height - 1) // n) + 1)
        return all(low - step <= from_m + rows[height - 1 - y][x] * step <= high + step for y in ys for x in xs)

    water = {(i, j) for i in range(n) for j in range(n) if is_water(i, j)}
    header, _, data = mesh.read_bytes().partition(b"end_header\n")
    vertices = int(header.split(b"element vertex ")[1].split()[0])
    names = [line.split()[-1] for line in header.split(b"element face")[0].split(b"\n") if line.startswith(b"property")]
    s, t = names.index(b"s"), names.index(b"t")
    size = 8 * len(names)
    u = [struct.unpack_from("<%dd" % len(names), data, size * i) for i in range(vertices)]
    on_water = 0
    for _, a, b, c, _ in struct.iter_unpack("<BIIII", data[size * vertices:]):
        place = tuple(int(n * sum(u[v][axis] for v in (a, b, c)) / 3) for axis in (s, t))
        on_water += place in water
    faces = (len(data) - size * vertices) // 17
    return {"water_base_triangles": 2 * len(water), "water_triangles": on_water,
            "land_base_triangles": 2 * (n * n - len(water)), "land_triangles": faces - on_water}


def make_maps():
    maps.from_formula(BETWEEN / "bump.pgm", 256, 256, maps.bump)
    maps.from_formula(BETWEEN / "ripple.pgm", 256, 256, maps.ripple)
    maps.from_formula(BETWEEN / "vase.pgm", 512, 456, maps.vase)
    maps.from_formula(BETWEEN / "studs.pgm", 512, 512, maps.studs)
    maps.flooded(BETWEEN / "lake.pgm", scenes.TERRAIN, round((420 - 236) * 65535 / 840))


def local_rows(data):
    if (data / "crater_336x459_m.pgm").exists():
        low, high = maps.stretched(BETWEEN / "crater.pgm", data / "crater_336x459_m.pgm")
        yield from scenes.crater(low, high)
    if (data / "head_cyl_512x512_u16.pgm").exists():
        yield from scenes.head(str(data / "head_cyl_512x512_u16.pgm"))


def make(relievo, folder, specs, only):
    """The rows of `specs`, run or (those not asked for) as figures.json has them."""
    table = folder / "figures.json"
    before = {r["key"]: r for r in json.loads(table.read_text())["rows"]} if only and table.exists() else {}
    run, rows = runner(relievo, folder), []
    for spec in specs:
        if only and spec["figure"] not in only:
            rows += [before[spec["key"]]] if spec["key"] in before else []
            continue
        if sys.stderr.isatty():
            print(f"\r\033[K{spec['figure']}: {spec['variant']}", end="", file=sys.stderr, flush=True)
        rows.append(run.row(spec))
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr)
    table.write_text(json.dumps({"rows": rows}, indent=2, ensure_ascii=False) + "\n")
    return rows


def main():
    parser = argparse.ArgumentParser(prog="figures.sh", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--relievo", required=True, help=argparse.SUPPRESS)
    parser.add_argument("only", nargs="*", metavar="figure", help='such as "Figure 5"; all when none is named')
    options = parser.parse_args()
    relievo = os.path.abspath(options.relievo)
    os.chdir(ROOT)
    BETWEEN.mkdir(parents=True, exist_ok=True)
    make_maps()

    folder = pathlib.Path("docs/figures")
    rows = make(relievo, folder, scenes.committed(), options.only)
    (folder / "README.md").write_text(page.page(pathlib.Path("scripts/figures/page.md").read_text(), rows))
    print(page.plain(rows))

    specs = list(local_rows(pathlib.Path("../shared/data")))
    if specs:
        rows = make(relievo, folder / "local", specs, options.only)
        (folder / "local" / "README.md").write_text(page.gallery(rows))
        print(page.plain(rows))


main()
