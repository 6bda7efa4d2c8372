"""light beyond the local look: times and noise of moving frames, rays a second against a bare Embree loop

The Wavelet's isosurfaces at several sizes, 1024x1024, an orbit of one degree a frame. Ways are traced in turn, frame by frame; ratios are
medians of frames beside each other. PSNR is that of pixels that hit something, against a picture of 1024 samples. Needs no display.
Results go to bench/results/NAME.json.
"""
import argparse
import pathlib
import shlex

from support import machine, programs
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/bench light", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="1,4,16", help="millions of triangles (1,4,16)")
    parser.add_argument("--quick", action="store_true", help="one million unless --sizes says otherwise, fewer frames, 256 samples")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="settings instead of ao=on, for instance ao=on and shadows=on")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="light", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    if options.quick and "--sizes" not in " ".join(argv):
        options.sizes = "1"
    return options


def figures_of(said):
    """Name and value of each line that the program printed."""
    lines = [line.split() for line in said.splitlines()]
    return {line[0]: float(line[1]) for line in lines if len(line) >= 2}


def measured(options, size):
    program = options.build / "bench" / "light" / "gluray-bench-light"
    programs.require(program)
    command = [program, "--triangles", size, "--threads", options.threads, *(["--quick"] if options.quick else [])]
    for setting in options.set:
        command += ["--set", setting]
    code, out, err = programs.run([str(word) for word in command], {}, 1800)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return figures_of(out)


def run(options, argv):
    result = {"suite": "light", "command": ("scripts/bench light " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for size in options.sizes.split(","):
        row = {"millions": float(size), **measured(options, size)}
        for name, value in row.items():
            if name != "millions":
                print(f"{size}M {name:28} {value:10.3f}", flush=True)
        result["rows"].append(row)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
