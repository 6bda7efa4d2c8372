"""gain by frame lag in a program that computes, or waits, as long as its frames are traced

The Wavelet's isosurfaces in our client, the camera in orbit. Before each frame the client computes on one thread, or waits, as
long as tracing its frames took without lag; it swaps and continues. Measures lag off, on and auto in turn, round by
round; results are medians of whole runs. They go to bench/results/NAME.json.
"""
import pathlib
import shlex
import statistics
import sys

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MODES = ["off", "on", "auto"]


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench lag")
    parser.add_argument("--sizes", default="1,4", help="millions of triangles (1,4)")
    parser.add_argument("--rounds", type=int, default=5, help="rounds, each measuring everything once (5)")
    parser.add_argument("--frames", type=int, default=60, help="frames of one run (60)")
    parser.add_argument("--threads", type=int, default=2, help="threads that trace (2)")
    parser.add_argument("--name", default="lag", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.sizes = [int(size) for size in options.sizes.split(",")]
    return options


def measure(options, environment, size, mode, work):
    """One run: seconds a frame, its median, and GLuRay's report."""
    client = [options.build / "bench" / "client" / "gluray-bench-client", "--triangles", size, "--frames", options.frames, "--orbit",
              "--warm", 2, *work]
    settings = ["--bvh", "full", "--threads", str(options.threads), "--lag", mode]
    measured = programs.measure_with_gluray(options.build / "apps" / "gluray" / "gluray", settings, client, environment)
    return measured["frame_s"], measured["report"]


def rows_of(options, environment, size):
    """A row for computing, one for waiting."""
    alone, report = measure(options, environment, size, "off", ["--wait", 0])
    trace_ms = report["ms"]["trace"] + report["ms"]["build"]
    for kind in ("compute", "wait"):
        seconds = {mode: [] for mode in MODES}
        reports = {}
        for number in range(options.rounds):
            print(f"{size}M triangles, {kind}, round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
            for mode in MODES:
                one, reports[mode] = measure(options, environment, size, mode, [f"--{kind}", round(trace_ms, 2)])
                seconds[mode].append(one)
        ratios = {mode: statistics.median(off / now for off, now in zip(seconds["off"], seconds[mode])) for mode in MODES[1:]}
        yield {"millions": size, "path": kind, "trace_ms": trace_ms, "alone_fps": 1 / alone,
               **{f"{mode}_fps": 1 / statistics.median(all_of) for mode, all_of in seconds.items()},
               **{f"{mode}_over_off": ratio for mode, ratio in ratios.items()},
               **{f"{mode}_lag": reports[mode]["lag"] for mode in MODES[1:]}}


def run(options, argv):
    result = {"suite": "lag", "command": "scripts/bench lag " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "rounds": options.rounds, "rows": []}
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for size in options.sizes:
            result["rows"] += rows_of(options, environment, size)
    for row in result["rows"]:
        print(f"{row['millions']}M {row['path']:8} trace {row['trace_ms']:.1f} ms: off {row['off_fps']:.1f} fps, "
              f"on {row['on_fps']:.1f} ({row['on_over_off']:.2f}), auto {row['auto_fps']:.1f} ({row['auto_over_off']:.2f})")
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
