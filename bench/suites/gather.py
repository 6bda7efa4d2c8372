"""seconds a frame of pvbatch whose ranks share data, with and without `gather`, against one process

Isosurfaces of the Wavelet source in 1000x800 pixels, ambient occlusion with four rays a pixel, each frame finished. All ranks and one
worker run on this machine, so that they share its cores: this is what gathering costs, not what ranks gain. Kinds: off (each rank traces its part, rays
cross ranks), gather, and gather with a ground, whose images are traced twice. One rank is one process without workers, with the ground if
the kind has one. Results go to bench/results/NAME.json. Needs python3-paraview and Open MPI.
"""
import json
import os
import pathlib
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from support import machine
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCRIPT = ROOT / "bench" / "support" / "gather_orbit.py"
SIZES = {"small": (25, 3), "large": (100, 3)}  # half of the Wavelet's edge, isovalues
LIGHT = ["ao=on", "ao.samples=4", "refine.passes=1"]
GROUND = ["ground=plane"]
KINDS = {"off": [], "gather": ["gather=on"], "gather, ground": ["gather=on", *GROUND]}


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench gather")
    parser.add_argument("--sizes", default=",".join(SIZES), help=f"some of {','.join(SIZES)}")
    parser.add_argument("--ranks", default="1,2,4", help="numbers of ranks (1,2,4)")
    parser.add_argument("--frames", type=int, default=5)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--name", default="gather", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.sizes, options.ranks = options.sizes.split(","), [int(ranks) for ranks in options.ranks.split(",")]
    if not set(options.sizes) <= set(SIZES) or min(options.ranks) < 1:
        parser.error(f"sizes are {', '.join(SIZES)}, ranks at least 1")
    return options


def measure(options, environment, size, ranks, kind):
    """What the script prints: with a worker, if there are several ranks."""
    settings = [*LIGHT, *KINDS[kind]] if ranks > 1 else [*LIGHT, *(GROUND if "ground" in kind else [])]
    words = [word for setting in settings for word in ("--set", setting)]
    worker = None
    if ranks > 1:
        worker = subprocess.Popen([options.build / "apps" / "gluray" / "gluray-worker", "--job", "bench", "--quiet"], env=environment)
        time.sleep(1)  # its socket is there
        words += ["--workers", "bench"]
    root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    extent, count = SIZES[size]
    try:
        done = subprocess.run(["mpirun", *root, "--oversubscribe", "-n", str(ranks), options.build / "apps" / "gluray" / "gluray", "--engine", "always",
                               *words, "--", "pvbatch", "--force-offscreen-rendering", SCRIPT, str(extent), str(count), str(options.frames)],
                              env=environment, stdout=subprocess.PIPE, text=True, timeout=900, check=True)
    finally:
        if worker:
            worker.terminate()
            worker.wait()
    return json.loads(next(line for line in done.stdout.splitlines() if line.startswith("{")))


def run(options, argv):
    result = {"suite": "gather", "command": "scripts/bench gather " + shlex.join(argv), **machine.describe(ROOT), "rounds": options.rounds, "rows": []}
    with display(own=options.xvfb) as name, tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "DISPLAY": name, "LP_NUM_THREADS": "1", "GLURAY_RUNTIME": folder}
        for size in options.sizes:
            single = {}
            for ranks in options.ranks:
                for kind in KINDS:
                    if ranks == 1 and kind == "gather":
                        continue  # nothing to gather
                    all_rounds = [measure(options, environment, size, ranks, kind) for _ in range(options.rounds)]
                    row = {"kind": f"{size}, {ranks} ranks, {kind}", "triangles": all_rounds[0]["triangles"],
                           "frame_ms": 1000 * statistics.median(one["frame_s"] for one in all_rounds)}
                    if ranks == 1:
                        single[kind] = row["frame_ms"]
                    base = single.get(kind, single.get("off"))
                    row["over_one_process"] = row["frame_ms"] / base if base else None
                    result["rows"].append(row)
                    print(f"{row['kind']:32} {row['triangles']:>10,} triangles {row['frame_ms']:8.1f} ms  /one process {row['over_one_process'] or 0:.2f}", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    if not shutil.which("pvbatch") or not shutil.which("mpirun"):
        print("bench: pvbatch or mpirun is missing: run scripts/setup", file=sys.stderr)
        return 1
    return status_of(lambda: run(options, argv))
