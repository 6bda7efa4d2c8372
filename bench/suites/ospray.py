"""light beside OSPRay: frames with occlusion and a soft shadow, and path-traced images at rest

The same mesh, views, lights and machine, both in one process, in turn; 1024x1024. Frames: OSPRay's scivis with 4 occlusion samples and shadows, and
GLuRay's moving frames. At rest: passes of one path a pixel until the image is 35 dB from the renderer's own image of many. PSNR is that of
pixels that hit something, each against its own reference. `green` is the mean of the references' green: both are about as bright.
Where the distribution has OSPRay 3 (Debian 13: libospray-dev). Needs no display. Results go to bench/results/NAME.json.
"""
import json
import pathlib
import shlex

from support import machine, programs
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FRAMES = ["--ao", 4, "--set", "ao=on", "--set", "ao.radius=1000", "--set", "shadows=on", "--set", "shadows.size=3"]
REST = ["--until", 35, "--renderer", "pathtracer", "--set", "integrator=path", "--set", "path.samples=1", "--set", "path.lights=0.8",
        "--set", "environment.strength=0.25"]


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench ospray")
    parser.add_argument("--sizes", default="1,4", help="millions of triangles (1,4)")
    parser.add_argument("--reference", type=int, default=256, help="passes of the references (256)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="ospray", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    return parser.parse_args(argv)


def measured(options, size, what):
    program = options.build / "bench" / "ospray" / "gluray-bench-ospray"
    programs.require(program)
    command = [program, "--triangles", size, "--threads", options.threads, "--reference", options.reference, *what]
    code, out, err = programs.run([str(word) for word in command], {}, 1800)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return json.loads(out.strip().splitlines()[-1])


def run(options, argv):
    result = {"suite": "ospray", "command": ("scripts/bench ospray " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for size in options.sizes.split(","):
        for name, what in (("frames", FRAMES), ("paths at rest", REST)):
            row = {"millions": float(size), "what": name, **measured(options, size, what)}
            row["ospray_time_ratio"] = row["ospray_s"] / row["gluray_s"]
            print(" ".join(f"{key}={value}" for key, value in row.items()), flush=True)
            result["rows"].append(row)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
