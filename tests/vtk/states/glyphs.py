"""Glyphs and small shapes drawn by shaders."""
import numpy as np
import shapes
from registry import state


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
    """Levels of detail chosen by transform feedback."""
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
    """Impostors: spheres and sticks, each a quadrilateral that its shader makes round."""
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


def glyphs(stage, edges=True, lit=True, change=lambda actor: None):
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
    actor = stage.show(mapper)
    change(actor)
    look = actor.GetProperty()
    look.SetEdgeVisibility(edges)
    look.SetEdgeColor(0, 0, 0.4)
    look.SetLighting(lit)
    stage.look()
    stage.orbit(3)


def cut(stage, unlit=False, opacity=1, interpolation="Gouraud"):
    """Planes cut glyphs where they stand."""
    def change(actor):
        for normal in ((1, 0.3, 0.5), (-0.4, 1, 0)):
            plane = stage.vtk.vtkPlane()
            plane.SetNormal(normal)
            actor.GetMapper().AddClippingPlane(plane)
        actor.GetProperty().SetOpacity(opacity)
        getattr(actor.GetProperty(), f"SetInterpolationTo{interpolation}")()
    glyphs(stage, edges=False, lit=not unlit, change=change)


@state("vtk")
def glyph_mapper_cut(stage):
    cut(stage)


@state("vtk")
def glyph_mapper_cut_unlit(stage):
    cut(stage, unlit=True)


@state("vtk", outside=False)
def glyph_mapper_cut_translucent(stage):
    cut(stage, opacity=0.5)


@state("vtk")
def glyph_mapper_cut_physical(stage):
    cut(stage, interpolation="PBR")


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
    """Left to the real OpenGL if a glyph has a corner behind the viewer."""
    glyphs(stage)
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.2, 0.1, 0.15)
    camera.SetFocalPoint(0.6, 0.5, 0)
    camera.SetClippingRange(0.01, 5)
    stage.orbit(2)
