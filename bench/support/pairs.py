"""Programs measured with their own OpenGL and with GLuRay, in turn: options, rows, table and result file of such suites."""
import pathlib
import shlex
import sys

from support import machine, programs, stub_time
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def parser(suite, description, sizes, what):
    """The options of a suite; `sizes` its usual ones in millions of `what`."""
    options = Parser(description, prog=f"scripts/bench {suite}")
    options.add_argument("--sizes", default=sizes, help=what)
    options.add_argument("--rounds", type=int, default=3, help="rounds, each measuring everything once (3)")
    options.add_argument("--threads", type=int, default=2, help="threads of llvmpipe and GLuRay (2)")
    options.add_argument("--size", type=int, default=1024, help="pixels of the window, both ways")
    options.add_argument("--stub-time", action="store_true", help="measure the time in our library, too (needs perf)")
    options.add_argument("--name", default=suite, help="name of the result file")
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    return options


def parse(options, argv):
    """The given ones, sizes as whole numbers."""
    given = options.parse_args(argv)
    try:
        given.sizes = [int(size) for size in given.sizes.split(",")]
    except ValueError:
        options.error(f"--sizes takes whole numbers of millions, not '{given.sizes}'")
    return given


def measure_size(options, label, plain_command, traced_command, environment):
    """Rounds of both: (median of plain, median with GLuRay)."""
    gluray = options.build / "apps" / "gluray" / "gluray"
    plain, traced = [], []
    for number in range(options.rounds):
        print(f"{label}, round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
        plain.append(programs.measure(plain_command, environment))
        traced.append(programs.measure_with_gluray(gluray, ["--threads", str(options.threads)], traced_command, environment))
    both = programs.combined(plain), programs.combined(traced)
    both[1]["report"] = traced[-1]["report"]
    return both


def add_stub_time(options, label, command_of, frames, environment, traced):
    """Time of the program's thread in our library, if --stub-time is given."""
    if not options.stub_time:
        return
    print(f"{label}, time in our library", file=sys.stderr, flush=True)
    gluray = options.build / "apps" / "gluray" / "gluray"
    ms, functions = stub_time.per_frame(gluray, ["--threads", str(options.threads)], command_of, frames, environment)
    traced["stubs"] = {"stub_ms_per_frame": ms, "stub_functions_ms": functions}


def row_of(size, plain, traced):
    report = traced["report"] or {}
    draws = report.get("draws", {})
    flushes = max(report.get("flushes", 0), 1)
    return {"millions": size, "triangles": plain["triangles"], "gl_fps": 1 / plain["frame_s"],
            "gluray_fps": 1 / traced["frame_s"], "gluray_over_gl": plain["frame_s"] / traced["frame_s"],
            **({"gluray_early_fps": 1 / traced["early_frame_s"]} if "early_frame_s" in traced else {}),
            "gl_first_image_s": plain["first_image_s"], "gluray_first_image_s": traced["first_image_s"],
            "gl_bytes_per_triangle": plain["rss_bytes"] / plain["triangles"],
            "gluray_bytes_per_triangle": traced["rss_bytes"] / plain["triangles"],
            "megabytes_on_top": (traced["rss_bytes"] - plain["rss_bytes"]) / 1e6, **traced.get("stubs", {}),
            "ms_per_picture": {part: value * report.get("frames", 0) / flushes for part, value in report.get("ms", {}).items()},
            "draws_traced": draws.get("traced", 0), "rasterised": draws.get("rasterised", {})}


COLUMNS = [("Mtri", "millions", "{:d}"), ("GL fps", "gl_fps", "{:.2f}"), ("GLuRay fps", "gluray_fps", "{:.2f}"),
           ("ratio", "gluray_over_gl", "{:.1f}"), ("early", "gluray_early_fps", "{:.2f}"), ("first GL s", "gl_first_image_s", "{:.2f}"),
           ("first GLuRay s", "gluray_first_image_s", "{:.2f}"), ("GL B/tri", "gl_bytes_per_triangle", "{:.0f}"),
           ("GLuRay B/tri", "gluray_bytes_per_triangle", "{:.0f}"), ("on top MB", "megabytes_on_top", "{:.0f}"),
           ("stubs ms", "stub_ms_per_frame", "{:.2f}")]


def print_table(rows):
    cells = [[title for title, _, _ in COLUMNS]]
    cells += [[form.format(row[key]) if key in row else "-" for _, key, form in COLUMNS] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(COLUMNS))]
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)), flush=True)


def _run(suite, options, argv, measure):
    result = {"suite": suite, "command": f"scripts/bench {suite} " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "rounds": options.rounds, "rows": []}
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for size in options.sizes:
            result["rows"].append(row_of(size, *measure(size, environment)))
    print_table(result["rows"])
    machine.write(ROOT, options.name, result)


def run(suite, options, argv, measure):
    """Measures all sizes by measure(size, environment), prints and writes the results. Returns the exit status."""
    return status_of(lambda: _run(suite, options, argv, measure), stub_time.Missing)
