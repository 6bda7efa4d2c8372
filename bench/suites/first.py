"""first images of a program with shaders of its own: plain, and with GLuRay

12 nested spheres with bumps from buffer objects, by a shader program that no family describes. Measured is the time from before the buffers are made to after
the first image has been shown. Each round starts the plain program and the program with GLuRay (cull.draws = auto) once; they take turns in being the first.
Medians of the times, and of the ratios of the rounds. Results go to bench/results/NAME.json.
"""
import argparse
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/bench first", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="0.1,1,4,16", help="millions of triangles (0.1,1,4,16)")
    parser.add_argument("--path", default="shader", choices=("shader", "waves"), help="waves: the vertex shader moves vertices")
    parser.add_argument("--rounds", type=int, default=5, help="rounds, each measuring both once (5)")
    parser.add_argument("--threads", type=int, default=2, help="of llvmpipe and GLuRay (2)")
    parser.add_argument("--name", default="first_images", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.sizes = [float(size) for size in options.sizes.split(",")]
    return options


def measured(options, size, environment):
    """Measurements of both, round by round."""
    client = [options.build / "bench" / "client" / "gluray-bench-client", "--triangles", size, "--path", options.path, "--spheres", "12", "--frames", "1"]
    gluray = options.build / "apps" / "gluray" / "gluray"
    programs.require(client[0], gluray)

    def with_gluray():
        one = programs.measure_with_gluray(gluray, ["--threads", str(options.threads)], client, environment)
        if one.get("report") is None:
            raise programs.Failed(f"{gluray} has not loaded GLuRay into the program: its library is missing, for instance")
        return one

    return programs.in_turn({"plain": lambda: programs.measure(client, environment), "gluray": with_gluray}, options.rounds, alternate=True)


def row_of(size, path, rounds):
    """Medians over the rounds; ratios are those of runs of the same round."""
    seconds = {way: [m["first_image_s"] for m in all_] for way, all_ in rounds.items()}
    ratios = [ours / plain for ours, plain in zip(seconds["gluray"], seconds["plain"])]
    return {"scene": "spheres", "path": path, "millions": size, "triangles": rounds["plain"][0]["triangles"], "rounds": len(ratios),
            **{f"{way}_first_image_s": statistics.median(all_) for way, all_ in seconds.items()},
            "gluray_times_plain": statistics.median(ratios), "gluray_times_plain_low": min(ratios), "gluray_times_plain_high": max(ratios)}


def run(options, argv):
    result = {"suite": "first", "command": ("scripts/bench first " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    with display() as name:
        for size in options.sizes:
            row = row_of(size, options.path, measured(options, size, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}))
            result["rows"].append(row)
            print(f"{size:5g}M  plain {row['plain_first_image_s']:6.3f} s  GLuRay {row['gluray_first_image_s']:6.3f} s  "
                  f"{row['gluray_times_plain']:.3f} times ({row['gluray_times_plain_low']:.3f} to {row['gluray_times_plain_high']:.3f})", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
