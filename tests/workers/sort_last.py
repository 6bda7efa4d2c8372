"""A plane and spheres, which ParaView splits among its ranks: sort_last.py IMAGE.png [[HOST:]PORT | orbit], run by pvbatch, or by pvpython as the client
of the pvserver at that port, which renders. orbit: the image is the last one of an animation in which the camera turns."""
import sys

import paraview.simple as pv

pv._DisableFirstRenderCameraReset()
orbits = sys.argv[2:] == ["orbit"]
if len(sys.argv) > 2 and not orbits:
    host, _, port = sys.argv[2].rpartition(":")
    pv.Connect(host or "127.0.0.1", int(port))
    pv.GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0  # MB from which on the server renders
view = pv.CreateView("RenderView")
view.ViewSize = [300, 240]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.2, 0.3, 0.4]
pv.Show(pv.Plane(Origin=[-3, -3, -0.6], Point1=[3, -3, -0.6], Point2=[-3, 3, -0.6]), view)
spheres = [pv.Sphere(Center=[i - 1.5, 0.3 * (i % 2), 1], Radius=0.5, ThetaResolution=48, PhiResolution=48) for i in range(4)]
for sphere in spheres:
    pv.Show(sphere, view)
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]


def drop(spheres):
    for sphere in spheres:
        sphere.Center = [sphere.Center[0], sphere.Center[1], 0]


if orbits:
    drop(spheres)
    for step in range(12):
        view.CameraPosition = [0.2 * (step - 11), -6, 4]
        pv.Render(view)
else:
    for x in (2, -1, 0):
        view.CameraPosition = [x, -6, 4]
        pv.Render(view)
    drop(spheres)  # the camera stays
    pv.Render(view)
pv.SaveScreenshot(sys.argv[1], view)
