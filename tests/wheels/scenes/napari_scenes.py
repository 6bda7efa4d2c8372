"""Pictures by napari's viewer."""
import sys

import napari
import numpy as np
from qtpy.QtWidgets import QApplication

import scene_list


def shown(add, **camera):
    """`add` adds layers to the viewer."""
    def draw(file):
        viewer = napari.Viewer()
        viewer.window.resize(700, 500)
        add(viewer)
        viewer.dims.ndisplay = 3
        viewer.camera.angles = (20, 30, 40)
        for name, value in camera.items():
            setattr(viewer.camera, name, value)
        for _ in range(5):
            QApplication.processEvents()
        viewer.screenshot(file, canvas_only=True)
        viewer.close()
    return draw


def cloud():
    z, y, x = np.mgrid[-1:1:48j, -1:1:48j, -1:1:48j]
    return np.exp(-3 * (x * x + y * y + z * z)).astype(np.float32)


def torus(n=60):
    u, v = np.meshgrid(*2 * [np.linspace(0, 2 * np.pi, n, endpoint=False)], indexing="ij")
    points = np.stack([(20 + 7 * np.cos(v)) * np.cos(u), (20 + 7 * np.cos(v)) * np.sin(u), 7 * np.sin(v)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b, c, d = (((i + k) % n * n + (j + m) % n).ravel() for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return points, np.concatenate([np.c_[a, b, c], np.c_[a, c, d]])


def surface(shading="smooth", colors=False):
    def add(viewer):
        points, faces = torus()
        if colors:
            viewer.add_surface((points, faces), vertex_colors=0.5 + 0.5 * np.sin(points / 7), shading=shading)
        else:
            viewer.add_surface((points, faces, points[:, 2]), colormap="viridis", shading=shading)
    return add


SCENES = {
    "volume": shown(lambda viewer: viewer.add_image(cloud())),
    "volume, attenuated": shown(lambda viewer: viewer.add_image(cloud(), rendering="attenuated_mip")),
    "volume, translucent": shown(lambda viewer: viewer.add_image(cloud(), rendering="translucent", colormap="magma")),
    "volume, isosurface": shown(lambda viewer: viewer.add_image(cloud(), rendering="iso", iso_threshold=0.4)),
    "surface": shown(surface()),
    "surface, flat": shown(surface("flat")),
    "surface, unlit": shown(surface("none")),
    "surface, colours": shown(surface(colors=True)),
    "surface, perspective": shown(surface(), perspective=45),
    "points": shown(lambda viewer: viewer.add_points(40 * np.random.default_rng(1).random((200, 3)), size=2)),
    "labels": shown(lambda viewer: viewer.add_labels((cloud() > 0.4).astype(int))),
    "tracks": shown(lambda viewer: viewer.add_tracks(np.c_[np.repeat([1, 2, 3], 30), np.tile(np.arange(30), 3), 40 * np.random.default_rng(1).random((90, 3))])),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
