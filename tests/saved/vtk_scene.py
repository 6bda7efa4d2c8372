"""A VTK window with three surfaces: vtk_scene.py. Reads lines "px py pz fx fy fz ux uy uz ANGLE SCALE"
(SCALE above 0: a parallel projection), shows the scene from there, and answers "shown". Draws all the time, as in an event loop."""
import os
import select
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

SURFACES = ((vtkSphereSource, (0, 0, 0), 0, (1, 0.3, 0.2)), (vtkConeSource, (1, 0, 0.3), 40, (0.2, 0.8, 0.3)),
            (vtkCubeSource, (-1, 0.2, -0.5), 0, (0.3, 0.4, 1)))


def scene():
    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.SetSize(200, 150)
    window.SetMultiSamples(0)
    renderer.SetBackground(0.2, 0.3, 0.4)
    window.AddRenderer(renderer)
    for source, place, turn, color in SURFACES:
        made, mapper, actor = source(), vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(made.GetOutputPort())
        actor.SetMapper(mapper)
        actor.SetPosition(place)
        actor.RotateY(turn)
        actor.GetProperty().SetColor(color)
        renderer.AddActor(actor)
    return window, renderer


def show(renderer, values):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(values[0:3])
    camera.SetFocalPoint(values[3:6])
    camera.SetViewUp(values[6:9])
    camera.SetViewAngle(values[9])
    camera.SetParallelProjection(values[10] > 0)
    if values[10] > 0:
        camera.SetParallelScale(values[10])
    renderer.ResetCameraClippingRange()


def main():
    window, renderer = scene()
    waiting = b""
    while True:
        ready, _, _ = select.select([sys.stdin], [], [], 0.1)
        if ready:
            read = os.read(sys.stdin.fileno(), 4096)
            if not read:
                return
            waiting += read
        *lines, waiting = waiting.split(b"\n")
        for line in lines:
            show(renderer, [float(word) for word in line.split()])
        window.Render()
        for _ in lines:
            print("shown", flush=True)


if __name__ == "__main__":
    main()
