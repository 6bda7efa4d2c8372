"""frames a second of a program with shaders of its own: plain, and with culled draws

Surfaces from buffer objects, by a shader program with three lights and a pattern, an orbit of 1.5 degrees a frame; the plain program, the program with
cull.draws = always, and with auto take turns, round by round. Medians. Scenes: 12 nested spheres with bumps, 2 of them (most triangles show), and the
Wavelet's isosurfaces. With --light: ambient occlusion over them (light.rasterised), and over the same surfaces by fixed function, which are traced, each
with and without it; CPU time of all threads says what it costs where other work runs beside. Results go to bench/results/NAME.json.
"""
import itertools
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FRAMES = {0.1: 160, 1: 60, 4: 30, 16: 16}
SCENES = {"spheres": ["--spheres", "12"], "shells": ["--spheres", "2"], "wavelet": []}
STEP = 1.5  # degrees


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench shaders")
    parser.add_argument("--sizes", default="0.1,1,4", help=f"millions of triangles, of {', '.join(map(str, FRAMES))} (0.1,1,4)")
    parser.add_argument("--scenes", default="spheres", help=f"of {', '.join(SCENES)} (spheres)")
    parser.add_argument("--rounds", type=int, default=3, help="rounds, each measuring everything once (3)")
    parser.add_argument("--threads", type=int, default=2, help="of llvmpipe and GLuRay (2)")
    parser.add_argument("--path", default="shader", choices=("shader", "waves"), help="waves: the vertex shader moves vertices, so that positions come by feedback")
    parser.add_argument("--light", action="store_true", help="what ambient occlusion costs over culled and over traced surfaces")
    parser.add_argument("--name", default="shaders", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.sizes = [float(size) for size in options.sizes.split(",")]
    if unknown := set(options.sizes) - set(FRAMES):
        parser.error(f"no size {', '.join(map(str, sorted(unknown)))}")
    options.scenes = options.scenes.split(",")
    if unknown := set(options.scenes) - set(SCENES):
        parser.error(f"no scene {', '.join(sorted(unknown))}")
    return options


def client_of(options, scene, size, path):
    return [options.build / "bench" / "client" / "gluray-bench-client", "--triangles", size, "--path", path, *SCENES[scene],
            "--frames", FRAMES[size], "--orbit", "--step", STEP, "--warm", 1 + size]


def lit(options, scene, size, environment):
    """Measurements by shader and by fixed function, each with and without ambient occlusion."""
    gluray = options.build / "apps" / "gluray" / "gluray"
    light = ["--set", "ao=on", "--set", "light.rasterised=on"]
    full = ["--bvh", "full"]  # no thread builds a better structure meanwhile

    def way(path, *extra):
        return lambda: programs.measure_with_gluray(gluray, ["--threads", str(options.threads), *full, *extra], client_of(options, scene, size, path), environment)

    ways = {"shader": way("shader"), "shader_ao": way("shader", *light), "traced": way("vbo"), "traced_ao": way("vbo", *light)}
    return {name: programs.combined(all_) | {"cpu_s": statistics.median(one["cpu_s"] for one in all_)}
            for name, all_ in programs.in_turn(ways, options.rounds).items()}


def row_of_light(scene, size, ways):
    row = {"scene": scene, "millions": size, "triangles": ways["shader"]["triangles"]} | {f"{way}_ms": 1000 * m["frame_s"] for way, m in ways.items()}
    row |= {f"{way}_cpu_ms": 1000 * m["cpu_s"] for way, m in ways.items()}
    for kind, name in (("ms", "cost_times_traced"), ("cpu_ms", "cpu_cost_times_traced")):
        cost = {way: row[f"{way}_ao_{kind}"] - row[f"{way}_{kind}"] for way in ("shader", "traced")}
        row |= {f"{way}_light_{kind}": ms for way, ms in cost.items()} | {name: cost["shader"] / cost["traced"]}
    return row | {"lit_draws": (ways["shader_ao"]["report"] or {}).get("lit", {}).get("draws")}


def measured(options, scene, size, environment):
    """Measurements of each way: plain, always, auto."""
    client = client_of(options, scene, size, options.path)
    gluray = options.build / "apps" / "gluray" / "gluray"
    programs.require(client[0], gluray)

    def culled(how):
        return lambda: programs.measure_with_gluray(gluray, ["--threads", str(options.threads), "--set", f"cull.draws={how}"], client, environment)

    ways = {"plain": lambda: programs.measure(client, environment), "always": culled("always"), "auto": culled("auto")}
    return {way: programs.combined(all_) for way, all_ in programs.in_turn(ways, options.rounds).items()}


def row_of(scene, size, ways):
    row = {"scene": scene, "millions": size, "triangles": ways["plain"]["triangles"]}
    for way, m in ways.items():
        row |= {f"{way}_ms": 1000 * m["frame_s"], f"{way}_first_image_s": m["first_image_s"], f"{way}_rss_bytes": m["rss_bytes"]}
    for way in ("always", "auto"):
        report = ways[way]["report"] or {}
        row |= {f"{way}_times_plain": row["plain_ms"] / row[f"{way}_ms"], f"{way}_culled_draws": report.get("culled", {}).get("draws"),
                f"{way}_left_out": report.get("culled", {}).get("trianglesLeftOut")}
    return row


def run(options, argv):
    result = {"suite": "shaders", "command": ("scripts/bench shaders " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    with display() as name:
        for scene, size in itertools.product(options.scenes, options.sizes):
            if options.light:
                row = row_of_light(scene, size, lit(options, scene, size, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}))
                result["rows"].append(row)
                print(f"{scene:8} {size:5g}M  light over shaders {row['shader_light_ms']:8.1f} ms, over traced surfaces {row['traced_light_ms']:8.1f} ms "
                      f"({row['cost_times_traced']:.2f}x); CPU time {row['shader_light_cpu_ms']:.1f} and {row['traced_light_cpu_ms']:.1f} ms "
                      f"({row['cpu_cost_times_traced']:.2f}x)", flush=True)
                continue
            row = row_of(scene, size, measured(options, scene, size, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}))
            result["rows"].append(row)
            print(f"{scene:8} {size:5g}M  plain {row['plain_ms']:8.1f} ms  always {row['always_ms']:8.1f} ms ({row['always_times_plain']:.2f}x)  "
                  f"auto {row['auto_ms']:8.1f} ms ({row['auto_times_plain']:.2f}x)", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
