"""Lines, points and edges: alone, on surfaces, as tubes and spheres; glyphs and small shapes drawn by shaders."""
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
    """Triangles of few pixels: nearly everything is painted."""
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
    """Lines upon the surface they belong to: the mapper moves them."""
    source = stage.simple.Sphere(ThetaResolution=16, PhiResolution=12)
    stage.show(source, DiffuseColor=[0.8, 0.8, 0.4])
    stage.simple.Transform(source)
    stage.show(stage.simple.GetActiveSource(), Representation="Wireframe", AmbientColor=[0.7, 0, 0])
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def lines_as_tubes(stage):
    """Not brought forward: the shaders that do that add 0 times something undefined, which llvmpipe has as NaN here and there."""
    stage.set(ResolveCoincidentTopology=0)
    stage.show(streamlines(stage), RenderLinesAsTubes=1, LineWidth=6)
    stage.look()
    stage.orbit()


@state("pvbatch")
def points_as_spheres(stage):
    stage.set(ResolveCoincidentTopology=0)
    ball(stage, Representation="Points", RenderPointsAsSpheres=1, PointSize=9)
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


@state("pvbatch")
def glyph_filter(stage):
    glyph = stage.simple.Glyph(stage.simple.Sphere(ThetaResolution=8, PhiResolution=6), GlyphType="Arrow", ScaleFactor=0.3,
                               OrientationArray=["POINTS", "Normals"])
    stage.show(glyph)
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def glyph_mapper(stage):
    simple = stage.simple
    stage.show(simple.Sphere(ThetaResolution=16, PhiResolution=12), Representation="3D Glyphs", GlyphType="Cone",
               Scaling=1, ScaleFactor=0.1, Orient=1, SelectOrientationVectors="Normals")
    stage.look()
    stage.orbit(3)


@state("vtk")
def glyph_mapper_colored(stage):
    vtk = stage.vtk
    data = shapes.grid(vtk, 10)
    data.GetPointData().SetActiveScalars("bump")
    shape, mapper = shapes.sphere(vtk, 12), vtk.vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(shape.GetOutputPort())
    mapper.SetScaleFactor(0.15)
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScalarRange(-1, 1)
    stage.show(mapper)
    stage.look()
    stage.orbit(3)


@state("vtk")
def glyph_mapper_culled(stage):
    """Levels of detail chosen on the graphics card, by transform feedback."""
    vtk = stage.vtk
    shape, mapper = shapes.sphere(vtk, 16), vtk.vtkGlyph3DMapper()
    mapper.SetInputData(shapes.grid(vtk, 10))
    mapper.SetSourceConnection(shape.GetOutputPort())
    mapper.SetScaleFactor(0.15)
    mapper.SetCullingAndLOD(True)
    mapper.SetNumberOfLOD(2)
    mapper.SetLODDistanceAndTargetReduction(0, 3, 0.5)
    mapper.SetLODDistanceAndTargetReduction(1, 6, 0.8)
    stage.show(mapper)
    stage.look()
    stage.orbit()


def atoms(vtk):
    data = shapes.grid(vtk, 8, 0.4)
    n = data.GetNumberOfPoints()
    data.GetPointData().AddArray(shapes.array([0.05 + 0.01 * (i % 5) for i in range(n)], "radius", np.float32))
    data.GetPointData().SetActiveScalars("bump")
    return data


@state("vtk")
def sphere_mapper(stage):
    mapper = stage.vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(atoms(stage.vtk))
    mapper.SetScaleArray("radius")
    mapper.SetScalarRange(-1, 1)
    stage.show(mapper)
    stage.look()
    stage.orbit(3)


@state("vtk")
def sphere_mapper_one_radius(stage):
    mapper = stage.vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(atoms(stage.vtk))
    mapper.SetRadius(0.15)
    mapper.ScalarVisibilityOff()
    stage.show(mapper)
    stage.show(stage.vtk.vtkCubeSource(), color=(0.4, 0.8, 0.5))
    stage.look()
    stage.orbit()


@state("vtk")
def molecule(stage):
    """Spheres and sticks, a quadrilateral each that its shader makes round."""
    vtk = stage.vtk
    made, mapper = vtk.vtkMolecule(), vtk.vtkMoleculeMapper()
    atoms = [made.AppendAtom(n, x, y, z) for n, x, y, z in
             ((6, 0, 0, 0), (8, 1.2, 0, 0), (1, -0.6, 0.9, 0), (7, -0.7, -1.1, 0.4), (1, -0.2, -1.9, 0.6))]
    for a, b, order in ((0, 1, 2), (0, 2, 1), (0, 3, 1), (3, 4, 1)):
        made.AppendBond(atoms[a], atoms[b], order)
    mapper.SetInputData(made)
    mapper.UseBallAndStickSettings()
    stage.show(mapper)
    stage.look(zoom=3)
    stage.orbit(3)


@state("vtk")
def edges_of_vtk(stage):
    actor = stage.show(shapes.grid(stage.vtk, 10))
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0, 0, 0.4)
    stage.look()
    stage.orbit()


def edged(stage, source=None, width=1.5):
    actor = stage.show(source or shapes.sphere(stage.vtk, 14))
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0, 0, 0.4)
    look.SetLineWidth(width)
    return actor


def plane_with_edges(stage, samples):
    """Neighbours in one plane that the viewer faces: where they grow over each other their depths are equal."""
    vtk = stage.vtk
    source = vtk.vtkPlaneSource()
    source.SetResolution(10, 10)
    edged(stage, source, 1)
    stage.window.SetMultiSamples(samples)


@state("vtk")
def edges_facing(stage):
    plane_with_edges(stage, 0)
    stage.renderer.ResetCamera()
    stage.orbit(2)


@state("vtk")
def edges_facing_multisampled(stage):
    plane_with_edges(stage, 4)
    stage.renderer.ResetCamera()
    stage.orbit(2)


@state("vtk")
def edges_multisampled(stage):
    edged(stage)
    stage.window.SetMultiSamples(4)
    stage.look()
    stage.orbit()


@state("vtk")
def edges_culled(stage):
    """The inside of a ball through its culled front, and the front without what is behind."""
    look = edged(stage).GetProperty()
    look.FrontfaceCullingOn()
    stage.look()
    stage.orbit(2)
    look.FrontfaceCullingOff()
    look.BackfaceCullingOn()
    stage.orbit(2)


@state("vtk")
def edges_clipped(stage):
    plane, other = stage.vtk.vtkPlane(), stage.vtk.vtkPlane()
    plane.SetNormal(1, 0.4, 0.2)
    other.SetNormal(-0.2, 1, 0)
    other.SetOrigin(0, -0.2, 0)
    mapper = edged(stage, width=2).GetMapper()
    mapper.AddClippingPlane(plane)
    stage.look()
    stage.orbit(2)
    mapper.AddClippingPlane(other)
    stage.show(shapes.sphere(stage.vtk, 24, 0.3), color=(0.4, 0.7, 0.9))
    stage.orbit(2)


@state("vtk")
def edges_pushed(stage):
    """Surfaces at nearly one depth, of which the mapper moves one with edges back."""
    mapper = stage.vtk.vtkMapper
    before = mapper.GetResolveCoincidentTopology()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    edged(stage).GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(0, 300)
    stage.show(shapes.sphere(stage.vtk, 14, 0.499), color=(0.4, 0.7, 0.9))
    stage.look()
    stage.orbit(2)
    mapper.SetResolveCoincidentTopology(before)


@state("vtk")
def edges_behind_the_viewer(stage):
    """Left to the real OpenGL: near the viewer's plane triangles grow by any number of pixels."""
    edged(stage, width=3)
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.1, 0.1, 0.2)
    camera.SetFocalPoint(0.4, 0.3, 0)
    camera.SetClippingRange(0.01, 5)
    stage.orbit(2)


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
    """One mapper with every kind of cell: the primitive counts run on through all of them."""
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


@state("vtk")
def edges_unlit(stage):
    edged(stage).GetProperty().LightingOff()
    stage.look()
    stage.orbit(2)
    edged(stage, shapes.grid(stage.vtk, 10), width=3).GetProperty().LightingOff()
    stage.orbit(2)


@state("vtk")
def edges_physically_based(stage):
    for metallic in 0, 0.7:
        actor = edged(stage)
        actor.SetPosition(2 * metallic, 0, 0)
        look = actor.GetProperty()
        look.SetInterpolationToPBR()
        look.SetMetallic(metallic)
        look.SetRoughness(0.4)
    stage.look()
    stage.orbit(3)


def glyphs(stage, edges=True, lit=True):
    vtk = stage.vtk
    data = shapes.grid(vtk, 3)
    data.GetPointData().SetActiveScalars("bump")
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(data)
    stage.kept = shapes.sphere(vtk, 10)
    mapper.SetSourceConnection(stage.kept.GetOutputPort())
    mapper.SetScaleFactor(0.6)
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScalarRange(-1, 1)
    look = stage.show(mapper).GetProperty()
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(0, 0, 0.4)
    look.SetLighting(lit)
    stage.look()
    stage.orbit(3)


@state("vtk")
def glyph_mapper_edges(stage):
    glyphs(stage)


@state("vtk")
def glyph_mapper_unlit(stage):
    glyphs(stage, edges=False, lit=False)


@state("vtk")
def glyph_mapper_edges_unlit(stage):
    glyphs(stage, lit=False)


@state("vtk")
def glyph_mapper_edges_behind_the_viewer(stage):
    """Left to the real OpenGL where some glyph has a corner behind the viewer."""
    glyphs(stage)
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.2, 0.1, 0.15)
    camera.SetFocalPoint(0.6, 0.5, 0)
    camera.SetClippingRange(0.01, 5)
    stage.orbit(2)
