"""frame times of VTK's volume rendering without GLuRay and with it, in turn

Draws a volume that turns (bench/volumes/turning_volume.py): a smooth field of which a third is empty, and tubes; unlit and lit.
Rounds alternate; the ratio is the median of those of the rounds. Results go to bench/results/NAME.json.
"""
import itertools
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENE = ROOT / "bench" / "volumes" / "turning_volume.py"


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench volumes")
    parser.add_argument("--voxels", default="256", help="along each axis: some sizes, such as 256,512")
    parser.add_argument("--steps", default="1,0.5", help="of rays, in voxels")
    parser.add_argument("--types", default="floats", help="of voxels: floats, bytes or both, floats,bytes")
    parser.add_argument("--fields", default="dense,sparse")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="volumes", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--python", default="/usr/bin/python3", help="a Python with VTK")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.voxels = [int(size) for size in options.voxels.split(",")]
    options.steps = [float(step) for step in options.steps.split(",")]
    options.types = options.types.split(",")
    options.fields = options.fields.split(",")
    if not set(options.fields) <= {"dense", "sparse"}:
        parser.error("fields are dense and sparse")
    if not set(options.types) <= {"floats", "bytes"}:
        parser.error("types are floats and bytes")
    return options


def row_of(scene, plain, traced):
    """The medians of all rounds; `ratio` above 1: GLuRay is faster."""
    draws = (traced[-1]["report"] or {}).get("draws", {})
    ratios = [a["frame_s"] / b["frame_s"] for a, b in zip(plain, traced)]
    return {"scene": scene, "gl_ms": 1000 * statistics.median(m["frame_s"] for m in plain),
            "gluray_ms": 1000 * statistics.median(m["frame_s"] for m in traced), "ratio": statistics.median(ratios),
            "ratios": [round(ratio, 2) for ratio in ratios], "gl_rss_bytes": plain[-1]["rss_bytes"],
            "gluray_rss_bytes": traced[-1]["rss_bytes"], "traced": draws.get("traced", 0), "rasterised": draws.get("rasterised", {})}


def run(options, argv):
    result = {"suite": "volumes", "command": "scripts/bench volumes " + shlex.join(argv), **machine.describe(ROOT), "threads": options.threads,
              "rounds": options.rounds, "rows": []}
    gluray = options.build / "apps" / "gluray" / "gluray"
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads), "PYTHONDONTWRITEBYTECODE": "1"}
        for voxels, kind, step, field, lit in itertools.product(options.voxels, options.types, options.steps, options.fields, (False, True)):
            command = [options.python, SCENE, "--field", field, "--voxels", voxels, "--step", step, *(["--lit"] if lit else []),
                       *(["--bytes"] if kind == "bytes" else [])]
            found = programs.in_turn(
                {"plain": lambda: programs.measure(command, environment),
                 "traced": lambda: programs.measure_with_gluray(gluray, ["--threads", options.threads], command, environment, engine="auto")},
                options.rounds, alternate=True)
            scene = f"{field}, {'lit' if lit else 'unlit'}, {voxels}^3 {kind}, step {step:g}"
            row = row_of(scene, found["plain"], found["traced"])
            result["rows"].append(row)
            print(f"{scene:42} {row['gl_ms']:8.1f} ms  {row['gluray_ms']:7.1f} ms  ratio {row['ratio']:.1f}  {row['ratios']}", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
