"""light across the ranks of a sort-last program: times and bytes

The Wavelet's isosurfaces, 1024x1024, in slabs: each rank holds one, and one worker traces for all. Ambient occlusion with four rays a pixel. All
ranks share this machine's cores, so that times show what the exchange costs, not how it scales. Needs no display. Results go to
bench/results/NAME.json.
"""
import argparse
import pathlib
import shlex

from suites.light import figures_of
from support import machine, programs
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/bench scale", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sizes", default="1,4", help="millions of triangles (1,4)")
    parser.add_argument("--ranks", default="1,2,4,8", help="numbers of ranks (1,2,4,8)")
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--threads", type=int, default=2, help="of each rank")
    parser.add_argument("--name", default="scale", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    return parser.parse_args(argv)


def measured(options, size, ranks):
    program = options.build / "bench" / "scale" / "gluray-bench-scale"
    programs.require(program)
    command = [program, "--triangles", size, "--ranks", ranks, "--frames", options.frames, "--threads", options.threads]
    code, out, err = programs.run([str(word) for word in command], {}, 1800)
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, command))}\n{err}")
    return figures_of(out)


def run(options, argv):
    result = {"suite": "scale", "command": ("scripts/bench scale " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    for size in options.sizes.split(","):
        for ranks in options.ranks.split(","):
            row = {"millions": float(size), "ranks": int(ranks), **measured(options, size, ranks)}
            for name, value in row.items():
                if name not in ("millions", "ranks"):
                    print(f"{size}M {ranks} ranks {name:28} {value:10.3f}", flush=True)
            result["rows"].append(row)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
