"""A window of VTK with a wavy plane, for scripts/bench shots. Ends when the window is closed. Needs Debian's VTK."""
import math
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("millions", type=float, help="of triangles")
    parser.add_argument("width", type=int, help="of the window, pixels")
    parser.add_argument("height", type=int)
    return parser.parse_args()


GIVEN = arguments() if __name__ == "__main__" else None  # before what may be missing is imported

import numpy  # noqa: E402
import vtkmodules.vtkInteractionStyle  # noqa: E402, F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: E402, F401
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkFiltersSources import vtkPlaneSource  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor  # noqa: E402


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
    main(GIVEN.millions, GIVEN.width, GIVEN.height)
