"""Pictures by pyqtgraph's OpenGL widget."""
import sys

import numpy as np
import pyqtgraph as pg
import pyqtgraph.opengl as gl

import scene_list


def shown(*items):
    """`items` make what is drawn."""
    def draw(file):
        application = pg.mkQApp()
        view = gl.GLViewWidget()
        view.setBackgroundColor(50, 75, 100)
        view.resize(500, 400)
        view.setCameraPosition(distance=5, elevation=25, azimuth=40)
        for make in items:
            view.addItem(make())
        view.show()
        for _ in range(3):
            application.processEvents()
        view.grabFramebuffer().save(file)
    return draw


def ball(shader, **more):
    def make():
        data = gl.MeshData.sphere(rows=40, cols=60, radius=1)
        if more.pop("colors", False):
            points = data.vertexes()
            data.setVertexColors(np.c_[0.5 + 0.5 * points, np.ones(len(points))])
        return gl.GLMeshItem(meshdata=data, smooth=True, shader=shader, glOptions="opaque", **more)
    return make


def surface():
    x, y = np.meshgrid(np.linspace(-1.5, 1.5, 100), np.linspace(-1.5, 1.5, 100), indexing="ij")
    return gl.GLSurfacePlotItem(x=x[:, 0], y=y[0], z=0.4 * np.sin(3 * x) * np.cos(2 * y), shader="normalColor", glOptions="opaque")


def points():
    at = gl.MeshData.sphere(rows=30, cols=40, radius=1.2).vertexes()
    return gl.GLScatterPlotItem(pos=at, size=5, color=np.c_[0.5 + 0.4 * at, np.ones(len(at))], glOptions="opaque")


def volume():
    x, y, z = np.meshgrid(*[np.linspace(-1, 1, 40)] * 3, indexing="ij")
    density = (255 * np.exp(-4 * (x * x + y * y + z * z))).astype(np.ubyte)
    item = gl.GLVolumeItem(np.stack([density, 255 - density, np.full_like(density, 90), density // 6], -1))
    item.scale(0.05, 0.05, 0.05)
    item.translate(-1, -1, -1)
    return item


SCENES = {f"mesh, {shader}": shown(ball(shader, color=(0.9, 0.6, 0.3, 1))) for shader in ("shaded", "balloon", "normalColor", "viewNormalColor", "edgeHilight", "heightColor")}
SCENES |= {"mesh, vertex colours": shown(ball("shaded", colors=True)), "mesh with edges": shown(ball("shaded", color=(0.9, 0.6, 0.3, 1), drawEdges=True)),
           "surface": shown(surface), "points": shown(points), "volume": shown(volume), "grid and axes": shown(gl.GLGridItem, gl.GLAxisItem)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
