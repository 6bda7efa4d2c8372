"""frames a second of libraries of PyPI without GLuRay and with it, in turn: 500,000 triangles in each

Draws a mesh that turns by Open3D, vispy, polyscope, pyrender, PyQtGraph and moderngl (bench/wheels/frames.py), with the
environment that scripts/test --wheels makes, and with `--engine auto`. Rounds alternate; the ratio is the median of those of
the rounds. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LIBRARIES = ["open3d", "vispy", "polyscope", "pyrender", "pyqtgraph", "moderngl"]
WARM, FRAMES = 60, 60


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench wheels")
    parser.add_argument("--only", default=",".join(LIBRARIES), help=f"some of {','.join(LIBRARIES)}")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="wheels", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "wheels", help="of scripts/test --wheels (build/wheels)")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.only = options.only.split(",")
    if not set(options.only) <= set(LIBRARIES):
        parser.error(f"libraries are {', '.join(LIBRARIES)}")
    return options


def row_of(library, plain, traced):
    """The medians of all rounds; `ratio` above 1: GLuRay is faster."""
    report = traced[-1]["report"] or {}
    seen = report.get("triangles", {})
    total = seen.get("traced", 0) + seen.get("rasterised", 0)
    ratios = [a["frame_s"] / b["frame_s"] for a, b in zip(plain, traced)]
    return {"program": library, "triangles": plain[0]["triangles"], "gl_ms": 1000 * statistics.median(m["frame_s"] for m in plain),
            "gluray_ms": 1000 * statistics.median(m["frame_s"] for m in traced), "ratio": statistics.median(ratios),
            "ratios": [round(ratio, 3) for ratio in ratios], "traced": seen.get("traced", 0) / total if total else 0,
            "rasterised": report.get("draws", {}).get("rasterised", {})}


def run(options, argv):
    result = {"suite": "wheels", "command": "scripts/bench wheels " + shlex.join(argv), **machine.describe(ROOT), "threads": options.threads,
              "rounds": options.rounds, "rows": []}
    gluray, python = options.build / "apps" / "gluray" / "gluray", options.folder / "environment" / "bin" / "python"
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads), "PYTHONDONTWRITEBYTECODE": "1"}
        for library in options.only:
            command = [python, ROOT / "bench" / "wheels" / "frames.py", library, WARM, FRAMES]
            found = programs.in_turn(
                {"plain": lambda: programs.measure(command, environment),
                 "traced": lambda: programs.measure_with_gluray(gluray, ["--threads", options.threads], command, environment, engine="auto")},
                options.rounds, alternate=True)
            row = row_of(library, found["plain"], found["traced"])
            result["rows"].append(row)
            print(f"{library:10} {row['gl_ms']:7.1f} ms  {row['gluray_ms']:7.1f} ms  ratio {row['ratio']:.2f}  {row['ratios']}  "
                  f"{100 * row['traced']:.0f} % traced", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
