"""what looks do to pictures, as a reader sees them: brightness, lost details, hues, burnt pixels, order of colours, depth

Twelve scenes by VTK (bench/looks/scenes.py), each in the program's own light and in each look (preset); looks with smooth edges beside a multisampled picture. Over the pixels of surfaces: mean luminance over the
program's own; share of pixels that became nearly black; mean change of hue; share of pixels that became white or saturated; rank correlation of luminance
along the colour map; and spread of light and shade over the program's own. A figure out of its limits (bench/looks/measure.py) is marked.
Needs Debian's VTK (python3-vtk9 or python3-paraview). Pictures stay in FOLDER. Results go to bench/results/NAME.json.
"""
import json
import os
import pathlib
import shlex
import subprocess
import time

from looks import rules
from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LOOKS = ["presentation", "figure", "poster", "streamlines", "molecule", "metal", "outdoor", "honest", "draft", "ospray"]
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench looks")
    parser.add_argument("--looks", default=",".join(LOOKS), help=f"presets ({','.join(LOOKS)})")
    parser.add_argument("--scenes", default="", help="of bench/looks/scenes.py (all)")
    parser.add_argument("--size", default="800x600", help="of the pictures (800x600)")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("/tmp/gluray-looks"), help="for the pictures (/tmp/gluray-looks)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="looks", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.looks, options.scenes = options.looks.split(","), [name for name in options.scenes.split(",") if name]
    return options


def ran(environment, *command):
    """Runs a command. Returns seconds and its output."""
    began = time.monotonic()
    done = subprocess.run([str(word) for word in command], env={**os.environ, **environment}, capture_output=True, text=True, check=False)
    if done.returncode:
        raise programs.Failed(f"exit code {done.returncode}: {' '.join(map(str, command))}\n{done.stderr}")
    return time.monotonic() - began, done.stdout


def drawing(options, name, *more):
    return [PYTHON, "-B", ROOT / "bench" / "looks" / "draw.py", *more, options.folder / name, options.size, *options.scenes]


def measured(options, look, scenes):
    """A row for each scene."""
    own = options.folder / ("smooth" if look in rules.SMOOTH else "own")
    _, lines = ran({}, PYTHON, "-B", ROOT / "bench" / "looks" / "measure.py", "--values", options.folder / "own", own, options.folder / look, *scenes)
    return [json.loads(line) for line in lines.splitlines()]


def marks(look, row):
    return " ".join(name if name in rules.misses(look, row["scene"], row) else f"[{name}]" for name in row["beyond"])


def run(options, argv):
    result = {"suite": "looks", "command": ("scripts/bench looks " + shlex.join(argv)).strip(), **machine.describe(ROOT), "not_kept": rules.NOT_KEPT, "rows": []}
    programs.require(options.build / "apps" / "gluray" / "gluray")
    with display() as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        own_seconds, scenes = ran(environment, *drawing(options, "own", "--values"))
        scenes = scenes.split()
        if set(options.looks) & set(rules.SMOOTH):
            ran(environment, *drawing(options, "smooth", "--values", "--samples", 8))
        launcher = [options.build / "apps" / "gluray" / "gluray", "--threads", options.threads, "--preset"]
        for look in options.looks:
            seconds, _ = ran(environment, *launcher, look, "--", *drawing(options, look))
            print(f"{look}: {seconds:.0f} s (the program's own pictures: {own_seconds:.0f} s)", flush=True)
            for row in measured(options, look, scenes):
                print(f"  {row['scene']:12} brightness {row['brightness']:.2f}  lost {100 * row['lost']:4.1f} %  hue {row['hue']:4.1f}  burnt {100 * row['burnt']:4.1f} %  "
                      f"order {row['order']:.3f}  depth {row['depth']:.2f}  {marks(look, row)}", flush=True)
                result["rows"].append({"look": look, **row, "misses": rules.misses(look, row["scene"], row)})
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
