"""frames of a program of many objects, each one a draw by a shader program: plain, and with small draws left out

4,000 balls of 1,012 triangles (or of 84) in a ball, each drawn with a model matrix and a colour of its own as uniforms, by a program with three lights; the
camera turns by 1.5 degrees a frame. Draws come in a random order, from front to back or from back to front; "inside": the camera is among the
objects, of which most are out of its view; "instances": balls of one shape, all in one draw. The plain program and the program with cull.draws = off, always and auto take turns, round by round.
Medians; a way is compared with the plain program's frames of the same numbers. What trials of auto cost is in the frames before that: from the first second until auto is measured, all frames are compared with the plain program's
frames of the same numbers, as a whole, and the worst few seconds of them. Results go to bench/results/NAME.json.
"""
import functools
import itertools
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENES = {"random": ["--order", "random"], "front": ["--order", "front"], "back": ["--order", "back"],
          "inside": ["--order", "random", "--distance", "100"],
          "instances": ["--instanced"], "open": ["--order", "random", "--radius", "4"]}
WAYS = ["off", "always", "auto"]
WORST_S = 5  # of the plain program: the windows of which the worst is told


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench objects")
    parser.add_argument("--scenes", default=",".join(SCENES), help=f"of {', '.join(SCENES)} (all)")
    parser.add_argument("--rows", default="23,7", help="rows of the balls, of 2 * rows * (rows - 1) triangles (23,7)")
    parser.add_argument("--frames", type=int, default=20, help="frames to measure in each run (20)")
    parser.add_argument("--settle", type=float, default=20, help="seconds of drawing before they are measured, plain and with auto, which decides meanwhile (20)")
    parser.add_argument("--rounds", type=int, default=3, help="rounds, each measuring everything once (3)")
    parser.add_argument("--threads", type=int, default=2, help="of llvmpipe and GLuRay (2)")
    parser.add_argument("--name", default="objects", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.rows = [int(rows) for rows in options.rows.split(",")]
    options.scenes = options.scenes.split(",")
    if unknown := set(options.scenes) - set(SCENES):
        parser.error(f"no scene {', '.join(sorted(unknown))}")
    return options


def measured(options, scene, rows, environment):
    """Measurements of each way."""
    client = [options.build / "bench" / "client" / "gluray-bench-objects", "--rows", rows, "--frames", options.frames, *SCENES[scene]]
    gluray = options.build / "apps" / "gluray" / "gluray"
    programs.require(client[0], gluray)

    def once(way):
        settle = ["--settle", options.settle if way in ("plain", "auto") else 1, "--all"]
        if way == "plain":
            return programs.measure([*client, *settle], environment)
        return programs.measure_with_gluray(gluray, ["--threads", str(options.threads), "--set", f"cull.draws={way}"], [*client, *settle], environment)

    rounds = programs.in_turn({way: functools.partial(once, way) for way in ["plain", *WAYS]}, options.rounds)
    ways = {way: programs.combined(all_) | {"report": all_[-1].get("report")} for way, all_ in rounds.items()}
    for way in WAYS:
        same = [last_of_both(plain["all_s"], other["all_s"], options.frames) for plain, other in zip(rounds["plain"], rounds[way])]
        ways[way]["same_frames_s"] = [statistics.median(values) for values in zip(*same)]
    early = [early_of(plain["all_s"], auto["all_s"], options.settle) for plain, auto in zip(rounds["plain"], rounds["auto"])]
    ways["auto"]["early"] = [statistics.median(values) for values in zip(*early)]
    return ways


def last_of_both(plain, other, frames):
    """Median seconds of the last frames of both whose numbers are the same: what a frame takes depends on where the camera is."""
    both = min(len(plain), len(other))
    return statistics.median(plain[max(both - frames, 0):both]), statistics.median(other[max(both - frames, 0):both])


def early_of(plain, auto, settle):
    """How fast the frames of `auto` from the first second until `settle` seconds are, over the plain ones of the same numbers: all of them, and those
    of the slowest window that takes the plain program WORST_S seconds (or all, where they take less). `plain` and `auto`: seconds of all frames."""
    began = list(itertools.accumulate(auto, initial=0))
    pairs = [(plain[i], auto[i]) for i in range(min(len(plain), len(auto))) if 1 <= began[i] < settle]
    if not pairs:
        return 1.0, 1.0
    sums = [list(itertools.accumulate(values, initial=0)) for values in zip(*pairs)]
    speed = lambda first, last: (sums[0][last] - sums[0][first]) / (sums[1][last] - sums[1][first])
    overall, worst = speed(0, len(pairs)), []
    last = 0
    for first in range(len(pairs)):
        while last < len(pairs) and sums[0][last] - sums[0][first] < WORST_S:
            last += 1
        if sums[0][last] - sums[0][first] < WORST_S:
            break
        worst.append(speed(first, last))
    return overall, min(worst, default=overall)


def row_of(scene, rows, ways):
    row = {"scene": scene, "rows": rows, "triangles": ways["plain"]["triangles"]}
    for way, m in ways.items():
        row[f"{way}_ms"] = 1000 * m["frame_s"]
    for way in WAYS:
        plain, other = ways[way]["same_frames_s"]
        report = ways[way]["report"] or {}
        culled = report.get("culled", {}).get("draws", 0)
        row |= {f"{way}_times_plain": plain / other, f"{way}_left_out_a_frame": culled / max(report.get("frames", 1), 1)}
    row["auto_early_times_plain"], row["auto_worst_times_plain"] = ways["auto"]["early"]
    return row


def run(options, argv):
    result = {"suite": "objects", "command": ("scripts/bench objects " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    with display() as name:
        for rows, scene in itertools.product(options.rows, options.scenes):
            row = row_of(scene, rows, measured(options, scene, rows, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}))
            result["rows"].append(row)
            print(f"{scene:7} {row['triangles']:9,}  plain {row['plain_ms']:7.1f} ms  off {row['off_ms']:7.1f} ms  always {row['always_ms']:7.1f} ms "
                  f"({row['always_left_out_a_frame']:.0f} of 4,000 left out)  auto {row['auto_ms']:7.1f} ms ({row['auto_times_plain']:.2f}x; "
                  f"before {row['auto_early_times_plain']:.2f}x, at worst {row['auto_worst_times_plain']:.2f}x)", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
