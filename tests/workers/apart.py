"""Data of ranks that lie away from each other on the screen: apart.py FOLDER, run by pvbatch. Writes images of three cameras, 0.png, 1.png, 2.png, of a
layout with two views, 3.png, and of two views of one size, whose cameras change places, 4.png and 5.png. Of eight pieces, each rank has neighbouring ones: between the boxes
of the ranks' data the background shows, and some data lie outside of the view."""
import sys

import paraview.simple as pv

PIECES = """
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
control = vtkMultiProcessController.GetGlobalController()
rank, ranks = control.GetLocalProcessId(), control.GetNumberOfProcesses()
def ball(x, y, z):
    made = vtkSphereSource()
    made.SetCenter(x, y, z), made.SetRadius(0.6), made.SetThetaResolution(24), made.SetPhiResolution(24)
    return made
def box(x, y, z, height):
    made = vtkCubeSource()
    made.SetCenter(x, y, z), made.SetXLength(0.5), made.SetYLength(0.5), made.SetZLength(height)
    return made
def floor(x, y, z, size):
    made = vtkPlaneSource()
    made.SetOrigin(x, y, z), made.SetPoint1(x + size, y, z), made.SetPoint2(x, y + size, z)
    return made
pieces = [ball(-2.2, 0, 0), box(-2.4, 1.5, 0.4, 1.6), floor(-2.9, -1.6, -0.8, 1.4), ball(0, 1.8, 1.2), box(0.6, -0.8, 0, 0.7), floor(1.2, -1, -0.8, 2),
          ball(2.2, 0.2, 0), box(2, 2.1, 0.3, 1.5)]
append = vtkAppendPolyData()
for number, piece in enumerate(pieces):
    if number * ranks // len(pieces) == rank and number in SHOWN:
        append.AddInputConnection(piece.GetOutputPort())
if append.GetNumberOfInputConnections(0) > 0:
    normals, moved, place = vtkPolyDataNormals(), vtkTransformPolyDataFilter(), vtkTransform()
    place.Translate(MOVED, 0, 0)
    normals.SetInputConnection(append.GetOutputPort()), normals.SplittingOn()
    moved.SetInputConnection(normals.GetOutputPort()), moved.SetTransform(place), moved.Update()
    self.GetPolyDataOutput().ShallowCopy(moved.GetOutput())
"""


def pieces(shown=range(8), moved=0):
    return pv.ProgrammableSource(Script=f"SHOWN, MOVED = {tuple(shown)}, {moved}\n{PIECES}")


pv._DisableFirstRenderCameraReset()
view = pv.CreateView("RenderView")
view.ViewSize = [160, 120]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.9, 0.9, 1]
shown = pv.Show(pieces(), view)
shown.DiffuseColor = shown.AmbientColor = [0.9, 0.6, 0.3]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]
for number, position in enumerate(((0, -7, 3), (5, -4, 1.5), (-0.5, -0.5, 4.5))):
    view.CameraPosition = position
    pv.Render(view)
    pv.SaveScreenshot(f"{sys.argv[1]}/{number}.png", view)

# Two views of one layout, in which all ranks have data. The second one has a background that the program draws itself.
layout = pv.CreateLayout("both")
views = []
for position in ((0, -11, 4), (4, -13, 0.5)):
    one = pv.CreateView("RenderView")
    one.OrientationAxesVisibility = 1
    one.UseColorPaletteForBackground = 0
    one.Background = [0.2, 0.3, 0.2]
    pv.AssignViewToLayout(one, layout, hint=len(views))
    pv.Show(pieces(), one).DiffuseColor = [0.3, 0.6, 0.9]
    one.CameraPosition, one.CameraFocalPoint, one.CameraViewUp = position, [0, 0, 0], [0, 0, 1]
    views.append(one)
views[1].BackgroundColorMode = "Gradient"
views[1].Background2 = [1, 0.8, 0.6]
layout.SetSplitFraction(0, 0.6)
layout.SetSize(241, 100)
for one in views:
    pv.Render(one)
pv.SaveScreenshot(f"{sys.argv[1]}/3.png", layout)

# Two views of one size. Half of the ranks have data in the one, the others in the other one. What lies outside is not drawn by one process, either.
layout = pv.CreateLayout("equal")
views = []
for hint in range(2):
    one = pv.CreateView("RenderView")
    one.OrientationAxesVisibility = 0
    one.UseColorPaletteForBackground = 0
    one.Background = [1, 1, 1]
    pv.AssignViewToLayout(one, layout, hint=hint)
    for shown, moved in ((range(4), -20), (range(4, 8), 20)):
        pv.Show(pieces(shown, moved), one).DiffuseColor = [0.5, 0.8, 0.5]
    one.CameraViewUp = [0, 0, 1]
    views.append(one)
layout.SetSize(242, 100)
for number, sides in ((4, (-21.5, 21.7)), (5, (21.7, -21.5))):
    for one, x in zip(views, sides):
        one.CameraPosition, one.CameraFocalPoint = (x + 1, -7, 3), (x, 0.3, 0)
        pv.Render(one)
    pv.SaveScreenshot(f"{sys.argv[1]}/{number}.png", layout)
