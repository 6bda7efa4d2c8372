#!/usr/bin/env python3
"""The demo: a head scan's surface in ParaView, with and without GLuRay; with --osg, in osgviewer.

Shows each version turning, writes both images and out/demo/side_by_side.png, and prints frames per second and what was
traced. osgviewer is given a mesh of the scan, which is kept in out/demo; ParaView makes its own.
"""
import argparse
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
from demo import camera_path  # noqa: E402
from support.display import NoDisplay, display  # noqa: E402
from support.options import Parser  # noqa: E402

WINDOW_CLASS = "osgViewer"
SIZE = 1024  # pixels, both ways
LOOPS = 2    # turns to watch; the first includes loading and building, the last is measured
PATIENCE = 300  # seconds after which a step is aborted


class Failed(RuntimeError):
    """A step of the demo failed."""


def say(text):
    print(f"demo: {text}", flush=True)


class Demo:
    def __init__(self, options):
        self.build = options.build
        self.gluray = [options.gluray or options.build / "apps" / "gluray" / "gluray"]
        self.volume, self.seconds = options.volume, options.seconds
        self.out = ROOT / "out" / "demo"
        self.mesh, self.path = self.out / "head.ply", self.out / "orbit.path"
        self.environment = dict(os.environ)

    def tool(self, name, *arguments):
        """Runs one of the benchmark's tools; its messages go through, its standard output is returned."""
        folder = name.replace("gluray-bench-", "")
        command = [str(self.build / "bench" / folder / name), *map(str, arguments)]
        if not pathlib.Path(command[0]).exists():
            raise Failed(f"{command[0]} is missing: run scripts/build release")
        done = subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise Failed(f"{name} failed")
        return done.stdout.strip()

    def make_mesh(self):
        self.out.mkdir(parents=True, exist_ok=True)
        recipe = self.out / "head.recipe"  # describes the input of the kept mesh
        wanted = f"{self.volume} isovalue 60 smooth 2\n"
        if not self.mesh.exists() or not recipe.exists() or recipe.read_text() != wanted:
            say(f"making the mesh of {self.volume}")
            say(self.tool("gluray-bench-mesh", "--volume", self.volume, "--isovalue", 60, "--smooth", 2, "--out",
                          self.mesh))
            recipe.write_text(wanted)
        self.path.write_text("\n".join(camera_path.orbit(*camera_path.ply_bounds(self.mesh), self.seconds)) + "\n")

    def viewer(self, launcher, *more):
        """Starts osgviewer under `launcher` (nothing: plain). Returns the process and the end of the terminal it writes
        to (to a pipe or a file it would write its lines minutes late); `stop` ends both."""
        command = [*map(str, launcher), "osgviewer", "--window", "50", "50", str(SIZE), str(SIZE), "--run-continuous",
                   *map(str, more), str(self.mesh)]
        ours, theirs = os.openpty()
        os.set_blocking(ours, False)
        viewer = subprocess.Popen(command, env=self.environment, stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs,
                                  start_new_session=True)
        os.close(theirs)
        return viewer, ours

    def stop(self, viewer, terminal):
        """Closes the viewer's window and waits; kills a viewer that does not react, with its child processes."""
        try:
            if viewer.poll() is None:
                self.tool("gluray-bench-picture", "close", "--class", WINDOW_CLASS)
            viewer.wait(timeout=30)
        except (Failed, subprocess.TimeoutExpired):
            os.killpg(viewer.pid, signal.SIGKILL)
            viewer.wait()
        finally:
            os.close(terminal)

    def turning_fps(self, launcher):
        """Frames a second of the last of LOOPS turns, as osgviewer counts them."""
        viewer, terminal = self.viewer(launcher, "-p", self.path)
        text = ""
        try:
            end = time.monotonic() + PATIENCE
            while time.monotonic() < end:
                time.sleep(0.2)
                text += read_all(terminal)
                turns = re.findall(r"average frame rate = ([0-9.eE+]+)\s", text)
                if len(turns) >= LOOPS:
                    return float(turns[LOOPS - 1])
                if viewer.poll() is not None:
                    raise Failed(f"osgviewer ended early (exit code {viewer.returncode}):\n{text.strip()}")
            raise Failed(f"osgviewer did not turn the head {LOOPS} times in {PATIENCE} s")
        finally:
            self.stop(viewer, terminal)

    def image(self, launcher, file):
        """Writes the viewer's image at rest."""
        viewer, terminal = self.viewer(launcher)
        try:
            self.tool("gluray-bench-picture", "grab", "--class", WINDOW_CLASS, "--out", file, "--patience", PATIENCE)
        finally:
            self.stop(viewer, terminal)

    def run(self):
        if not pathlib.Path(self.gluray[0]).exists():
            raise Failed(f"{self.gluray[0]} is missing: run scripts/build release")
        self.make_mesh()
        with display() as name:
            self.environment["DISPLAY"] = name
            say(f"plain OpenGL on display {name}: the head turns {LOOPS} times")
            plain = self.turning_fps([])
            self.image([], self.out / "opengl.png")
            say(f"GLuRay: the head turns {LOOPS} times")
            report = self.out / "report.json"
            report.unlink(missing_ok=True)
            traced = self.turning_fps([*self.gluray, "--report", report, "--"])
            self.image([*self.gluray, "--"], self.out / "gluray.png")
        both = self.out / "side_by_side.png"
        self.tool("gluray-bench-picture", "beside", self.out / "opengl.png", self.out / "gluray.png", "--out", both)
        print_result(plain, traced, report)
        print(f"  images              {both.relative_to(ROOT)} (left OpenGL, right GLuRay)")


def read_all(terminal):
    """The output to a terminal since the last call; empty once its last writer is gone."""
    text = b""
    try:
        while chunk := os.read(terminal, 65536):
            text += chunk
    except OSError:  # no more output, now or ever
        pass
    return text.decode(errors="replace")


def print_result(plain, traced, report_file):
    print(f"\n  OpenGL                {plain:8.2f} frames a second")
    print(f"  GLuRay                {traced:8.2f} frames a second, {traced / plain:.1f} times as many")
    if not report_file.exists():
        print("  GLuRay wrote no report: the image came from the real OpenGL")
        return
    report = json.loads(report_file.read_text())
    draws, triangles, bvh = (report.get(key, {}) for key in ("draws", "triangles", "bvh"))
    print(f"  frames                {report.get('frames', 0):8}")
    print(f"  draws traced          {draws.get('traced', 0):8}, triangles {triangles.get('traced', 0):,}")
    print(f"  draws left to OpenGL  {sum(draws.get('rasterised', {}).values()):8}, "
          f"triangles {triangles.get('rasterised', 0):,}")
    for reason, count in sorted(draws.get("rasterised", {}).items()):
        print(f"    {reason}: {count}")
    print(f"  acceleration          {bvh.get('builds', 0):8} builds, {bvh.get('bytes', 0) / 1e6:.0f} MB")
    # Programs that draw into memory show no frames: counts their images instead.
    unshown = report.get("frames", 0) <= 1 and report.get("flushes", 0) > 1
    share = 1 / report["flushes"] if unshown else 1
    milliseconds = ", ".join(f"{part} {value * share:.2f}" for part, value in report.get("ms", {}).items())
    print(f"  ms a {'image  ' if unshown else 'frame  '}          {milliseconds}")


def main():
    parser = Parser(__doc__, prog="scripts/demo")
    parser.add_argument("--osg", action="store_true", help="osgviewer instead of ParaView (display lists, fixed function)")
    parser.add_argument("--gui", action="store_true", help="open the ParaView window as well")
    parser.add_argument("--volume", default="/usr/share/mricron/templates/ch2better.nii.gz", help="NIfTI-1 head scan")
    parser.add_argument("--seconds", type=float, default=6, help="time of one turn of osgviewer")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--gluray", type=pathlib.Path, help="launcher to use instead of the build folder's")
    parser.add_argument("--check-options", action="store_true", help=argparse.SUPPRESS)  # for scripts/demo, before it builds
    options = parser.parse_args()
    if options.check_options:
        return 0
    try:
        if options.osg:
            Demo(options).run()
        else:
            from demo.paraview_show import ParaViewDemo  # it uses this file's functions
            ParaViewDemo(options).run()
    except (Failed, NoDisplay) as error:
        print(f"demo: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
