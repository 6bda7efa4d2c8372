"""The real programs that are run with and without GLuRay, and the tolerances of their images.

A tolerance is a pair: the largest difference (of 255) off edges, and the share of the window's pixels that may differ
by more than 2 of 255 off edges. Edges (pixels.edges) are judged visually, because OpenGL allows one pixel of coverage more or less
there (GL 2.1, 3.5.1); their share is printed.
"""
import dataclasses
import os
import pathlib
import shutil
import subprocess

import gltf
import models

HACKS = pathlib.Path("/usr/libexec/xscreensaver")
HERE = pathlib.Path(__file__).resolve().parent
HOME = os.path.expanduser("~")  # programs run with another home


@dataclasses.dataclass
class Program:
    command: callable            # folder -> the command line, as a list
    reason: str                  # reason for its tolerance
    largest: int = 2             # of 255, off edges
    beyond: float = 0.0          # share of pixels beyond 2/255 off edges
    beyond_all: float = 0.02     # the same, edges included
    traced: float = 0.99         # least share of triangles that are traced
    visible: float = 0.005       # share of pixels that may differ by more than 8/255
    exact: bool = False          # no pixel may differ at all: the real OpenGL draws all of it
    culled: int = 0              # least number of culled draws (docs/culling.md)
    frame: int = 0               # the swap whose image is compared, with a fixed clock; 0: the image at rest
    rest: float = 2.0            # seconds without a change that count as rest
    colors: int = 64             # an image with fewer has not loaded its model yet
    environment: dict = dataclasses.field(default_factory=dict)
    needs: tuple = ()            # programs and files that the command needs, beside its first word


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
    "osgviewer_plain": Program(osgviewer("plain", material=False), "no material file, see src/gl/shadow/material_latch.h"),
    "osgviewer_plain_vbo": Program(osgviewer("plain", material=False), "the same", environment=VERTEX_BUFFERS),
    "geomview": Program(lambda folder: ["geomview", "-nopanels", "-wpos", "600,500", str(models.write_off(
        folder / "knot.off", around=150, across=20))], "flat facets: steps between them are edges too, though weaker "
                        "than what counts as one", beyond=1e-4),
    "meshlab": Program(lambda folder: ["meshlab", str(models.write_ply(folder / "knot.ply"))], "flat facets, as above; its window "
                       "shows frame rates and times as text, and paints a backdrop", beyond=1e-4, traced=0.95, rest=4.0, colors=800),
    "superquadrics": Program(hack("superquadrics"), "lighting at the vertices", frame=40),
    "molecule": Program(hack("molecule", "--no-shells", "--no-labels"), "lighting at the vertices", frame=40),
    "pyopengl": Program(lambda folder: ["/usr/bin/python3", str(HERE / "pyopengl_scene.py")], "lighting at the vertices"),
}

# Programs of the distribution, many toolkits. Only `visible` is checked: their windows hold text, lines and faint edges.
# `traced` is the least share of all their triangles; docs/programs.md says which are not opaque.


def wide(command, reason, traced, **more):
    return Program(command, reason, largest=255, beyond=1.0, beyond_all=1.0, traced=traced, **more)


SMALL = dict(around=300, across=32)


def openscad(folder):
    """Hides the editor, because its cursor blinks."""
    settings = folder / ".config" / "OpenSCAD" / "OpenSCAD.conf"
    settings.parent.mkdir(parents=True)
    settings.write_text("[view]\nhideEditor=true\nhideConsole=true\nhideCustomizer=true\nhideErrorLog=true\n")
    return ["openscad", str(models.write_scad(folder / "csg.scad"))]


def medit(folder):
    (folder / "knot.medit").write_text("backgroundcolor\n1 1 1\nrendermode\nshading\n")
    return ["ffmedit", str(models.write_mesh(folder / "knot.mesh", **SMALL))]


def mayavi(folder):
    """Uses an unpacked copy, because its package conflicts with ParaView's VTK."""
    script = ["/usr/bin/python3", str(HERE / "mayavi_scene.py")]
    if shutil.which("mayavi2"):
        return script
    unpacked = subprocess.run([str(HERE / "unpack_mayavi2")], capture_output=True, text=True, env=dict(os.environ, HOME=HOME))
    if unpacked.returncode:
        print(unpacked.stderr.strip())
        return ["mayavi2"]
    return ["env", f"PYTHONPATH={unpacked.stdout.strip()}", *script]


def pymol(folder, scene="pymol_scene.py"):
    return ["/usr/bin/python3", "-m", "pymol.__init__", "-q", "-x", "-i", "-W", "600", "-H", "600", str(HERE / scene)]


def pymol_sticks(folder):
    return pymol(folder, "pymol_sticks_scene.py")


def f3d(folder, model=None):
    """Without configuration files; the option has two names."""
    own_look = "--no-config" if "--no-config" in subprocess.run(["f3d", "--help"], capture_output=True, text=True).stdout else "--dry-run"
    return ["f3d", own_look, "--resolution=600,600", str(model or models.write_ply(folder / "knot.ply", **SMALL))]


def f3d_textured(folder):
    return f3d(folder, gltf.write(folder / "knot.gltf"))


def whole(command, reason, culled=0, environment=None, **more):
    """A program that the real OpenGL draws, with its own shaders: culled wherever that is exact, however small its draws are."""
    everything = {"GLURAY_CULL_DRAWS": "always", "GLURAY_CULL_FROM": "1"}
    return Program(command, reason, traced=0.0, exact=True, culled=culled, environment=everything | (environment or {}), **more)


def script(name):
    return lambda folder: ["/usr/bin/python3", str(HERE / name)]


def module(name):
    return f"/usr/lib/python3/dist-packages/{name}"


PIVY = "/usr/share/doc/python3-pivy/examples/Mentor/02.4.Examiner.py"

MORE = {
    "g3dviewer": wide(lambda folder: ["g3dviewer", str(models.write_obj(folder / "knot.obj", True))], "GTK 2, lists", 0.99),
    "openscad": wide(openscad, "Qt 5; CSG in passes with a stencil", 0.0, rest=3.0),
    "ffmedit": wide(medit, "GLUT; a second pass as wireframe", 0.49),
    "freefem": wide(lambda folder: ["FreeFem++", str(models.write_edp(folder / "plot.edp"))], "GLUT", 0.98, colors=10),
    "sumo": wide(lambda folder: ["sumo-gui", "-n", str(models.write_road_net(folder / "net.xml"))], "FOX; flat layers", 0.0,
                 needs=("netgenerate",)),
    "dangerball": wide(hack("dangerball"), "lists", 1.0, frame=20),
    "glplanet": wide(hack("glplanet"), "EGL; day and night in other channels, atmosphere blended", 0.66, frame=20),
    "atlantis": wide(hack("atlantis"), "immediate mode, texture coordinate generation", 0.9, frame=20),
    "gltext": wide(hack("gltext", "--text", "GLuRay"), "immediate mode", 1.0, frame=60),
    "pipes": wide(hack("pipes"), "lists, drawn over several frames", 1.0, frame=20),
    "hilbert": wide(hack("hilbert"), "lists", 1.0, frame=20),
    "mm3d": wide(lambda folder: ["mm3d", str(models.write_obj(folder / "knot.obj", True))], "Qt 5, four views", 0.99, rest=3.0),
    "gdis": wide(lambda folder: ["gdis", str(models.write_xyz(folder / "ball.xyz"))], "GTK 2", 0.99, rest=3.0),
    "drawxtl": wide(lambda folder: ["DRAWxtl55", str(models.copy_bucky(folder / "bucky.str"))], "FLTK; names in lists", 1.0,
                    needs=(models.BUCKY,)),
    "evolver": wide(lambda folder: ["sh", "-c", f"(cat {models.write_evolver(folder / 'cube.fe')[1]}; sleep 100) | "
                    f"evolver-ogl-d {folder / 'cube.fe'}"], "GLUT", 1.0, colors=8, needs=("evolver-ogl-d",)),
    "gmsh": wide(lambda folder: ["gmsh", "-nopopup", "-setnumber", "Mesh.SurfaceFaces", "1", "-setnumber", "Mesh.SurfaceEdges", "0",
                 str(models.write_stl(folder / "knot.stl", **SMALL))], "FLTK, client arrays", 0.99, rest=3.0),
    "xcrysden": wide(lambda folder: ["xcrysden", "--xsf", str(models.write_xsf(folder / "salt.xsf"))], "Tk", 1.0, rest=4.0),
    "v_sim": wide(lambda folder: ["v_sim", str(models.write_v_sim(folder / "grid.ascii"))], "GTK 3; fog", 0.9, rest=4.0),
    "pivy": wide(lambda folder: ["/usr/bin/python3", PIVY], "Coin, Qt 5", 1.0, rest=3.0, colors=20, needs=(PIVY,)),
    "3depict": wide(lambda folder: ["3depict"], "wxWidgets", 1.0, rest=4.0),
    "billard": wide(lambda folder: ["/usr/games/billard-gl"], "GLUT; title, drawn without depth test", 0.0, frame=30),
    "glxheads": wide(lambda folder: ["glxheads"], "Xlib alone; one flat triangle, no depth test", 0.0, frame=20, colors=2),
    "f3d": wide(f3d, "VTK 9; physically based, no toolkit; later versions draw full-screen quads in every frame", 0.98, rest=3.0, environment={"GLURAY_ENGINE": "always"}, needs=("f3d",)),
    "f3d_textured": wide(f3d_textured, "the same with the textures and the normal map of a glTF file, which are filtered anisotropically", 0.98, rest=3.0,
                         environment={"GLURAY_ENGINE": "always"}, needs=("f3d",)),
    "mayavi2": wide(mayavi, "VTK 9 from Python; what it does not trace are its colour bar and full-screen passes", 0.97, rest=4.0),
    "avogadro": wide(lambda folder: ["avogadro2", str(models.write_xyz(folder / "ball.xyz"))], "Qt 5; half spheres and meshes of shaders of its own; the rest are the arrows of its axes, blended with four samples a pixel", 0.8,
                     rest=4.0),
    "avogadro_protein": wide(lambda folder: ["avogadro2", str(models.write_helix_pdb(folder / "helix.pdb"))], "the same with the cartoon of a protein", 0.93,
                             rest=4.0),
    "openuniverse": wide(lambda folder: ["openuniverse"], "GLUT; drawn without depth test", 0.0, frame=30),
    "ctmviewer": wide(lambda folder: ["ctmviewer", str(models.write_ply(folder / "knot.ply", **SMALL))],
                      "GLUT; GLSL 1.10 that takes fixed function's state; buttons without depth test", 0.99),
    "ctmviewer_textured": wide(lambda folder: ["ctmviewer", str(models.write_ctm(folder / "knot.ctm", **SMALL))],
                               "the same with a mesh's own image", 0.99),
    "pyqtgraph": wide(script("pyqtgraph_scene.py"), "Qt 5; GLSL 1.10 that takes fixed function's arrays", 0.99, rest=3.0,
                      needs=(module("pyqtgraph"),)),
    "pymol": wide(pymol, "Qt 5; GLSL 1.20, a depth cue; sticks are impostors", 0.98, rest=4.0, needs=("pymol",)),
    "pymol_clear": wide(pymol, "the same without depth cue", 0.98, rest=4.0, needs=("pymol",), environment={"LIVE_DEPTH_CUE": "0"}),
    "pymol_sticks": wide(pymol_sticks, "spheres and sticks as impostors, whose billboards it sends; few triangles beside its text",
                         0.85, rest=4.0, needs=("pymol",)),
    "pymol_ortho": wide(pymol_sticks, "the same, seen in parallel, with smaller balls, four lights and no depth cue", 0.9, rest=4.0,
                        needs=("pymol",), environment={"PYMOL_SETTINGS": "ortho 1,depth_cue 0,stick_ball 1,light_count 4"}),
    "pymol_translucent": wide(pymol_sticks, "translucent spheres and sticks, two lights of four without highlights", 0.85, rest=4.0,
                              needs=("pymol",), environment={"PYMOL_SETTINGS": "sphere_transparency 0.4,stick_transparency 0.5,light_count 4,spec_count 1"}),
    # Shaders of their own.
    "vispy": whole(script("vispy_scene.py"), "Qt 5, a framebuffer object; blending", culled=10, rest=3.0, needs=(module("vispy"),)),
    "silx": whole(script("silx_scene.py"), "Qt 5; blending", culled=5, rest=3.0, needs=(module("silx"),)),
    "view3dscene": whole(lambda folder: ["view3dscene", "--geometry", "600x600", "-H", str(models.write_x3d(folder / "knot.x3dv"))],
                         "GTK 2; one light", culled=2, rest=3.0),
    "solvespace": whole(lambda folder: ["solvespace", str(models.write_slvs(folder / "knot.slvs", **SMALL))],
                        "GTK 3; its shaders take no lights of OpenGL", culled=1, rest=4.0, environment={"LC_ALL": "C.UTF-8"}),
    "mrview": whole(lambda folder: ["mrview", str(models.write_mif(folder / "ball.mif")), "-mode", "3", "-size", "600,600"],
                    "Qt 5; a volume that a fragment shader walks through", rest=4.0),
    "wings3d": whole(lambda folder: ["wings3d"], "wxWidgets; a grid that a shader makes of a rectangle", rest=4.0),
    "blender": whole(lambda folder: ["blender", "--factory-startup", "--window-geometry", "20", "20", "900", "700", "--python",
                     str(HERE / "blender_scene.py")], "core profile; several draw buffers, base instances", rest=6.0),
}


def missing(program, folder):
    """Why the program cannot run here, or None. Its command may write into the folder."""
    for need in program.needs:
        if not (shutil.which(need) or os.path.exists(need)):
            return f"{need} is not installed"
    command = program.command(folder)
    if not shutil.which(command[0]):
        return f"{command[0]} is not installed"
    if command[0] == "/usr/bin/python3":
        probe = subprocess.run([command[0], "-c", "import OpenGL.GLUT, numpy"], capture_output=True)
        return "python3-opengl or python3-numpy is not installed" if probe.returncode else None
    return None
