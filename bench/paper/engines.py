"""The engines that are measured side by side, and how to start a row's program with each."""
import os
import pathlib
import re
import shutil
import subprocess

from paper import plan
from support import programs

HERE = pathlib.Path(__file__).resolve().parent
SOFTWARE = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe", "__GLX_VENDOR_LIBRARY_NAME": "mesa"}
NAMES = ("gluray", "auto", "mesa1", "mesa", "gpu")
TITLES = {"gluray": "GLuRay", "auto": "GLuRay, engine auto", "mesa1": "Mesa, 1 thread", "mesa": "Mesa, all threads", "gpu": "GPU"}
SOFTWARE_RENDERERS = ("llvmpipe", "softpipe", "swr", "software rasterizer", "swiftshader")


def gpu_renderer(display_name):
    """(name of the OpenGL on the display where a GPU draws, None), or (None, why there is none)."""
    if not shutil.which("glxinfo"):
        return None, "glxinfo is missing (package mesa-utils)"
    try:
        said = subprocess.run(["glxinfo", "-B"], env={**os.environ, "DISPLAY": display_name}, text=True, capture_output=True, timeout=60)
    except subprocess.TimeoutExpired:
        return None, "glxinfo does not answer"
    match = re.search(r"^OpenGL renderer string:\s*(.+)$", said.stdout, re.MULTILINE)
    if not match:
        return None, "glxinfo names no renderer"
    if any(name in match[1].lower() for name in SOFTWARE_RENDERERS):
        return None, f"the display's OpenGL is {match[1]}"
    return match[1], None


class Engines:
    """`options`: build, threads, size of the measured run."""

    def __init__(self, options, display_name, data_folder):
        self.options, self.display, self.data = options, display_name, data_folder
        self.gluray = options.build / "apps" / "gluray" / "gluray"
        self.client = options.build / "bench" / "client" / "gluray-bench-client"

    def needed(self):
        """Files that must have been built."""
        return [self.gluray, self.client, self.options.build / "bench" / "paper" / "gluray-bench-paper-data",
                self.options.build / "lib" / "gluray" / "libgluray-engine.so"]

    def mesh_file(self, row):
        return self.data / f"{row.data}-{row.millions:g}.mesh"

    def command(self, row, frames, seconds, warm):
        """The row's program, measuring as many frames as take so many seconds."""
        rest = ["--mesh", self.mesh_file(row), "--distance", row.distance, "--frames", frames, "--seconds", seconds, "--warm", warm]
        if row.program == "client":
            return [self.client, "--path", row.path, "--orbit", *rest]
        program = {"ParaView": ["pvbatch", HERE / "paraview_program.py"], "VTK": ["/usr/bin/python3", HERE / "vtk_program.py"]}
        return [*program[row.program], *rest]

    def environment(self, engine):
        # LP_NUM_THREADS=0: llvmpipe draws on the program's own thread; 1 would give it one more beside that.
        threads = "0" if engine == "mesa1" else str(self.options.threads)
        software = SOFTWARE if engine in ("mesa1", "mesa") else {}
        return {"DISPLAY": self.display, "LP_NUM_THREADS": threads, **software}

    def measure(self, row, engine):
        options = self.options
        if engine in ("gluray", "auto"):
            command = self.command(row, options.frames, options.seconds, plan.warm_seconds(row.millions))
            return programs.measure_with_gluray(self.gluray, ["--threads", options.threads], command, self.environment(engine),
                                                "always" if engine == "gluray" else "auto", options.timeout)
        return programs.measure(self.command(row, options.frames, options.seconds, 0), self.environment(engine), options.timeout)

    def measure_build(self, row, quality):
        """Seconds that GLuRay spends on acceleration structures until the first image."""
        out = programs.measure_with_gluray(self.gluray, ["--threads", self.options.threads, "--bvh", quality], self.command(row, 1, 0, 0),
                                           self.environment("gluray"), timeout=self.options.timeout)
        report = out["report"] or {}
        if report.get("bvh", {}).get("builds", 0) < 1:
            raise programs.Failed(f"{row.name}: GLuRay built nothing")
        return {"build_s": report["ms"]["build"] * report["frames"] / 1000, "first_image_s": out["first_image_s"],
                "triangles": out["triangles"], "bvh_bytes": report["bvh"]["bytes"]}

    def draw_timeline(self, row, folder, chart):
        """One run of the row's program, drawn as the paper's Figure 9: what each thread did in the whole run, and a close-up."""
        file = folder / "timeline.json"
        command = [self.gluray, "--engine", "always", "--threads", self.options.threads, "--timeline", file, "--",
                   *self.command(row, 30, 2, 0)]
        for line in (command, [self.gluray, "timeline", file, "-o", chart]):
            code, out, err = programs.run(line, self.environment("gluray"), self.options.timeout)
            if code != 0:
                raise programs.Failed(f"exit code {code}: {' '.join(map(str, line))}\n{out}{err}")
        file.unlink()
        return out
