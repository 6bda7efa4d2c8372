"""memory, time and stack that GLuRay takes from its host program, beside the program alone

shapes: a small lit scene, ten times into each of three framebuffers of 8192x1024, 16384x16 and 16x16384 pixels; the process's
peak of resident memory, and its time from start to end. stacks: the smallest stack of the drawing thread, in steps of 8 kB,
with which the program ends well and draws what it draws with 4 MB. Medians of the rounds. EGL
without a display. Results go to bench/results/NAME.json.
"""
import os
import pathlib
import re
import shlex
import statistics
import subprocess
import time

from support import machine
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EFFECTS = ["--set", "ao=on", "--set", "shadows=on", "--set", "integrator=path", "--set", "path.samples=1"]
KINDS = {"alone": None, "gluray": [], "gluray, effects": EFFECTS}
SHAPED = ["alone", "gluray"]  # light on 130 million pixels would take minutes
STACKS = range(24, 264, 8)  # kB


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench host")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="host", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    return parser.parse_args(argv)


def draw(options, kind, scene, stack):
    """The finished process; its image is on standard output, its peak on standard error."""
    command = [options.build / "tests" / "doors" / "door_limits", "egl", scene, stack]
    if KINDS[kind] is not None:
        command = [options.build / "apps" / "gluray" / "gluray", "--engine", "always", "--threads", options.threads, *KINDS[kind], "--", *command]
    environment = os.environ | {"EGL_PLATFORM": "surfaceless", "LP_NUM_THREADS": str(options.threads)}
    environment.pop("DISPLAY", None)
    return subprocess.run([str(word) for word in command], env=environment, capture_output=True, timeout=120)


def shape_row(options, kind):
    seconds, peaks = [], []
    for _ in range(options.rounds):
        begin = time.monotonic()
        done = draw(options, kind, "sizes", 0)
        seconds.append(time.monotonic() - begin)
        if done.returncode != 0:
            raise RuntimeError(f"{kind}: the program ended with {done.returncode}: {done.stderr.decode()[-200:]}")
        peaks.append(1024 * int(re.search(rb"VmHWM:\s*(\d+) kB", done.stderr)[1]))
    return {"peak_bytes": statistics.median(peaks), "seconds": statistics.median(seconds)}


def smallest_stack(options, kind):
    """In kB; the sizes above it are not tried."""
    ample = draw(options, kind, "small", 4096)
    for stack in STACKS:
        done = draw(options, kind, "small", stack)
        if done.returncode == 0 and len(done.stdout) == len(ample.stdout):
            return stack
    return None


def run(options, argv):
    result = {"suite": "host", "command": "scripts/bench host " + shlex.join(argv), **machine.describe(ROOT), "threads": options.threads,
              "rounds": options.rounds, "rows": []}
    for kind in KINDS:
        row = {"kind": kind, "stack_kb": smallest_stack(options, kind)}
        if kind in SHAPED:
            row |= shape_row(options, kind)
        result["rows"].append(row)
        print(", ".join(f"{name} {value:.4g}" if name != "kind" else value for name, value in row.items()), flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
