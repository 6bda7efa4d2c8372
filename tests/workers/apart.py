"""Data of ranks that lie away from each other on the screen: apart.py FOLDER, run by pvbatch. Writes pictures of three cameras, 0.png, 1.png, 2.png, and of a
layout with two views, 3.png. Of eight pieces, each rank has neighbouring ones: between the boxes of the ranks' data the background shows, and some data lie outside of the view."""
import sys

import paraview.simple as pv

PIECES = """
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
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
    if number * ranks // len(pieces) == rank:
        append.AddInputConnection(piece.GetOutputPort())
normals = vtkPolyDataNormals()
normals.SetInputConnection(append.GetOutputPort()), normals.SplittingOn(), normals.Update()
self.GetPolyDataOutput().ShallowCopy(normals.GetOutput())
"""

pv._DisableFirstRenderCameraReset()
view = pv.CreateView("RenderView")
view.ViewSize = [160, 120]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.9, 0.9, 1]
shown = pv.Show(pv.ProgrammableSource(Script=PIECES), view)
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
    pv.Show(pv.ProgrammableSource(Script=PIECES), one).DiffuseColor = [0.3, 0.6, 0.9]
    one.CameraPosition, one.CameraFocalPoint, one.CameraViewUp = position, [0, 0, 0], [0, 0, 1]
    views.append(one)
views[1].BackgroundColorMode = "Gradient"
views[1].Background2 = [1, 0.8, 0.6]
layout.SetSplitFraction(0, 0.6)
layout.SetSize(241, 100)
for one in views:
    pv.Render(one)
pv.SaveScreenshot(f"{sys.argv[1]}/3.png", layout)
