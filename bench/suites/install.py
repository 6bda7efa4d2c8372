"""what installing and starting cost: scripts/bench install WHEEL

A new virtual environment without root: seconds from `pip install WHEEL pyvista` to the first traced picture; seconds that `import gluray` and
gluray.enable() take; milliseconds that gluray adds to the start of a program, in pairs with and without it, in alternating order.
Takes packages from PyPI. Needs no display. Results go to bench/results/NAME.json.
"""
import json
import os
import pathlib
import shlex
import statistics
import subprocess
import sys
import tempfile
import time

from support import machine, programs
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PICTURE = """
import json, gluray
gluray.enable(engine="always", quiet=True)
import pyvista
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(pyvista.Sphere(theta_resolution=300, phi_resolution=300), color="orange")
plotter.screenshot({picture!r})
print(json.dumps(gluray.report()["triangles"]))
"""
ENABLING = """
import time
start = time.perf_counter()
import gluray
gluray.enable(quiet=True)
print(time.perf_counter() - start)
"""


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench install")
    parser.add_argument("wheel", type=pathlib.Path, help="that of scripts/package wheel")
    parser.add_argument("--rounds", type=int, default=20, help="pairs of starts (20)")
    parser.add_argument("--name", default="install", help="name of the result file")
    return parser.parse_args(argv)


def output(*command):
    clean = {name: value for name, value in os.environ.items() if not name.startswith("GLURAY") and name not in ("DISPLAY", "PYTHONPATH")}
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=clean)
    if done.returncode:
        raise programs.Failed(f"exit code {done.returncode}: {' '.join(map(str, command))}\n{done.stderr[-2000:]}")
    return done.stdout


def timed(*command):
    start = time.perf_counter()
    output(*command)
    return time.perf_counter() - start


def start_of(environment, rounds, *program):
    """Milliseconds: of the program alone, and with gluray before it. Medians of rounds in alternating order."""
    ways = {"alone_ms": program, "gluray_ms": (environment / "bin/gluray", "--", *program)}
    found = {way: [] for way in ways}
    for number in range(rounds):
        for way in list(ways) if number % 2 else list(reversed(ways)):
            found[way].append(1000 * timed(*ways[way]))
    return {way: round(statistics.median(times), 2) for way, times in found.items()}


def installed(environment, wheel):
    """Seconds until everything is installed, and until the first picture after that is drawn."""
    picture = str(environment / "picture.png")
    start = time.perf_counter()
    output(environment / "bin/pip", "install", "--quiet", wheel, "pyvista")
    install = time.perf_counter() - start
    triangles = json.loads(output(environment / "bin/python", "-c", PICTURE.format(picture=picture)).splitlines()[-1])
    if not triangles["traced"]:
        raise programs.Failed("the picture was not traced")
    return {"wheel_bytes": wheel.stat().st_size, "install_s": round(install, 2), "picture_s": round(time.perf_counter() - start, 2)}


def run(options, argv):
    if not options.wheel.is_file():
        raise programs.Failed(f"{options.wheel} is no wheel; scripts/package wheel makes one")
    result = {"suite": "install", "command": f"scripts/bench install {shlex.join([options.wheel.name, *argv[1:]])}", **machine.describe(ROOT), "rows": []}
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as name:
        environment = pathlib.Path(name) / "environment"
        python = environment / "bin/python"
        output(sys.executable, "-m", "venv", environment)
        result["rows"].append({"program": "install", **installed(environment, options.wheel)})
        enabling = [float(output(python, "-c", ENABLING)) for _ in range(options.rounds)]
        result["rows"].append({"program": "enable", "import_and_enable_s": round(statistics.median(enabling), 4)})
        for what, program in (("true", ["true"]), ("python", [python, "-c", "pass"])):
            result["rows"].append({"program": f"start of {what}", **start_of(environment, options.rounds, *program)})
    for row in result["rows"]:
        for key, value in row.items():
            if key != "program":
                print(f"{row['program']:16} {key:20} {value}", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
