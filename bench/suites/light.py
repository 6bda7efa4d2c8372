"""light beyond the local look: times and noise of moving frames and at rest, rays a second against a bare Embree loop

The Wavelet's isosurfaces at several sizes and 48,000 lines as tubes, 1024x1024, an orbit of one degree a frame; each with ambient occlusion
alone and with a soft shadow beside it. Also the lines in the look `streamlines`, 800x600, one sample a pixel, with processor times. Ways are traced in turn, frame by frame; ratios are medians of frames beside each other. PSNR is that of
pixels that hit something, against an image of 1024 samples. Needs no display. Without options, all of it: about a quarter of an hour on four
idle cores. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex

from support import machine, programs
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench light")
    parser.add_argument("--sizes", default="1,4,16,64", help="millions of triangles (1,4,16,64)")
    parser.add_argument("--lines", type=int, default=48000, help="lines as tubes (48000); 0: none")
    parser.add_argument("--scenes", default="wavelet,lines,streamlines", help="which of wavelet, lines, streamlines (all)")
    parser.add_argument("--quick", action="store_true", help="one million unless --sizes says otherwise, fewer frames, 256 samples")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="settings instead of ao=on")
    parser.add_argument("--no-shadow", action="store_true", help="leave the soft shadow out")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="light", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    if options.quick and "--sizes" not in " ".join(argv):
        options.sizes = "1"
    return options


SHADOW = ["shadows=on", "lights=headlight+key", "lights.attached=scene", "lights.azimuth=45", "shadows.size=3"]


def figures_of(said):
    """Name and value of each line that the program printed."""
    lines = [line.split() for line in said.splitlines()]
    return {line[0]: float(line[1]) for line in lines if len(line) >= 2}


def measured(options, scene):
    """Figures of one scene of scenes_of()."""
    program = options.build / "bench" / "light" / "gluray-bench-light"
    programs.require(program)
    command = [program, *scene["options"], "--threads", options.threads, *(["--quick"] if options.quick else [])]
    for setting in options.set:
        command += ["--set", setting]
    for setting in [] if options.no_shadow or "look" in scene["row"] else SHADOW:
        command += ["--shadow", setting]
    code, out, err = programs.run([str(word) for word in command], {}, 1800)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return figures_of(out)


def scenes_of(options):
    """Name, what the result's row says, and options of the program, each."""
    asked = options.scenes.split(",")
    for size in filter(None, options.sizes.split(",") if "wavelet" in asked else []):
        yield {"name": f"{size}M", "row": {"scene": "wavelet", "millions": float(size)}, "options": ["--triangles", size, *(["--no-rest"] if float(size) > 16 else [])]}
    lines = ["--lines", options.lines, "--no-rest", "--frames", 12]
    if options.lines and "lines" in asked:
        # Thin lines take many samples: their noise is not what is asked.
        yield {"name": "lines", "row": {"scene": "lines", "lines": options.lines}, "options": [*lines, "--reference", 16]}
    if options.lines and "streamlines" in asked:
        look = ["--preset", "streamlines", "--set", "spp=1", "--size", "800x600", "--reference", 128]
        yield {"name": "streamlines", "row": {"scene": "lines", "lines": options.lines, "look": "streamlines", "size": "800x600"}, "options": [*lines, *look]}


def run(options, argv):
    result = {"suite": "light", "command": ("scripts/bench light " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for scene in scenes_of(options):
        figures = measured(options, scene)
        for figure, value in figures.items():
            print(f"{scene['name']} {figure:32} {value:10.3f}", flush=True)
        result["rows"].append({**scene["row"], **figures})
        machine.write(ROOT, options.name, result)  # what there is, if a later scene fails


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
