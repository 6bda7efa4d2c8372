"""first images: the program alone, with GLuRay and, if asked for, with an earlier build of it

12 nested spheres with bumps from buffer objects, by a shader program that no family describes, or the Wavelet's isosurfaces in a display list. Measured is the
time from before buffers or list are made to after the first image has been shown. Each round starts each way once, in turn forwards and backwards.
Medians of the times, and of the ratios of the rounds. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENES = {"shader": ["--spheres", "12"], "waves": ["--spheres", "12"], "list": []}


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench first")
    parser.add_argument("--sizes", default="0.1,1,4,16", help="millions of triangles (0.1,1,4,16)")
    parser.add_argument("--path", default="shader", choices=tuple(SCENES), help="waves: the vertex shader moves vertices; list: a display list")
    parser.add_argument("--rounds", type=int, default=5, help="rounds, each measuring every way once (5)")
    parser.add_argument("--threads", type=int, default=2, help="of llvmpipe and GLuRay (2)")
    parser.add_argument("--name", default="first_images", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--before", type=pathlib.Path, help="build folder of an earlier version, measured in turn with the others")
    options = parser.parse_args(argv)
    options.sizes = [float(size) for size in options.sizes.split(",")]
    return options


def measured(options, size, environment):
    """Measurements of each way, round by round."""
    client = [options.build / "bench" / "client" / "gluray-bench-client", "--triangles", size, "--path", options.path, *SCENES[options.path], "--frames", "1"]

    def way(build):
        gluray = build / "apps" / "gluray" / "gluray"
        programs.require(client[0], gluray)

        def with_gluray():
            one = programs.measure_with_gluray(gluray, ["--threads", str(options.threads)], client, environment)
            if one.get("report") is None:
                raise programs.Failed(f"{gluray} has not loaded GLuRay into the program: its library is missing, for instance")
            return one
        return with_gluray

    ways = {"plain": lambda: programs.measure(client, environment), "gluray": way(options.build)}
    if options.before:
        ways["before"] = way(options.before)
    return programs.in_turn(ways, options.rounds, alternate=True)


def row_of(size, path, rounds):
    """Medians over the rounds; ratios are those of runs of the same round."""
    seconds = {way: [m["first_image_s"] for m in all_] for way, all_ in rounds.items()}
    row = {"scene": "spheres" if "--spheres" in SCENES[path] else "wavelet", "path": path, "millions": size, "triangles": rounds["plain"][0]["triangles"],
           "rounds": len(seconds["plain"]), **{f"{way}_first_image_s": statistics.median(all_) for way, all_ in seconds.items()}}
    for way, other in (("gluray", "plain"), ("before", "plain"), ("gluray", "before")):
        if {way, other} <= seconds.keys():
            ratios = [one / reference for one, reference in zip(seconds[way], seconds[other])]
            row |= {f"{way}_times_{other}": statistics.median(ratios), f"{way}_times_{other}_low": min(ratios), f"{way}_times_{other}_high": max(ratios)}
    return row


def run(options, argv):
    result = {"suite": "first", "command": ("scripts/bench first " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    with display() as name:
        for size in options.sizes:
            row = row_of(size, options.path, measured(options, size, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}))
            result["rows"].append(row)
            before = f", {row['gluray_times_before']:.3f} times the earlier build" if options.before else ""
            print(f"{size:5g}M  plain {row['plain_first_image_s']:6.3f} s  GLuRay {row['gluray_first_image_s']:6.3f} s  "
                  f"{row['gluray_times_plain']:.3f} times ({row['gluray_times_plain_low']:.3f} to {row['gluray_times_plain_high']:.3f}){before}", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
