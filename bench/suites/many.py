"""frames a second of many small things: with the real OpenGL and with GLuRay, in turn

meshes: 10,000 display lists of 1,012 different triangles each, called one by one; instances: one list of 84 triangles called in
100,000 places; lists: 100 lists of 1,012 triangles, made for one frame and deleted after it, all different from the last frame's.
Measures both in turn, round by round; results are medians. They go to bench/results/NAME.json.
"""
import pathlib
import shlex

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KINDS = ["meshes", "instances", "lists"]
GL_FRAMES, RAY_FRAMES = 5, 40
INTERACTIVE = 20  # frames a second


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench many")
    parser.add_argument("--kinds", default=",".join(KINDS), help=f"some of {','.join(KINDS)}")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="many", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.kinds = options.kinds.split(",")
    if not set(options.kinds) <= set(KINDS):
        parser.error(f"kinds are {', '.join(KINDS)}")
    return options


def row_of(kind, plain, traced):
    report = traced["report"] or {}
    frames = max(report.get("frames", 0), 1)
    return {"kind": kind, "triangles": plain["triangles"], "gl_fps": 1 / plain["frame_s"], "gluray_fps": 1 / traced["frame_s"],
            "gluray_over_gl": plain["frame_s"] / traced["frame_s"], "interactive": 1 / traced["frame_s"] >= INTERACTIVE,
            "gl_first_image_s": plain["first_image_s"], "gluray_first_image_s": traced["first_image_s"],
            "gl_peak_bytes": plain["peak_bytes"], "gluray_peak_bytes": traced["peak_bytes"],
            "draws_a_frame": report.get("draws", {}).get("traced", 0) / frames, "ms_a_frame": report.get("ms", {}),
            "rasterised": report.get("draws", {}).get("rasterised", {})}


COLUMNS = [("kind", "kind", "{}"), ("triangles", "triangles", "{:,}"), ("GL fps", "gl_fps", "{:.2f}"),
           ("GLuRay fps", "gluray_fps", "{:.2f}"), ("/GL", "gluray_over_gl", "{:.1f}"), ("first GL s", "gl_first_image_s", "{:.2f}"),
           ("first GLuRay s", "gluray_first_image_s", "{:.2f}")]


def print_table(rows):
    cells = [[title for title, *_ in COLUMNS]] + [[form.format(row[key]) for _, key, form in COLUMNS] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(COLUMNS))]
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)), flush=True)


def run(options, argv):
    result = {"suite": "many", "command": "scripts/bench many " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "rounds": options.rounds, "rows": []}
    program = options.build / "bench" / "client" / "gluray-bench-many"
    gluray = options.build / "apps" / "gluray" / "gluray"
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for kind in options.kinds:
            plain, traced = [], []
            for _ in range(options.rounds):
                plain.append(programs.measure([program, "--kind", kind, "--frames", GL_FRAMES], environment))
                traced.append(programs.measure_with_gluray(gluray, ["--threads", options.threads],
                                                           [program, "--kind", kind, "--frames", RAY_FRAMES, "--settle", 3], environment))
            both = programs.combined(plain), programs.combined(traced)
            both[1]["report"] = traced[-1]["report"]
            result["rows"].append(row_of(kind, *both))
            print_table(result["rows"][-1:])
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
