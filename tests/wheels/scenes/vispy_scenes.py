"""Pictures by vispy's scene graph, through Qt."""
import sys

import numpy as np
from PIL import Image
from vispy import scene
from vispy.geometry import create_sphere

import scene_list


def shown(fill):
    """`fill` adds what is drawn to a view."""
    def draw(file):
        canvas = scene.SceneCanvas(keys=None, size=(500, 400), show=True, bgcolor=(0.2, 0.3, 0.4, 1), app="pyqt6")
        view = canvas.central_widget.add_view()
        view.camera = scene.TurntableCamera(fov=40, distance=4, elevation=25, azimuth=30)
        fill(view.scene)
        canvas.app.process_events()
        Image.fromarray(canvas.render(alpha=False)).save(file)
    return draw


def ball(rows=60):
    return create_sphere(rows, rows, radius=1)


def mesh(shading, colors=False, **more):
    def fill(parent):
        data = ball()
        points = data.get_vertices()
        given = {"vertex_colors": np.c_[0.5 + 0.5 * points, np.ones(len(points))]} if colors else {"color": (0.9, 0.6, 0.3, 1)}
        scene.visuals.Mesh(points, data.get_faces(), shading=shading, parent=parent, **given, **more)
    return fill


def markers(parent):
    points = ball(40).get_vertices()
    made = scene.visuals.Markers(parent=parent)
    made.set_data(points, size=6, face_color=np.c_[0.5 + 0.5 * points, np.ones(len(points))], edge_width=0)


def surface(parent):
    x, y = np.meshgrid(np.linspace(-1.5, 1.5, 120), np.linspace(-1.5, 1.5, 120), indexing="ij")
    scene.visuals.SurfacePlot(x[:, 0], y[0], 0.3 * np.sin(4 * x) * np.cos(3 * y), color=(0.4, 0.7, 0.9, 1), shading="smooth", parent=parent)


def volume(**how):
    def fill(parent):
        x, y, z = np.meshgrid(*[np.linspace(-1, 1, 48)] * 3, indexing="ij")
        made = scene.visuals.Volume(np.exp(-4 * (x * x + y * y + z * z)).astype("f4"), parent=parent, **how)
        made.transform = scene.transforms.STTransform(scale=(0.04, 0.04, 0.04), translate=(-1, -1, -1))
    return fill


SCENES = {"mesh, unlit": shown(mesh(None, True)), "mesh, smooth": shown(mesh("smooth")), "mesh, flat": shown(mesh("flat", True)),
          "surface": shown(surface), "markers": shown(markers), "volume": shown(volume())}
SCENES |= {f"volume, {method}": shown(volume(method=method, cmap="viridis", threshold=0.4))
           for method in ("attenuated_mip", "minip", "translucent", "additive", "iso", "average")}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
