"""frames a second of ParaView (pvbatch): with its own OpenGL and with GLuRay

Contours of the Wavelet source, coloured by value, in a window of 1024x1024 with ParaView's own settings (FXAA on, orientation
axes), the camera in orbit. With and without take turns, round by round; figures are medians. Results go to
bench/results/NAME.json. Needs python3-paraview (scripts/setup installs it).
"""
import argparse
import json
import os
import pathlib
import shlex
import shutil
import sys

from support import machine, programs
from support.display import NoDisplay, display

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "bench" / "support" / "paraview_orbit.py"
ISOVALUES = {1: 3, 4: 14, 16: 55, 32: 110}  # of the Wavelet on 201^3 points, by millions of triangles
GL_FRAMES = {1: 20, 4: 8, 16: 4, 32: 3}
RAY_FRAMES = {1: 60, 4: 40, 16: 30, 32: 24}


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/bench paraview", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="1,4,16", help="millions of triangles (1,4,16; also 32)")
    parser.add_argument("--rounds", type=int, default=3, help="rounds, each measuring everything once (3)")
    parser.add_argument("--threads", type=int, default=2, help="threads of llvmpipe and GLuRay (2)")
    parser.add_argument("--size", type=int, default=1024, help="pixels of the window, both ways")
    parser.add_argument("--name", default="paraview", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even where there is a display")
    options = parser.parse_args(argv)
    try:
        options.sizes = [int(size) for size in options.sizes.split(",")]
    except ValueError:
        parser.error(f"--sizes takes whole numbers of millions, not '{options.sizes}'")
    if any(size not in ISOVALUES for size in options.sizes):
        parser.error(f"sizes are {', '.join(map(str, ISOVALUES))}")
    return options


def measure_size(options, size, environment):
    """Rounds of both at one size: (median of plain, median with GLuRay)."""
    def command(frames):
        return ["pvbatch", SCRIPT, ISOVALUES[size], frames[size], options.size]
    gluray = options.build / "apps" / "gluray" / "gluray"
    plain, traced = [], []
    for number in range(options.rounds):
        print(f"{size}M triangles, round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
        plain.append(programs.measure(command(GL_FRAMES), environment))
        traced.append(programs.measure_with_gluray(gluray, ["--threads", str(options.threads)], command(RAY_FRAMES),
                                                   environment))
    both = programs.combined(plain), programs.combined(traced)
    both[1]["report"] = traced[-1]["report"]
    return both


def row_of(size, plain, traced):
    report = traced["report"] or {}
    draws = report.get("draws", {})
    flushes = max(report.get("flushes", 0), 1)
    return {"millions": size, "triangles": plain["triangles"], "gl_fps": 1 / plain["frame_s"],
            "gluray_fps": 1 / traced["frame_s"], "gluray_over_gl": plain["frame_s"] / traced["frame_s"],
            "gl_first_image_s": plain["first_image_s"], "gluray_first_image_s": traced["first_image_s"],
            "gl_bytes_per_triangle": plain["rss_bytes"] / plain["triangles"],
            "gluray_bytes_per_triangle": traced["rss_bytes"] / plain["triangles"],
            "ms_per_picture": {part: value / flushes for part, value in report.get("ms", {}).items()},
            "draws_traced": draws.get("traced", 0), "rasterised": draws.get("rasterised", {})}


COLUMNS = [("Mtri", "millions", "{:d}"), ("GL fps", "gl_fps", "{:.2f}"), ("GLuRay fps", "gluray_fps", "{:.2f}"),
           ("ratio", "gluray_over_gl", "{:.1f}"), ("first GL s", "gl_first_image_s", "{:.2f}"),
           ("first GLuRay s", "gluray_first_image_s", "{:.2f}"), ("GL B/tri", "gl_bytes_per_triangle", "{:.0f}"),
           ("GLuRay B/tri", "gluray_bytes_per_triangle", "{:.0f}")]


def print_table(rows):
    cells = [[title for title, _, _ in COLUMNS]]
    cells += [[form.format(row[key]) for _, key, form in COLUMNS] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(COLUMNS))]
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)), flush=True)


def run(options, argv):
    if not shutil.which("pvbatch"):
        raise programs.Failed("pvbatch is missing: run scripts/setup (package python3-paraview)")
    result = {"suite": "paraview", "command": "scripts/bench paraview " + shlex.join(argv), **machine.describe(ROOT),
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
