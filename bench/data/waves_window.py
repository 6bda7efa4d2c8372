"""A window of VTK with a wavy plane: waves_window.py MILLIONS_OF_TRIANGLES WIDTH HEIGHT. Ends when the window is closed."""
import math
import sys

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor


def main(millions, width, height):
    side = int(math.sqrt(millions * 1e6 / 2))
    plane = vtkPlaneSource()
    plane.SetResolution(side, side)
    plane.Update()
    data = plane.GetOutput()
    points = numpy.frombuffer(data.GetPoints().GetData(), dtype=numpy.float32).reshape(-1, 3).copy()
    points[:, 2] = 0.05 * numpy.sin(20 * points[:, 0]) * numpy.cos(15 * points[:, 1])
    data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    data.GetPointData().Initialize()
    mapper, actor, renderer = vtkPolyDataMapper(), vtkActor(), vtkRenderer()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(0.4, -1.2, 0.9)
    renderer.ResetCamera()
    window, interactor = vtkRenderWindow(), vtkRenderWindowInteractor()
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    window.Render()
    interactor.Initialize()
    interactor.Start()


if __name__ == "__main__":
    main(float(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
