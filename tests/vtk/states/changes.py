"""Changes between frames: time, geometry, colours, representations, levels of detail."""
import numpy as np
import shapes
from registry import state


TIMES = """
info = self.GetOutputInformation(0)
info.Set(self.GetExecutive().TIME_STEPS(), [0, 1, 2, 3], 4)
info.Set(self.GetExecutive().TIME_RANGE(), [0, 3], 2)
"""
BALL_THAT_SHRINKS = """
from vtkmodules.vtkFiltersSources import vtkSphereSource
now = self.GetOutputInformation(0).Get(self.GetExecutive().UPDATE_TIME_STEP()) or 0
ball = vtkSphereSource()
ball.SetThetaResolution(12 + 8 * int(now))
ball.SetRadius(0.5 - 0.1 * now)
ball.Update()
self.GetOutput().ShallowCopy(ball.GetOutput())
"""


@state("pvbatch")
def animation(stage):
    """Animated geometry: another mesh in each frame."""
    source = stage.simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    source.ScriptRequestInformation, source.Script = TIMES, BALL_THAT_SHRINKS
    stage.show(source)
    stage.look()
    scene = stage.simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToFirst()
    for step in range(4):
        stage.shoot()
        scene.GoToNext()


@state("pvbatch")
def source_parameter(stage):
    source = stage.simple.Sphere(ThetaResolution=32, PhiResolution=32)
    stage.show(source)
    stage.look()
    for radius in (0.5, 0.3, 0.5, 0.4):
        source.Radius = radius
        stage.shoot()


@state("pvbatch")
def isovalue(stage):
    contour = stage.simple.Contour(stage.simple.Wavelet(WholeExtent=[-8, 8] * 3), ContourBy=["POINTS", "RTData"], Isosurfaces=[100])
    stage.show(contour)
    stage.look()
    for value in (100, 150, 200):
        contour.Isosurfaces = [value]
        stage.shoot()


@state("pvbatch")
def color_map(stage):
    display = stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    stage.look()
    for preset in ("Cool to Warm", "Viridis (matplotlib)", "Rainbow Uniform"):
        display.LookupTable.ApplyPreset(preset, True)
        stage.shoot()
    display.LookupTable.RescaleTransferFunction(-0.3, 2)
    stage.shoot()


@state("pvbatch")
def array_to_color_by(stage):
    display = stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    stage.look()
    for association, array in (("POINTS", "bump"), ("CELLS", "number"), ("POINTS", ""), ("POINTS", "bump")):
        stage.simple.ColorBy(display, (association, array))
        stage.shoot()


@state("pvbatch")
def representation(stage):
    display = stage.show(stage.simple.Sphere(ThetaResolution=16, PhiResolution=16))
    stage.look()
    for kind in ("Surface", "Wireframe", "Surface With Edges", "Points", "Surface"):
        display.SetRepresentationType(kind)
        stage.shoot()


@state("pvbatch")
def material(stage):
    display = stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32))
    stage.look()
    for i in range(3):
        display.DiffuseColor, display.Specular = [0.3 * i, 0.5, 1 - 0.3 * i], 0.4 * i
        stage.shoot()


@state("pvbatch")
def visibility(stage):
    simple = stage.simple
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=24)
    cone = simple.Cone(Resolution=20, Center=[0.5, 0, 0.4])
    stage.show(sphere)
    stage.show(cone, DiffuseColor=[0.8, 0.5, 0.2])
    stage.look()
    stage.shoot()
    simple.Hide(cone, stage.view)
    stage.shoot()
    simple.Show(cone, stage.view)
    simple.Hide(sphere, stage.view)
    stage.shoot()


@state("pvbatch")
def moved_actor(stage):
    display = stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32))
    stage.show(stage.simple.Box(), DiffuseColor=[0.4, 0.7, 0.3])
    stage.look()
    for i in range(3):
        stage.change(display, Position=[0.4 * i, 0.1, 0.2], Orientation=[20 * i, 10, 0], Scale=[1, 1 + 0.3 * i, 1])
        stage.shoot()


@state("pvbatch")
def level_of_detail(stage):
    """Frames while the user drags (fewer triangles), and at rest."""
    stage.set(LODThreshold=0.0, UseOutlineForLODRendering=0)
    stage.show(stage.simple.Sphere(ThetaResolution=120, PhiResolution=120))
    stage.look()
    stage.shoot()
    for _ in range(2):
        stage.view.GetActiveCamera().Azimuth(20)
        stage.view.SMProxy.InteractiveRender()
        stage.read(stage.view.GetRenderWindow())
    stage.shoot()


@state("pvbatch")
def window_size(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32))
    stage.look()
    for size in ([400, 300], [200, 250], [500, 120], [400, 300]):
        stage.view.ViewSize = size
        stage.shoot()


@state("vtk")
def points_moved_in_place(stage):
    data = shapes.grid(stage.vtk)
    stage.show(data)
    stage.look()
    for step in range(4):
        points = data.GetPoints()
        for i in range(0, points.GetNumberOfPoints(), 5):
            x, y, z = points.GetPoint(i)
            points.SetPoint(i, x, y, z + 0.02 * step)
        points.Modified()
        stage.shoot()


@state("vtk")
def surface_that_moves(stage):
    """Large enough, and animated long enough, for its acceleration structure to be refitted rather than rebuilt."""
    data = shapes.grid(stage.vtk, count=100)
    x, y = np.meshgrid(np.linspace(-1, 1, 100), np.linspace(-1, 1, 100))
    stage.show(data)
    stage.look()
    for step in range(9):
        z = 0.25 * np.sin(4 * x + 0.3 * step) * np.cos(3 * y)
        data.GetPoints().SetData(shapes.array(np.stack([x, y, z], -1).reshape(-1, 3), "Points", np.float32))
        data.Modified()
        stage.shoot()


@state("vtk")
def scalars_changed_in_place(stage):
    data = shapes.grid(stage.vtk)
    data.GetPointData().SetActiveScalars("bump")
    mapper = stage.show(data).GetMapper()
    mapper.SetScalarRange(-1, 1)
    stage.look()
    for step in range(3):
        values = np.sin(np.arange(data.GetNumberOfPoints()) * 0.03 * (step + 1))
        data.GetPointData().AddArray(shapes.array(values, "bump"))
        data.GetPointData().SetActiveScalars("bump")
        mapper.SetInterpolateScalarsBeforeMapping(step == 2)
        stage.shoot()


@state("vtk")
def actors_come_and_go(stage):
    vtk = stage.vtk
    actors = []
    for i in range(4):
        actors.append(stage.show(shapes.sphere(vtk, 16), color=(0.25 * i, 0.6, 0.5), at=(0.8 * i, 0, 0)))
        stage.look()
        stage.shoot()
    for actor in actors[:3]:
        stage.renderer.RemoveActor(actor)
        actor.ReleaseGraphicsResources(stage.window)
        stage.shoot()


@state("vtk")
def mapper_shared_by_actors(stage):
    """VTK deletes the buffer of normals that flat actors do not need, while its vertex array object still holds it."""
    vtk = stage.vtk
    mapper = stage.mapper(shapes.sphere(vtk, 24))
    for i in range(5):
        actor = stage.show(mapper, color=(0.2 * i, 0.5, 0.8), at=(0.9 * i, 0, 0))
        actor.GetProperty().SetInterpolation(i % 3)
        actor.GetProperty().SetSpecular(0.2 * i)
    stage.look()
    stage.orbit(3)


@state("vtk")
def time_of_level_of_detail_actor(stage):
    """vtkQuadricLODActor: VTK decimates the mapper's data."""
    vtk = stage.vtk
    actor = vtk.vtkLODActor()
    actor.SetMapper(stage.mapper(shapes.sphere(vtk, 60)))
    actor.SetNumberOfCloudPoints(500)
    stage.renderer.AddActor(actor)
    stage.look()
    for seconds in (10, 1e-6, 10):
        actor.SetAllocatedRenderTime(seconds, stage.renderer)
        stage.window.SetDesiredUpdateRate(1 / seconds)
        stage.shoot()
