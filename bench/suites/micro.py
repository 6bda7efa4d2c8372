"""single steps: a vertex call, small draws, capture, the unchanged check, builds, tracing, the write-back, volumes

Google Benchmark programs: gluray-bench-micro (the library's parts) and gluray-bench-door (a program, with and without gluray),
0.87 million triangles and 1024x1024 pixels; volumes: 256^3 floats, 800x600 pixels and one thread. Medians of five repetitions, with their lowest and highest. Results go to
bench/results/NAME.json.
"""
import json
import os
import pathlib
import shlex
import statistics

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PIXELS = 1024 * 1024
# Row: (unit, of how many items a second); the first part of the benchmark's name tells what its items are.
UNITS = {
    "door": ("ns_per_call", lambda rate: 1e9 / rate),
    "engine": ("ns_per_call", lambda rate: 1e9 / rate),
    "capture": ("mtri_per_s", lambda rate: rate / 1e6),
    "unchanged": ("mtri_per_s", lambda rate: rate / 1e6),
    "build": ("mtri_per_s", lambda rate: rate / 1e6),
    "trace": ("fps", lambda rate: rate),
    "write_back": ("ms", lambda rate: 1e3 / rate),
    "volume": ("ms", lambda rate: 1e3 / rate),
}


def rates_of(said):
    """(name, items a second of each repetition), of what Google Benchmark printed as JSON. Failed where a benchmark failed."""
    rates = {}
    for run in said["benchmarks"]:
        if run.get("error_occurred"):
            raise programs.Failed(f"{run['name']}: {run.get('error_message', 'failed')}")
        if run.get("run_type") == "iteration":
            rates.setdefault("/".join(run["run_name"].split("/")[:2]), []).append(run["items_per_second"])
    return rates.items()


def rows_of(said, path):
    """Rows from Google Benchmark's JSON; `path` is part of their names. Raises Failed if a benchmark failed."""
    for name, found in rates_of(said):
        unit, of = UNITS[name.split("/")[0]]
        values = [of(rate) for rate in found]
        row = {"scene": name, "path": path, unit: statistics.median(values), f"{unit}_low": min(values), f"{unit}_high": max(values)}
        if unit == "fps":
            row["mray_per_s"] = row["fps"] * PIXELS / 1e6
        yield row


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench micro")
    parser.add_argument("--only", default=".", help="regular expression of the benchmarks' names, for instance write_back")
    parser.add_argument("--threads", type=int, default=len(os.sched_getaffinity(0)), help="threads of Mesa (all)")
    parser.add_argument("--name", default="micro", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    return parser.parse_args(argv)


def measured(command, options, environment):
    """The results of a benchmark program; an empty list if no name fits."""
    line = [*command, "--benchmark_format=json", f"--benchmark_filter={options.only}"]
    code, out, err = programs.run(line, environment, 900)
    if "Failed to match any benchmarks" in err:
        return {"benchmarks": []}
    if code != 0:
        raise programs.Failed(f"exit code {code}: {' '.join(map(str, line))}\n{err}")
    return json.loads(out[out.index("{"):])


def print_table(rows):
    cells = [["step", "of", "median", "lowest", "highest", "unit"]]
    for row in rows:
        unit = next(unit for unit, _ in UNITS.values() if unit in row)
        cells.append([row["scene"], row["path"], *[f"{row[key]:.3g}" for key in (unit, f"{unit}_low", f"{unit}_high")], unit])
    widths = [max(len(line[i]) for line in cells) for i in range(len(cells[0]))]
    for line in cells:
        print("  ".join(text.ljust(width) if i in (0, 1, 5) else text.rjust(width) for i, (text, width) in enumerate(zip(line, widths))).rstrip())


def run(options, argv):
    folder = options.build / "bench" / "micro"
    gluray = options.build / "apps" / "gluray" / "gluray"
    programs.require(folder / "gluray-bench-micro", folder / "gluray-bench-door", gluray)
    result = {"suite": "micro", "command": ("scripts/bench micro " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for path, command in (("real OpenGL", [folder / "gluray-bench-door"]), ("GLuRay", [gluray, "--engine", "always", "--", folder / "gluray-bench-door"]),
                              ("library", [folder / "gluray-bench-micro"])):
            result["rows"] += rows_of(measured(command, options, environment), path)
    if not result["rows"]:
        raise programs.Failed(f"no benchmark's name fits {options.only}")
    print_table(result["rows"])
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
