"""frames a second of spheres that VTK's shaders cut out of cards: with its own OpenGL and with GLuRay

Clouds of spheres by vtkOpenGLSphereMapper in a window of 1024x1024, the camera in orbit. With and without take turns, round by
round; figures are medians; "Mtri" counts spheres. Results go to bench/results/NAME.json. Needs python3-paraview.
"""
import argparse
import json
import os
import pathlib
import shlex
import sys

from suites.paraview import print_table, row_of
from support import machine, programs
from support.display import NoDisplay, display

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = ["/usr/bin/python3", ROOT / "bench" / "support" / "sphere_orbit.py"]


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/bench spheres", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="1,4", help="millions of spheres (1,4)")
    parser.add_argument("--rounds", type=int, default=3, help="rounds, each measuring everything once (3)")
    parser.add_argument("--threads", type=int, default=2, help="threads of llvmpipe and GLuRay (2)")
    parser.add_argument("--size", type=int, default=1024, help="pixels of the window, both ways")
    parser.add_argument("--name", default="spheres", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even where there is a display")
    options = parser.parse_args(argv)
    try:
        options.sizes = [int(size) for size in options.sizes.split(",")]
    except ValueError:
        parser.error(f"--sizes takes whole numbers of millions, not '{options.sizes}'")
    return options


def measure_size(options, size, environment):
    """Rounds of both at one size: (median of plain, median with GLuRay)."""
    def command(frames):
        return [*PROGRAM, size * 1_000_000, frames, options.size]
    gluray = options.build / "apps" / "gluray" / "gluray"
    plain, traced = [], []
    for number in range(options.rounds):
        print(f"{size}M spheres, round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
        plain.append(programs.measure(command(8), environment))
        traced.append(programs.measure_with_gluray(gluray, ["--threads", str(options.threads)], command(40), environment))
    both = programs.combined(plain), programs.combined(traced)
    both[1]["report"] = traced[-1]["report"]
    return both


def run(options, argv):
    result = {"suite": "spheres", "command": "scripts/bench spheres " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "rounds": options.rounds, "rows": []}
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for size in options.sizes:
            result["rows"].append(row_of(size, *measure_size(options, size, environment)))
    result["machine"]["load_after"] = os.getloadavg()[0]
    print_table(result["rows"])
    out = ROOT / "bench" / "results" / f"{options.name}.json"
    out.write_text(json.dumps(result, indent=1) + "\n")
    print(f"written: {out.relative_to(ROOT)}")


def main(argv):
    options = arguments(argv)
    try:
        run(options, argv)
    except (NoDisplay, programs.Failed) as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0
