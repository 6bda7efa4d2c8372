"""A tube, a ball and a grid in pyqtgraph's 3D view, turned for twenty frames."""
import os

os.environ["PYQTGRAPH_QT_LIB"] = "PyQt5"
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
