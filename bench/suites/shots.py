"""pictures of saved scenes: how long saving takes, and what a large picture costs compared with one of the window's size

VTK draws a wavy plane of so many million triangles in a window of 800x600; `gluray save` writes it to a folder in memory (/dev/shm), and `gluray render` makes
pictures of the window's size and of SIZE. Each round makes both pictures in turn. Of each run the processor time and the largest resident memory count; a picture's
own time is that of the run without what opening the scene takes, which a run of 32x24 pixels shows. Medians. Needs Debian's VTK (python3-paraview or python3-vtk9).
Results go to bench/results/NAME.json.
"""
import json
import os
import pathlib
import resource
import shlex
import statistics
import subprocess
import tempfile
import time

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK
WINDOW = (800, 600)
PATIENCE = 120  # seconds until the program shows its first frame


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench shots")
    parser.add_argument("--sizes", default="1,16", help="millions of triangles (1,16)")
    parser.add_argument("--picture", default="7680x4320", help="of the large picture (7680x4320)")
    parser.add_argument("--light", action="store_true", help="pictures with the preset presentation")
    parser.add_argument("--rounds", type=int, default=3, help="rounds (3)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="shots", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    options = parser.parse_args(argv)
    options.sizes = [float(size) for size in options.sizes.split(",")]
    return options


class Measured:
    """Runs of commands, with their processor time and memory."""

    def __init__(self, environment, folder):
        self.environment, self.folder = {**os.environ, **environment}, folder

    def run(self, *words):
        before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        process = subprocess.Popen([str(word) for word in words], env=self.environment, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = process.communicate()
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if process.returncode:
            raise programs.Failed(f"exit code {process.returncode}: {' '.join(map(str, words))}\n{err}")
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return {"cpu_s": cpu, "wall_s": time.monotonic() - began, "out": out}


def peak_of(environment, folder, *words):
    """The largest resident memory of a command, in MiB."""
    code = "import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL); print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    done = subprocess.run([PYTHON, "-c", code, *map(str, words)], env={**os.environ, **environment}, cwd=folder, capture_output=True, text=True, check=True)
    return int(done.stdout) / 1024


def shown(gluray, environment, millions, work):
    """Starts the program, and waits until it can be saved. Returns it and its hub."""
    hub = subprocess.Popen([gluray, "hub"], env=work.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    program = subprocess.Popen([gluray, "--set", "engine=always", "--", PYTHON, "-B", str(ROOT / "bench" / "shots" / "waves_window.py"), str(millions), *map(str, WINDOW)],
                               env=work.environment, stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + PATIENCE
    while program.poll() is None and time.monotonic() < end:
        listed = subprocess.run([gluray, "list", "--json"], env=work.environment, capture_output=True, text=True, check=False)
        if listed.returncode == 0 and json.loads(listed.stdout or "[]"):
            return program, hub
        time.sleep(0.2)
    raise programs.Failed("the program shows no frame")


def measured(options, millions, environment, folder):
    gluray = options.build / "apps" / "gluray" / "gluray"
    work = Measured({**environment, "GLURAY_RUNTIME": str(folder / "run")}, folder)
    program, hub = shown(gluray, environment, millions, work)
    try:
        work.run(gluray, "save", "scene.gluray")  # hashes of arrays are known from then on
        saves = [work.run(gluray, "save", "scene.gluray")["wall_s"] for _ in range(options.rounds)]
    finally:
        for process in (program, hub):
            process.terminate()
            process.wait()
    light = ["--preset", "presentation"] if options.light else []
    render = [gluray, "render", "scene.gluray", "picture.png", "--threads", options.threads, *light, "--restart", "--size"]
    window, runs = "x".join(map(str, WINDOW)), {"open": [], "window": [], "large": []}
    for _ in range(options.rounds):
        for name, size in (("open", "32x24"), ("window", window), ("large", options.picture)):
            runs[name].append(work.run(*render, size)["cpu_s"])
    cpu = {name: statistics.median(all_) for name, all_ in runs.items()}
    pixels = [int(side) for side in options.picture.split("x")]
    share = pixels[0] * pixels[1] / (WINDOW[0] * WINDOW[1])
    peaks = {name: peak_of(work.environment, folder, *render, size) for name, size in (("window", window), ("large", options.picture))}
    return {"scene": "waves", "millions": millions, "light": options.light, "picture": options.picture, "rounds": options.rounds,
            "file_mb": (folder / "scene.gluray").stat().st_size / 1e6, "save_s": statistics.median(saves),
            **{f"{name}_cpu_s": value for name, value in cpu.items()}, "large_over_its_pixels": (cpu["large"] - cpu["open"]) / (cpu["window"] - cpu["open"]) / share,
            **{f"{name}_peak_mib": value for name, value in peaks.items()}}


def run(options, argv):
    result = {"suite": "shots", "command": ("scripts/bench shots " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rows": []}
    programs.require(options.build / "apps" / "gluray" / "gluray")
    with display() as name:
        for millions in options.sizes:
            with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
                row = measured(options, millions, {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}, pathlib.Path(folder))
            result["rows"].append(row)
            print(f"{millions:5g}M  save {row['save_s']:.2f} s ({row['file_mb']:.0f} MB)  window {row['window_cpu_s']:.1f} s  {row['picture']} {row['large_cpu_s']:.1f} s of processor time: "
                  f"{row['large_over_its_pixels']:.2f} times its pixels' share; {row['window_peak_mib']:.0f} and {row['large_peak_mib']:.0f} MiB", flush=True)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
