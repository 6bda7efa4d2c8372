"""A tube in silx's 3D window, turned for ten frames."""
from silx.gui import qt
from silx.gui.plot3d.items.mesh import Mesh
from silx.gui.plot3d.SceneWindow import SceneWindow

from models import knot

app = qt.QApplication([])
window = SceneWindow()
window.setGeometry(20, 20, 800, 700)
positions, normals, triangles = knot()
tube = Mesh()
tube.setData(position=positions.astype("f4"), color=(0.8, 0.6, 0.2, 1.0), normal=normals.astype("f4"), mode="triangles",
             indices=triangles.astype("u4"))
window.getSceneWidget().addItem(tube)
window.show()

turns = 0


def turn():
    global turns
    turns += 1
    tube.setRotation(6 * turns, (0, 1, 0))
    if turns == 10:
        timer.stop()


timer = qt.QTimer()
timer.timeout.connect(turn)
timer.start(100)
app.exec_()
