"""The demo in ParaView: a head scan's isosurface, with and without GLuRay.

Runs pvbatch on the scan twice, the camera in orbit, writes both images and out/demo/side_by_side.png, and prints frames per
second and how much was traced. With --gui also opens the ParaView window on it, under GLuRay.
"""
import json
import os
import pathlib
import shutil
import subprocess

from demo.show import Failed, ROOT, print_result, say
from support.display import display

SYSTEM_PYTHON = "/usr/bin/python3"  # the one for which ParaView's numpy is built
FRAMES = {"plain": 10, "traced": 40}


class ParaViewDemo:
    def __init__(self, options):
        self.build = options.build
        self.gluray = options.gluray or options.build / "apps" / "gluray" / "gluray"
        self.volume, self.gui = options.volume, options.gui
        self.out = ROOT / "out" / "demo"
        self.scan = self.out / "head.mhd"
        self.environment = dict(os.environ)

    def convert(self):
        """Converts the NIfTI scan to MetaImage, which ParaView reads without plugins."""
        self.out.mkdir(parents=True, exist_ok=True)
        if self.scan.exists() and self.scan.stat().st_mtime > pathlib.Path(self.volume).stat().st_mtime:
            return
        say(f"reading {self.volume}")
        done = subprocess.run([SYSTEM_PYTHON, ROOT / "bench" / "support" / "nifti.py", self.volume, self.scan])
        if done.returncode != 0:
            raise Failed(f"{self.volume} could not be read")

    def orbit(self, launcher, frames, image):
        """Turns the head in pvbatch; returns the script's measurements."""
        command = [*map(str, launcher), "pvbatch", str(ROOT / "bench" / "support" / "paraview_orbit.py"), "60", str(frames),
                   "1024", str(image), str(self.scan)]
        done = subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        if done.returncode != 0 or not lines:
            raise Failed(f"pvbatch ended with exit code {done.returncode}:\n{done.stderr.strip()[-2000:]}")
        return json.loads(lines[-1])

    def beside(self, left, right, both):
        tool = self.build / "bench" / "picture" / "gluray-bench-picture"
        subprocess.run([tool, "beside", left, right, "--out", both], check=True, stdout=subprocess.DEVNULL)

    def run(self):
        for program, package in (("pvbatch", "python3-paraview"), (str(self.gluray), "")):
            if not shutil.which(program):
                raise Failed(f"{program} is missing: " + (f"install {package}" if package else "run scripts/build release"))
        self.convert()
        with display() as name:
            self.environment["DISPLAY"] = name
            say(f"ParaView with plain OpenGL on display {name}")
            plain = self.orbit([], FRAMES["plain"], self.out / "opengl.png")
            say("ParaView with GLuRay")
            report = self.out / "report.json"
            report.unlink(missing_ok=True)
            traced = self.orbit([self.gluray, "--report", report, "--"], FRAMES["traced"], self.out / "gluray.png")
            both = self.out / "side_by_side.png"
            self.beside(self.out / "opengl.png", self.out / "gluray.png", both)
            print(f"\n  triangles             {plain['triangles']:,}")
            print(f"  first image         {plain['first_image_s']:.2f} s with OpenGL, "
                  f"{traced['first_image_s']:.2f} s with GLuRay")
            print_result(1 / plain["frame_s"], 1 / traced["frame_s"], report)
            print(f"  images              {both.relative_to(ROOT)} (left OpenGL, right GLuRay)")
            if self.gui:
                say("the ParaView window; close it to end the demo")
                subprocess.run([self.gluray, "--", "paraview", f"--data={self.scan}"], env=self.environment)
