"""images at rest: noise and time of passes, smoothed or not, adaptive or not

The Wavelet's isosurfaces, 1024x1024, ambient occlusion and paths; occlusion with 16 samples per pixel, and of translucent layers. PSNR is that of pixels that hit something, against an image of 1024 samples.
Times of auxiliary features and smoothing are shares of one pass. With --denoisers, instead: four scenes, three kinds of light, images of 1, 4, 16
and 64 samples without a denoiser, with GLuRay's filter and with Open Image Denoise (GLURAY_OIDN names its folder), whose times are CPU seconds.
Needs no display. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex

from suites.light import figures_of
from support import machine, programs
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Options of the program by the rows' names.
LIGHTS = {
    "occlusion": [],
    "paths": ["--light", "paths", "--samples", 1],
    "occlusion, 16 samples a pixel": ["--spp", 16, "--samples", 16],
    "occlusion, layers": ["--layers"],
}


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench refine")
    parser.add_argument("--sizes", default="1", help="millions of triangles (1)")
    parser.add_argument("--reference", type=int, default=1024, help="samples of the image to compare with")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--denoisers", action="store_true", help="compare denoisers")
    parser.add_argument("--size", type=int, default=1024, help="with --denoisers: pixels in the middle of the image, both ways")
    parser.add_argument("--name", default="refine", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    return parser.parse_args(argv)


def measured(options, *more):
    program = options.build / "bench" / "refine" / "gluray-bench-refine"
    programs.require(program)
    command = [program, "--threads", options.threads, "--reference", options.reference, *more]
    code, out, err = programs.run([str(word) for word in command], {}, 7200)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return figures_of(out)


def rows_of(options):
    """What each row says of itself, and options of the program."""
    if options.denoisers:
        for light in ("occlusion", "shadows", "sky"):
            for scene in ("wavelet", "balls", "tubes", "landscape"):
                yield {"scene": scene, "light": light}, ["--scene", scene, "--light", light, "--samples", 1, "--size", options.size, "--denoisers"]
        return
    for size in options.sizes.split(","):
        for light, more in LIGHTS.items():
            yield {"millions": float(size), "light": light}, ["--triangles", size, *more]


def run(options, argv):
    result = {"suite": "refine", "command": ("scripts/bench refine " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for head, more in rows_of(options):
        figures = measured(options, *more)
        for name, value in figures.items():
            print(f"{' '.join(map(str, head.values()))} {name:28} {value:10.3f}", flush=True)
        result["rows"].append({**head, **figures})
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
