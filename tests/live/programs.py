"""The real programs that are run with and without GLuRay, and how alike their pictures must be.

A tolerance is a pair: the largest difference (of 255) off edges, and the share of the window's pixels that may differ
by more than 2 of 255 off edges. Edges (pixels.edges) are judged by the eye, because one pixel of coverage more or less
there is within what OpenGL leaves open (GL 2.1, 3.5.1); their share is printed.
"""
import dataclasses
import pathlib
import shutil
import subprocess

import models

HACKS = pathlib.Path("/usr/libexec/xscreensaver")
HERE = pathlib.Path(__file__).parent


@dataclasses.dataclass
class Program:
    command: callable            # folder -> the words of the command line
    reason: str                  # why its tolerance is what it is
    largest: int = 2             # of 255, off edges
    beyond: float = 0.0          # share of pixels beyond 2/255 off edges
    beyond_all: float = 0.02     # the same, edges included
    traced: float = 0.99         # least share of triangles that are traced
    frame: int = 0               # the swap whose picture is compared, with time standing still; 0: the picture at rest
    rest: float = 2.0            # seconds without a change that count as rest
    colors: int = 64             # a picture with fewer has not loaded its model yet
    environment: dict = dataclasses.field(default_factory=dict)


def osgviewer(name, material=True):
    return lambda folder: ["osgviewer", "--window", "20", "20", "600", "600",
                           str(models.write_obj(folder / f"{name}.obj", material))]


def hack(name, *options):
    return lambda folder: [str(HACKS / name), "--window", "--geometry", "600x600+20+20", *options]


VERTEX_BUFFERS = {"OSG_VERTEX_BUFFER_HINT": "VERTEX_BUFFER_OBJECT"}

PROGRAMS = {
    "glxgears": Program(lambda folder: ["glxgears", "-geometry", "600x600+20+20"], "lighting at the vertices", frame=20),
    "osgviewer_list": Program(osgviewer("knot"), "lighting at the vertices"),
    "osgviewer_vbo": Program(osgviewer("knot"), "lighting at the vertices", environment=VERTEX_BUFFERS),
    "osgviewer_plain": Program(osgviewer("plain", material=False), "no material file, see src/gl/material_latch.h"),
    "osgviewer_plain_vbo": Program(osgviewer("plain", material=False), "the same", environment=VERTEX_BUFFERS),
    "geomview": Program(lambda folder: ["geomview", "-nopanels", "-wpos", "600,500", str(models.write_off(
        folder / "knot.off", around=150, across=20))], "flat facets: steps between them are edges too, though weaker "
                        "than what counts as one", beyond=1e-4),
    "meshlab": Program(lambda folder: ["meshlab", str(models.write_ply(folder / "knot.ply"))], "lighting at the vertices; its window "
                       "shows frame rates and times as text, and paints a backdrop", traced=0.95, rest=4.0, colors=800),
    "superquadrics": Program(hack("superquadrics"), "lighting at the vertices", frame=40),
    "molecule": Program(hack("molecule", "--no-shells", "--no-labels"), "lighting at the vertices", frame=40),
    "pyopengl": Program(lambda folder: ["/usr/bin/python3", str(HERE / "pyopengl_scene.py")], "lighting at the vertices"),
}


def missing(command):
    """Why the command cannot run here, or None."""
    if not shutil.which(command[0]):
        return f"{command[0]} is not installed"
    if command[0] == "/usr/bin/python3":
        probe = subprocess.run([command[0], "-c", "import OpenGL.GLUT, numpy"], capture_output=True)
        return "python3-opengl or python3-numpy is not installed" if probe.returncode else None
    return None
