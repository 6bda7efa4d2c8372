"""images at rest: noise and time of passes, smoothed or not, adaptive or not

The Wavelet's isosurfaces, 1024x1024, ambient occlusion and paths; occlusion with 16 samples per pixel, and of translucent layers. PSNR is that of pixels that hit something, against an image of 1024 samples.
Times of auxiliary features and smoothing are shares of one pass. With --denoisers, instead: four scenes, three kinds of light, images of 1, 4, 16
and 64 samples without a denoiser, with GLuRay's filter and with Open Image Denoise (GLURAY_OIDN names its folder), whose times are CPU seconds.
With --goal, instead: four scenes, three kinds of light, passes of --samples rays or paths a pixel with GLuRay's filter until an image is that
close to its reference, as multiples of frames of the local look in turn with it; and the medians of the scenes.
Needs no display. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex
import statistics

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

DENOISED_LIGHTS = ("occlusion", "shadows", "sky")
SCENES = ("wavelet", "balls", "tubes", "landscape")


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench refine")
    parser.add_argument("--sizes", default="1", help="millions of triangles (1)")
    parser.add_argument("--reference", type=int, default=1024, help="samples of the image to compare with")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--denoisers", action="store_true", help="compare denoisers")
    parser.add_argument("--goal", type=float, metavar="DB", help="frames of the local look until this PSNR")
    parser.add_argument("--samples", type=int, default=4, help="with --goal: rays or paths a pixel in each pass (4)")
    parser.add_argument("--passes", type=int, default=64, help="with --goal: and no more (64)")
    parser.add_argument("--scenes", default=",".join(SCENES), help="with --goal")
    parser.add_argument("--lights", default=",".join(DENOISED_LIGHTS), help="with --goal")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER", help="with --goal: where references are kept for the next run")
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
        for light in DENOISED_LIGHTS:
            for scene in SCENES:
                yield {"scene": scene, "light": light}, ["--scene", scene, "--light", light, "--samples", 1, "--size", options.size, "--denoisers"]
        return
    if options.goal:
        for light in options.lights.split(","):
            for scene in options.scenes.split(","):
                keep = ["--keep", options.keep / f"{scene}_{light}_{options.reference}"] if options.keep else []
                yield {"scene": scene, "light": light, "samples": options.samples}, [
                    "--scene", scene, "--light", light, "--samples", options.samples, "--goal", options.goal, "--passes", options.passes, *keep]
        return
    for size in options.sizes.split(","):
        for light, more in LIGHTS.items():
            yield {"millions": float(size), "light": light}, ["--triangles", size, *more]


def medians(rows):
    """A row a light: the median of its scenes. Scenes that did not come to the goal count as endless."""
    for light in dict.fromkeys(row["light"] for row in rows):
        frames = [row.get("goal_local_frames", float("inf")) for row in rows if row["light"] == light]
        median = statistics.median(frames)
        yield {"light": light, "scenes": len(frames), "median_local_frames": round(median, 2) if median < float("inf") else None}


def run(options, argv):
    result = {"suite": "refine", "command": ("scripts/bench refine " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for head, more in rows_of(options):
        figures = measured(options, *more)
        for name, value in figures.items():
            print(f"{' '.join(map(str, head.values()))} {name:28} {value:10.3f}", flush=True)
        result["rows"].append({**head, **figures})
        machine.write(ROOT, options.name, result)
    if options.goal:
        result["medians"] = list(medians(result["rows"]))
        print(*result["medians"], sep="\n")
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
