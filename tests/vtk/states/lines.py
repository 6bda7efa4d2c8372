"""Lines, points and edges: alone, on surfaces, as tubes and spheres."""
import numpy as np
import shapes
from registry import state


def ball(stage, **properties):
    display = stage.show(stage.simple.Sphere(ThetaResolution=16, PhiResolution=12), **properties)
    stage.look()
    return display


def streamlines(stage):
    simple = stage.simple
    calculator = simple.Calculator(simple.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="flow",
                                   Function="coordsY*iHat-coordsX*jHat+2*kHat")
    seeds = {"Center": [0, 0, -6], "Radius": 4, "NumberOfPoints": 12}
    tracer = simple.StreamTracer(calculator, SeedType="Line", Vectors=["POINTS", "flow"])
    tracer.SeedType.Point1, tracer.SeedType.Point2 = [1, 0, -6], [5, 0, -6]
    tracer.SeedType.Resolution = seeds["NumberOfPoints"]
    tracer.MaximumStreamlineLength = 40
    return tracer


@state("pvbatch")
def wireframe(stage):
    ball(stage, Representation="Wireframe")
    stage.orbit()


@state("pvbatch")
def wireframe_wide(stage):
    ball(stage, Representation="Wireframe", LineWidth=4)
    stage.orbit()


@state("pvbatch")
def points(stage):
    ball(stage, Representation="Points", PointSize=4)
    stage.orbit()


@state("pvbatch")
def outline_around_surface(stage):
    ball(stage)
    stage.show(stage.simple.Wavelet(WholeExtent=[-1, 1] * 3), Representation="Outline")
    stage.look()
    stage.orbit()


@state("pvbatch")
def feature_edges(stage):
    stage.show(stage.simple.Cylinder(Resolution=16), Representation="Feature Edges")
    stage.look()
    stage.orbit()


@state("pvbatch")
def surface_with_edges(stage):
    ball(stage, Representation="Surface With Edges", EdgeColor=[0.8, 0.1, 0.1])
    stage.orbit(3)


@state("pvbatch")
def surface_with_wide_edges(stage):
    ball(stage, Representation="Surface With Edges", LineWidth=3)
    stage.orbit()


@state("pvbatch", beyond=0.004, reason="slivers thinner than a pixel on the outline, which grow by a quarter of a pixel")
def surface_with_fine_edges(stage):
    """Triangles of few pixels: edges cover nearly everything."""
    stage.show(stage.simple.Sphere(ThetaResolution=90, PhiResolution=90), Representation="Surface With Edges", EdgeColor=[0.8, 0.1, 0.1])
    stage.look()
    stage.orbit()


@state("pvbatch")
def surface_with_edges_of_cells(stage):
    """Boxes, whose faces are two triangles each with one edge that is not painted; close, in parallel, and cut by the near plane."""
    stage.show(stage.simple.Wavelet(WholeExtent=[-3, 3] * 3), Representation="Surface With Edges", LineWidth=2, color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()
    stage.view.CameraParallelProjection = 1
    stage.shoot()


@state("pvbatch")
def surface_with_edges_scalars(stage):
    stage.show(stage.data(shapes.grid(shapes.vtk_modules(), 12)), Representation="Surface With Edges", color_by=("POINTS", "bump"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def wireframe_over_surface(stage):
    """Lines on the surface they belong to: the mapper offsets them."""
    source = stage.simple.Sphere(ThetaResolution=16, PhiResolution=12)
    stage.show(source, DiffuseColor=[0.8, 0.8, 0.4])
    stage.simple.Transform(source)
    stage.show(stage.simple.GetActiveSource(), Representation="Wireframe", AmbientColor=[0.7, 0, 0])
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def lines_as_tubes(stage):
    """Without coincident topology resolution: its shaders add 0 times something undefined, which is NaN in places in llvmpipe."""
    stage.set(ResolveCoincidentTopology=0)
    stage.show(streamlines(stage), RenderLinesAsTubes=1, LineWidth=6)
    stage.look()
    stage.orbit()


@state("pvbatch")
def points_as_spheres(stage):
    stage.set(ResolveCoincidentTopology=0)
    ball(stage, Representation="Points", RenderPointsAsSpheres=1, PointSize=9)
    stage.orbit()


@state("pvbatch", outside=False)
def lines_as_tubes_peeled(stage):
    stage.set(DepthPeeling=1, MaximumNumberOfPeels=4, ResolveCoincidentTopology=0)
    stage.show(streamlines(stage), RenderLinesAsTubes=1, LineWidth=6, Opacity=0.5)
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False)
def points_as_spheres_peeled(stage):
    stage.set(DepthPeeling=1, MaximumNumberOfPeels=4, ResolveCoincidentTopology=0)
    ball(stage, Representation="Points", RenderPointsAsSpheres=1, PointSize=9, Opacity=0.5)
    stage.look()
    stage.orbit()


@state("pvbatch")
def wide_lines(stage):
    stage.show(streamlines(stage), LineWidth=5)
    stage.show(stage.simple.Sphere(Radius=3, ThetaResolution=24, PhiResolution=24))
    stage.look()
    stage.orbit()


@state("pvbatch")
def tube_filter(stage):
    tube = stage.simple.Tube(streamlines(stage), Radius=0.2, NumberofSides=8)
    stage.show(tube, color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def ribbon_filter(stage):
    stage.show(stage.simple.Ribbon(streamlines(stage), Width=0.5))
    stage.look()
    stage.orbit()


@state("pvbatch")
def point_gaussian(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=20, PhiResolution=20), Representation="Point Gaussian", GaussianRadius=0.03)
    stage.look()
    stage.orbit()


@state("pvbatch")
def point_gaussian_spheres(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=20, PhiResolution=20), Representation="Point Gaussian", GaussianRadius=0.03,
               ShaderPreset="Sphere")
    stage.look()
    stage.orbit()


@state("vtk")
def vertices_shown(stage):
    actor = stage.show(shapes.grid(stage.vtk, 10))
    actor.GetProperty().VertexVisibilityOn()
    actor.GetProperty().SetVertexColor(1, 0, 0)
    actor.GetProperty().SetPointSize(5)
    stage.look()
    stage.orbit()


@state("vtk")
def verts_lines_and_polygons(stage):
    """One mapper with every kind of cell: primitive numbers continue through all of them."""
    vtk = stage.vtk
    append = vtk.vtkAppendPolyData()
    line, point, plane = vtk.vtkLineSource(), vtk.vtkPointSource(), shapes.grid(vtk, 6)
    line.SetResolution(10)
    line.SetPoint1(-1, -1, 0.6)
    line.SetPoint2(1, 1, 0.6)
    point.SetNumberOfPoints(1)
    append.AddInputConnection(point.GetOutputPort())
    append.AddInputConnection(line.GetOutputPort())
    append.AddInputData(plane)
    append.Update()
    data = append.GetOutput()
    data.GetCellData().SetScalars(shapes.array(np.arange(data.GetNumberOfCells()) % 5, "kind"))
    actor = stage.show(data)
    actor.GetMapper().SetScalarModeToUseCellData()
    actor.GetMapper().SetScalarRange(0, 4)
    actor.GetProperty().SetLineWidth(3)
    actor.GetProperty().SetPointSize(6)
    stage.look()
    stage.orbit()
