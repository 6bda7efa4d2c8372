"""A tube and a ball as vispy's scene graph draws them, turned for twenty frames: the tube without blending, the ball with vispy's default."""
from PyQt5.QtCore import QTimer
from vispy import app, scene
from vispy.geometry import create_sphere

from models import knot

app.use_app("pyqt5")
canvas = scene.SceneCanvas(size=(600, 600), position=(20, 20), show=True, bgcolor="#203040")
view = canvas.central_widget.add_view()
view.camera = scene.TurntableCamera(fov=45, distance=12, elevation=30, azimuth=0)
positions, _, triangles = knot()
tube = scene.visuals.Mesh(positions.astype("f4"), triangles.astype("u4"), color=(0.8, 0.6, 0.2, 1), shading="smooth", parent=view.scene)
tube.set_gl_state("opaque", depth_test=True, cull_face=False)
ball = create_sphere(40, 40, radius=1.2)
scene.visuals.Mesh(ball.get_vertices(), ball.get_faces(), color=(0.3, 0.5, 0.8, 1), shading="smooth", parent=view.scene)

turns = 0


def turn():
    global turns
    turns += 1
    view.camera.azimuth = 3 * turns
    if turns == 20:
        timer.stop()


timer = QTimer()
timer.timeout.connect(turn)
timer.start(50)
app.run()
