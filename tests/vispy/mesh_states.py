"""Meshes of vispy's scene graph, each as one picture.

mesh_states.py GROUP FILE [STATE ...]  draws the states of a group, "traced" or "untraced", into a file of numpy
"""
import numpy as np
from drawing import main
from vispy import scene
from vispy.geometry import create_sphere
from vispy.visuals import filters

ORANGE = (0.9, 0.6, 0.3, 1)


def camera(view, kind, **keys):
    chosen = {"turntable": scene.TurntableCamera, "arcball": scene.ArcballCamera, "panzoom": scene.PanZoomCamera}[kind]
    if kind == "panzoom":
        view.camera = chosen(rect=(-1.6, -1.4, 3.2, 2.8))
        return
    view.camera = chosen(**{"fov": 45, "distance": 4} | ({"azimuth": 30, "elevation": 25} if kind == "turntable" else {}) | keys)


def colors_of(data, which):
    if which == "vertices":
        points = data.get_vertices()
        return {"vertex_colors": np.c_[0.5 + 0.5 * points, np.ones(len(points))]}
    if which == "faces":
        return {"face_colors": np.c_[np.random.default_rng(5).random((data.n_faces, 3)), np.ones(data.n_faces)]}
    return {"color": ORANGE}


def ball(shading=None, colors="", rows=40, moved=None, seen="turntable", view=None, lit=None, opacity=None, after=None, **more):
    """A sphere. `lit`: values of its filter; `after`: called with it."""
    def draw(canvas, of):
        data = create_sphere(rows, rows, radius=1)
        keys = {"shading": shading} if shading else {}
        made = scene.visuals.Mesh(data.get_vertices(), data.get_faces(), parent=of.scene, **keys, **colors_of(data, colors), **more)
        if moved:
            made.transform = moved()
        for name, value in (lit or {}).items():
            setattr(made.shading_filter, name, value)
        if opacity:
            made.opacity = opacity
        if after:
            after(made)
        camera(of, seen, **(view or {}))
    return draw


def box(shading=None, view=None, lit=None, seen="turntable", **keys):
    def draw(canvas, of):
        made = scene.visuals.Box(2.2, 1.6, 1.2, parent=of.scene, **keys)
        if shading:
            made.mesh.shading = shading
        for name, value in (lit or {}).items():
            setattr(made.mesh.shading_filter, name, value)
        camera(of, seen, **(view or {}))
    return draw


def surface(shading, **keys):
    def draw(canvas, of):
        x, y = np.meshgrid(np.linspace(-1.5, 1.5, 40), np.linspace(-1.5, 1.5, 40), indexing="ij")
        scene.visuals.SurfacePlot(x[:, 0], y[0], 0.3 * np.sin(4 * x) * np.cos(3 * y), shading=shading, parent=of.scene, **keys)
        camera(of, "turntable")
    return draw


def two_balls(canvas, of):
    """One ball cuts the other one."""
    ball("smooth")(canvas, of)
    ball("smooth", "vertices", moved=lambda: scene.transforms.STTransform(translate=(0.7, 0.4, 0.2)))(canvas, of)


def sphere(shading=None):
    """`shading`: of the constructor, whose filter gets no transforms of the scene."""
    def draw(canvas, of):
        made = scene.visuals.Sphere(radius=1, method="ico", subdivisions=4, shading=shading, color=ORANGE, parent=of.scene)
        if not shading:
            made.mesh.shading = "smooth"
        camera(of, "turntable")
    return draw


def cube(canvas, of):
    scene.visuals.Cube(1.6, color=ORANGE, parent=of.scene)
    camera(of, "turntable")


def stretched():
    return scene.transforms.STTransform(scale=(1, 0.6, 1.3), translate=(0.2, 0.1, -0.3))


def turned():
    made = scene.transforms.MatrixTransform()
    made.rotate(40, (1, 2, 0.5))
    made.translate((0.3, 0, 0.2))
    return made


def filtered(mesh):
    mesh.attach(filters.ShadingFilter(shading="smooth", shininess=20))


def outlined(mesh):
    mesh.attach(filters.WireframeFilter(width=2))


LAMPS = {"light_dir": (-3, 4, -6), "ambient_light": (1, 0.4, 0.2, 0.4), "diffuse_light": (0.3, 1, 0.8, 0.6), "specular_light": (1, 1, 0, 0.8),
         "ambient_coefficient": (0.5, 1, 1, 0.9), "diffuse_coefficient": (1, 0.9, 0.3, 0.8), "specular_coefficient": (0.2, 0.9, 1, 0.9), "shininess": 12.5}
GLOSSY = {"light_dir": (-2, 3, -2), "specular_light": (1, 1, 1, 1), "shininess": 8, "ambient_light": (1, 1, 1, 0.1)}
DULL = {"light_dir": (-2, 3, -2), "specular_light": (0, 0, 0, 1)}
PARALLEL = {"fov": 0}

# Those of every version.
STATES = {"unlit": ball(), "unlit, vertices": ball(colors="vertices"), "unlit, faces": ball(colors="faces"), "unlit, moved": ball(colors="faces", moved=stretched),
          "unlit, parallel": ball(colors="vertices", view=PARALLEL), "unlit, translucent": ball(colors="vertices", opacity=0.6), "box": box(color=ORANGE),
          "arcball": ball(colors="vertices", seen="arcball"), "cube": cube}
# Those of 0.14 and later. In the plane of panzoom the sphere is flat in depth buffers of 16 bits, and traced in the window.
NEWER = {"smooth": ball("smooth"), "smooth, vertices": ball("smooth", "vertices"), "smooth, faces": ball("smooth", "faces"), "smooth, moved": ball("smooth", moved=stretched),
         "smooth, turned": ball("smooth", moved=turned), "smooth, parallel": ball("smooth", view=PARALLEL), "smooth, translucent": ball("smooth", opacity=0.5),
         "smooth, lamps": ball("smooth", lit=LAMPS), "smooth, lamps, parallel": ball("smooth", "vertices", lit=LAMPS, view=PARALLEL),
         "smooth, no shininess": ball("smooth", lit={"shininess": 0}), "smooth, off": ball("smooth", lit={"enabled": False}),
         "flat": ball("flat"), "flat, faces": ball("flat", "faces"), "flat, moved": ball("flat", moved=stretched), "flat, turned": ball("flat", moved=turned), "flat, parallel": ball("flat", view=PARALLEL),
         "flat, lamps": ball("flat", lit=LAMPS), "flat, coarse": ball("flat", rows=6, lit=DULL), "wide": ball("smooth", rows=8, lit=DULL, view={"fov": 110, "distance": 1.8}),
         "box, flat": box("flat", lit=DULL, color=ORANGE, view={"fov": 90, "distance": 2.6}), "box, smooth": box("smooth", lit=DULL, color=ORANGE),
         "box, glossy, parallel": box("flat", lit=GLOSSY, color=ORANGE, view=PARALLEL),
         "filter": ball(after=filtered), "surface": surface("smooth", color=(0.4, 0.7, 0.9, 1)), "surface, flat": surface("flat", color=(0.4, 0.7, 0.9, 1)), "sphere": sphere(), "smooth, panzoom": ball("smooth", seen="panzoom"), "two balls": two_balls}
# Left to the real OpenGL.
UNTRACED = {"values": ball(vertex_values=np.linspace(0, 1, 554), rows=24, after=lambda mesh: setattr(mesh, "cmap", "hot")), "wireframe": ball("smooth", after=outlined), "sphere, shaded alone": sphere("smooth"), "flat, panzoom": ball("flat", seen="panzoom"),
            "inside a box": box("smooth", lit=GLOSSY, color=ORANGE, view={"fov": 60, "distance": 0.2}), "box, glossy": box("flat", lit=GLOSSY, color=ORANGE),
            "smooth, coarse": ball("smooth", rows=5, lit=GLOSSY)}


def groups():
    """The states that are traced, and those that are not, of this version."""
    newer = hasattr(filters, "ShadingFilter")
    return {"traced": STATES | (NEWER if newer else {}), "untraced": UNTRACED if newer else {}}


if __name__ == "__main__":
    main(groups())
