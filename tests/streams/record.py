"""Records the call streams of this folder again: record.py [NAME ...]; needs an X server of its own (tests/doors/with_display.py).

Each program runs under apitrace until its image is there, and the trace is cut to its first frames. A stream is kept
only if it stays under a megabyte; values that a program took from clocks or random numbers are then fixed in the stream.
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "live"))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import models  # noqa: E402
import images  # noqa: E402
import programs  # noqa: E402
from command_line import Parser  # noqa: E402

SMALL = dict(around=120, across=14)
HACK_SIZE = ["--window", "--geometry", "400x400+20+20"]


def obj(folder):
    return str(models.write_obj(folder / "knot.obj", material=True, **SMALL))


def hack(name, *options):
    return lambda folder: [str(programs.HACKS / name), *HACK_SIZE, *options]


def planet(folder):
    """glplanet with a small map: its built-in ones are megabytes."""
    y, x = np.mgrid[0:64, 0:128]
    land = (np.sin(x / 9) + np.cos(y / 7) > 0.2)[:, :, None]
    images.write_png(folder / "map.png", np.where(land, (70, 140, 60), (40, 70, 160)).astype(np.uint8))
    return hack("glplanet", "--image", str(folder / "map.png"), "--image2", str(folder / "map.png"))(folder)


def osg(folder):
    return ["osgviewer", "--window", "20", "20", "400", "400", obj(folder)]


# name: the API traced, the command, the last frame kept, seconds until enough frames are drawn, its environment
STREAMS = {
    "glxgears": ("gl", lambda folder: ["glxgears", "-geometry", "400x400+20+20"], 4, 3, {}),
    "osgviewer_list": ("gl", osg, 3, 5, {}),
    "osgviewer_vbo": ("gl", osg, 3, 5, programs.VERTEX_BUFFERS),
    "geomview": ("gl", lambda folder: ["geomview", "-nopanels", "-wpos", "400,400", str(models.write_off(
        folder / "knot.off", around=60, across=10))], 3, 6, {}),
    "meshlab": ("gl", lambda folder: ["meshlab", str(models.write_ply(folder / "knot.ply", **SMALL))], 8, 15, {}),
    "g3dviewer": ("gl", lambda folder: ["g3dviewer", obj(folder)], 14, 6, {}),
    "openscad": ("gl", lambda folder: ["openscad", str(models.write_scad(folder / "csg.scad"))], 14, 10, {}),
    "ffmedit": ("gl", lambda folder: ["ffmedit", str(models.write_mesh(folder / "knot.mesh", **SMALL))], 4, 5, {}),
    "freefem": ("gl", lambda folder: ["FreeFem++", str(models.write_edp(folder / "plot.edp"))], 3, 8, {}),
    "sumo": ("gl", lambda folder: ["sumo-gui", "-n", str(models.write_road_net(folder / "net.xml")), "--start"], 9, 8, {}),
    "pyopengl": ("gl", lambda folder: ["/usr/bin/python3", str(HERE.parent / "live" / "pyopengl_scene.py")], 2, 5, {}),
    "drawxtl": ("gl", lambda folder: ["DRAWxtl55", str(models.copy_bucky(folder / "bucky.str"))], 4, 5, {}),
    "superquadrics": ("egl", hack("superquadrics"), 4, 3, {}),
    "glplanet": ("egl", planet, 4, 4, {}),
    "atlantis": ("egl", hack("atlantis"), 4, 4, {}),
    "gltext": ("egl", hack("gltext", "--text", "GLuRay"), 4, 4, {}),
    "pipes": ("egl", hack("pipes", "--factory", "0", "--count", "1"), 5, 4, {}),
}
# Programs with few draws are recorded as tests/live runs them.
STREAMS |= {name: ("gl", programs.MORE[name].command, last, 8, {}) for name, last in (
    ("v_sim", 4), ("pivy", 3), ("3depict", 5))}


def processes_of_group(leader):
    listed = subprocess.run(["ps", "-e", "-o", "pid=,pgid="], capture_output=True, text=True, check=True).stdout
    pairs = (map(int, line.split()) for line in listed.splitlines())
    return [process for process, group in pairs if group == leader and process != leader]


def record(name):
    api, command, last, seconds, environment = STREAMS[name]
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        raw = folder / "raw.trace"
        environment = dict(os.environ, HOME=place, QT_QPA_PLATFORM="xcb", LC_ALL="C", **environment)
        with open(folder / "log", "w+") as log:
            started = subprocess.Popen(["apitrace", "trace", "-a", api, "-o", str(raw), *command(folder)], env=environment,
                                       stdout=log, stderr=log, start_new_session=True)
            time.sleep(seconds)
            # Covers all windows for a moment, so that programs that draw on demand draw again.
            with subprocess.Popen(["xlogo", "-geometry", "1280x1024+0+0"]) as cover:
                time.sleep(1)
                cover.terminate()
            time.sleep(1)
            for child in processes_of_group(started.pid):
                os.kill(child, signal.SIGTERM)  # not apitrace, which would forward a second signal
            try:
                started.wait(5)
            except subprocess.TimeoutExpired:
                os.killpg(started.pid, signal.SIGKILL)
                started.wait()
        if not raw.exists() or raw.stat().st_size < 1000:
            return print(name, "left no trace:", (folder / "log").read_text()[-600:])
        kept = HERE / f"{name}.trace"
        trimmed = folder / "trimmed.trace"
        for step in (["trim", f"--frames=0-{last}", "-o", str(trimmed), str(raw)], ["repack", "--brotli", str(trimmed), str(kept)]):
            subprocess.run(["apitrace", *step], check=True, capture_output=True)
        print(name, f"{kept.stat().st_size / 1e6:.3f} of {raw.stat().st_size / 1e6:.3f} MB")


def main():
    parser = Parser(__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(STREAMS)} (all)")
    given = parser.parse_args()
    if unknown := [name for name in given.names if name not in STREAMS]:
        parser.error(f"no stream '{unknown[0]}'")
    for name in given.names or STREAMS:
        record(name)


if __name__ == "__main__":
    main()
