"""two builds of GLuRay in turn: scripts/bench versions OLD NEW

OLD and NEW are build folders. In each round every program runs once with each build, in alternating order,
so that other load on the machine affects both. Results are medians of the rounds; NEW/OLD below 1 means
faster. They go to bench/results/NAME.json. Programs whose requirements are missing are left out, with one line each.
"""
import argparse
import json
import os
import pathlib
import re
import shlex
import shutil
import statistics
import sys
import tempfile

from suites import micro, objects, shaders
from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SUPPORT = ROOT / "bench" / "support"
STREAMS = ROOT / "tests" / "streams"
GROUPS = ["frames", "micro", "paraview", "multisampled", "small_scenes", "objects", "shaders"]
PATHS = ["list", "elements", "vbo", "arrays", "immediate"]
LOOKS = ["surface", "edges", "translucent", "summed"]


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench versions")
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("--groups", default=",".join(GROUPS), help=f"some of {','.join(GROUPS)} (all)")
    parser.add_argument("--sizes", default="1,4", help="millions of triangles of the group frames (1,4)")
    parser.add_argument("--only", default="", help="programs whose names match this regular expression (all)")
    parser.add_argument("--rounds", type=int, default=5, help="rounds, each measuring everything once with each build (5)")
    parser.add_argument("--threads", type=int, default=2, help="threads of GLuRay and of llvmpipe (2)")
    parser.add_argument("--name", default="versions", help="name of the result file")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    options.groups = options.groups.split(",")
    if not set(options.groups) <= set(GROUPS):
        parser.error(f"groups are {', '.join(GROUPS)}")
    try:
        options.sizes = [int(size) for size in options.sizes.split(",")]
    except ValueError:
        parser.error(f"--sizes takes whole numbers of millions, not '{options.sizes}'")
    return options


class Program:
    """A command whose frame times are measured under one build or the other."""

    def __init__(self, name, command, read, settings=()):
        self.name, self.command, self.read, self.settings = name, command, read, settings

    def measure(self, gluray, options):
        """{figure: milliseconds} of one run."""
        settings = [word for setting in self.settings for word in ("--set", setting)]
        line = [gluray, "--engine", "always", "--threads", options.threads, *settings, "--", *self.command]
        return self.read(programs.measure(line, {}))


def frame_and_first(said):
    return {"frame_ms": 1000 * said["frame_s"], "first_image_ms": 1000 * said["first_image_s"]}


def moving_and_unchanged(said):
    return {"moving_ms": statistics.median(said["moving_ms"]), "unchanged_ms": statistics.median(said["unchanged_ms"])}


class Steps:
    """The single steps of scripts/bench micro, as times: microseconds per frame, a million triangles or a million calls."""

    name = "steps"

    def measure(self, gluray, options):
        folder = gluray.parents[2] / "bench" / "micro"
        every = argparse.Namespace(only=".")
        commands = ([gluray, "--engine", "always", "--", folder / "gluray-bench-door"], [folder / "gluray-bench-micro"])
        rates = {}
        for command in commands:
            for row in micro.rates_of(micro.measured(command, every, {"LP_NUM_THREADS": str(options.threads)})):
                rates[row[0]] = statistics.median(row[1])
        return {f"{name} us": 1e6 / rate if rate < 1e5 else 1e12 / rate for name, rate in rates.items()}


class Replay:
    """A recorded stream, timed as tests/streams/frame_times.py does it."""

    def __init__(self, name, stream):
        self.name, self.stream = name, stream

    def measure(self, gluray, _options):
        [(frame_ms, _)] = self.stream.milliseconds(1, [(gluray, "--engine", "auto", "--")])
        return {"frame_ms": frame_ms}


def programs_of(options, folder):
    """The programs to be measured, group by group."""
    if "frames" in options.groups:
        client = options.new / "bench" / "client" / "gluray-bench-client"
        programs.require(client)
        for size in options.sizes:
            for path in PATHS:
                yield Program(f"frames {size}M {path}", [client, "--triangles", size, "--path", path, "--frames", 48 if size > 1 else 72,
                                                         "--orbit", "--warm", 2 + 2 * size], frame_and_first)
    if "micro" in options.groups:
        yield Steps()
    if "paraview" in options.groups and there("pvbatch", "paraview"):
        for look in LOOKS:
            yield Program(f"paraview 1M {look}", ["pvbatch", SUPPORT / "paraview_orbit.py", 3, 60, 1024, "-", look, 4], frame_and_first)
    if "multisampled" in options.groups:
        for samples in (0, 4, 8):
            yield Program(f"VTK 1M, {samples} samples a pixel", ["/usr/bin/python3", SUPPORT / "vtk_still.py", 700, 20, samples], moving_and_unchanged)
    culled = ["cull.draws=always"]
    if "objects" in options.groups:
        client = options.new / "bench" / "client" / "gluray-bench-objects"
        programs.require(client)
        for scene, words in objects.SCENES.items():
            yield Program(f"objects {scene}", [client, "--rows", 23, "--frames", 20, *words], frame_and_first, culled)
    if "shaders" in options.groups:
        client = options.new / "bench" / "client" / "gluray-bench-client"
        programs.require(client)
        for scene, words in shaders.SCENES.items():
            yield Program(f"shaders 1M {scene}", [client, "--triangles", 1, "--path", "shader", *words, "--frames", shaders.FRAMES[1], "--orbit",
                                                  "--step", shaders.STEP, "--warm", 2], frame_and_first, culled)
    if "small_scenes" in options.groups and there("apitrace", "small_scenes"):
        sys.path.insert(0, str(STREAMS))
        import frame_times
        import streams
        for name in streams.STREAMS:
            yield Replay(name, frame_times.Stream(name, 200, folder))


def there(program, group):
    found = shutil.which(program) is not None
    if not found:
        print(f"bench: {program} is missing, the group {group} is left out: run scripts/setup", file=sys.stderr)
    return found


def row_of(name, old, new):
    """Medians of both builds' rounds, and the ratio of each figure."""
    def medians(rounds):
        return {key: statistics.median(figures[key] for figures in rounds) for key in rounds[0]}
    before, after = medians(old), medians(new)
    return {"program": name, "old": before, "new": after, "rounds": {"old": old, "new": new},
            "new_over_old": {key: after[key] / before[key] for key in before}}


def measure(program, options):
    runs = {options.old: [], options.new: []}
    for number in range(options.rounds):
        print(f"{program.name}, round {number + 1} of {options.rounds}", file=sys.stderr, flush=True)
        for build in [options.old, options.new][::-1 if number % 2 else 1]:
            runs[build].append(program.measure(build / "apps" / "gluray" / "gluray", options))
    return row_of(program.name, runs[options.old], runs[options.new])


def print_row(row):
    for key, ratio in row["new_over_old"].items():
        print(f"{row['program']:34} {key:15} {row['old'][key]:9.2f} {row['new'][key]:9.2f} {ratio:8.3f}", flush=True)


def version(build):
    """The commit of a build folder's source tree."""
    return machine.describe(build.resolve().parent.parent)["versions"]["source"]


def named(argv, options):
    """The arguments with OLD and NEW in place of build folders, whose commits the result has."""
    names = {str(options.old): "OLD", str(options.new): "NEW"}
    return [names.get(str(pathlib.Path(word)), word) for word in argv]


def run(options, argv):
    for build in (options.old, options.new):
        programs.require(build / "apps" / "gluray" / "gluray")
    result = {"suite": "versions", "command": "scripts/bench versions " + shlex.join(named(argv, options)), **machine.describe(ROOT),
              "old": version(options.old), "new": version(options.new), "threads": options.threads, "rounds": options.rounds, "rows": []}
    print(f"{'program':34} {'figure':15} {'old':>9} {'new':>9} {'new/old':>8}")
    with display(own=options.xvfb) as name, tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        os.environ.update({"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)})
        for program in programs_of(options, pathlib.Path(folder)):
            if not re.search(options.only, program.name):
                continue
            result["rows"].append(measure(program, options))
            print_row(result["rows"][-1])
    if not result["rows"]:
        raise SystemExit(f"bench: no program of these groups matches '{options.only}'")
    ratios = [ratio for row in result["rows"] for ratio in row["new_over_old"].values()]
    result["median_ratio"] = statistics.median(ratios)
    print(f"median of the ratios: {result['median_ratio']:.3f}")
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv), json.JSONDecodeError)
