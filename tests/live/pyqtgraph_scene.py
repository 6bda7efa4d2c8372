"""A tube, balls, a surface and a grid in pyqtgraph's 3D view, turned for twenty frames."""
import os

os.environ["PYQTGRAPH_QT_LIB"] = "PyQt5"
import numpy  # noqa: E402
import pyqtgraph  # noqa: E402
import pyqtgraph.opengl as pg  # noqa: E402
from PyQt5.QtCore import QTimer  # noqa: E402

from models import knot  # noqa: E402

app = pyqtgraph.mkQApp()
view = pg.GLViewWidget()
view.setGeometry(20, 20, 600, 600)
view.setBackgroundColor("#203040")
positions, _, triangles = knot()
tube = pg.MeshData(vertexes=positions.astype("f4"), faces=triangles.astype("u4"))
view.addItem(pg.GLMeshItem(meshdata=tube, smooth=True, shader="shaded", color=(0.8, 0.6, 0.2, 1), glOptions="opaque"))
ball = pg.MeshData.sphere(40, 40, 1.2)
view.addItem(pg.GLMeshItem(meshdata=ball, smooth=True, shader="normalColor", glOptions="opaque"))
for place, shader in enumerate(("viewNormalColor", "edgeHilight")):
    item = pg.GLMeshItem(meshdata=pg.MeshData.sphere(20, 20, 0.7), smooth=True, shader=shader, color=(0.3, 0.5, 0.8, 1), glOptions="opaque")
    item.translate(3 - 6 * place, 3, 0)
    view.addItem(item)
balloon = pg.GLMeshItem(meshdata=pg.MeshData.sphere(30, 30, 2), smooth=True, shader="balloon", color=(0.4, 0.9, 0.7, 0.2), glOptions="translucent")
view.addItem(balloon)
steps = numpy.linspace(-2, 2, 40)
heights = numpy.sin(2 * steps)[:, None] * numpy.cos(3 * steps)[None, :]
surface = pg.GLSurfacePlotItem(x=steps, y=steps, z=0.4 * heights, shader="heightColor", computeNormals=False, smooth=False)
surface.shader()["colorMap"] = numpy.array([0.6, 1, 0.5, 0.4, 1.5, 1, 0.7, 0.5, 2])
surface.translate(0, -4, 0)
view.addItem(surface)
grid = pg.GLGridItem()
grid.translate(0, 0, -1.6)
view.addItem(grid)
view.setCameraPosition(distance=12, elevation=30, azimuth=0)
view.show()

turns = 0


def turn():
    global turns
    turns += 1
    view.setCameraPosition(azimuth=3 * turns)
    if turns == 20:
        timer.stop()


timer = QTimer()
timer.timeout.connect(turn)
timer.start(50)
app.exec_()
