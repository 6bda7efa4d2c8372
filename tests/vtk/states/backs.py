"""Back faces with a property of their own (vtkActor::SetBackfaceProperty), and glyphs of physically based materials.

VTK 9.1 does not set the opacity of such back faces for glyphs and physically based materials: they are invisible.
"""
import looks
import physical
import shapes
from registry import state


def look_inside(stage):
    stage.look(azimuth=40, elevation=-50)
    stage.orbit(3, 60)


def give_back(stage, actor, lit=True):
    other = stage.vtk.vtkProperty()
    other.SetColor(1, 0.2, 0.1)
    other.SetSpecular(0.5)
    other.SetLighting(lit)
    actor.SetBackfaceProperty(other)


def glyphs(stage, physically=False, back=False, lit=True, edges=False, opacity=1):
    """Open balls in colours of a map."""
    vtk, data, mapper = stage.vtk, shapes.grid(stage.vtk, 4), stage.vtk.vtkGlyph3DMapper()
    data.GetPointData().SetActiveScalars("bump")
    stage.kept = shapes.sphere(vtk, 16)
    stage.kept.SetEndTheta(220)
    mapper.SetInputData(data)
    mapper.SetSourceConnection(stage.kept.GetOutputPort())
    mapper.SetScaleFactor(0.6)
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScalarRange(-1, 1)
    actor = stage.show(mapper)
    look = actor.GetProperty()
    look.SetLighting(lit)
    look.SetEdgeVisibility(edges)
    look.SetOpacity(opacity)
    look.SetSpecular(0.3)
    if physically:
        look.SetInterpolationToPBR()
        look.SetRoughness(0.4)
        look.SetMetallic(0.5)
    if back:
        give_back(stage, actor, lit)
    stage.renderer.UseDepthPeelingOff()
    return actor


def physical_ball(stage, edges=False, opacity=1):
    ball = shapes.sphere(stage.vtk, 24)
    ball.SetEndTheta(220)
    actor = stage.show(ball)
    look = actor.GetProperty()
    look.SetInterpolationToPBR()
    look.SetRoughness(0.4)
    look.SetMetallic(0.5)
    look.SetEdgeVisibility(edges)
    look.SetOpacity(opacity)
    give_back(stage, actor)


@state("vtk")
def back_of_glyphs(stage):
    glyphs(stage, back=True)
    look_inside(stage)


@state("vtk")
def back_of_glyphs_unlit(stage):
    glyphs(stage, back=True, lit=False)
    look_inside(stage)


@state("vtk")
def back_of_glyphs_under_lamps(stage):
    glyphs(stage, back=True)
    looks.light_by_lamps(stage)
    look_inside(stage)


@state("vtk")
def back_of_glyphs_culled_in_front(stage):
    """Nothing is left."""
    glyphs(stage, back=True).GetProperty().FrontfaceCullingOn()
    stage.show(shapes.sphere(stage.vtk, 24, 0.5), color=(0.3, 0.5, 0.9))
    look_inside(stage)


@state("vtk")
def back_of_glyphs_edges(stage):
    glyphs(stage, back=True, edges=True)
    look_inside(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def back_of_glyphs_peeled(stage):
    """Left to the real OpenGL: behind invisible back faces VTK's peels lose layers."""
    glyphs(stage, back=True, opacity=0.5)
    looks.peel(stage)
    look_inside(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def back_of_glyphs_summed(stage):
    glyphs(stage, back=True, opacity=0.5)
    look_inside(stage)


@state("vtk")
def back_of_physical(stage):
    physical_ball(stage)
    stage.show(shapes.sphere(stage.vtk, 24, 0.3), color=(0.3, 0.5, 0.9))
    look_inside(stage)


@state("vtk")
def back_of_physical_edges(stage):
    physical_ball(stage, edges=True)
    look_inside(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def back_of_physical_summed(stage):
    physical_ball(stage, opacity=0.5)
    look_inside(stage)


@state("vtk")
def back_of_physical_textures(stage):
    """The texture of the base colour brings the opacity of both sides."""
    actor, plane = physical.ball(stage, ("base", "orm")), stage.vtk.vtkPlane()
    plane.SetNormal(1, 0.3, 0)
    actor.GetMapper().AddClippingPlane(plane)
    give_back(stage, actor)
    look_inside(stage)


@state("vtk")
def back_of_physical_in_image_light(stage):
    physical_ball(stage)
    physical.light_by_image(stage, True)
    look_inside(stage)


@state("vtk")
def physical_glyphs(stage):
    glyphs(stage, physically=True)
    look_inside(stage)


@state("vtk")
def physical_glyphs_both_sides(stage):
    glyphs(stage, physically=True, back=True)
    look_inside(stage)


@state("vtk")
def physical_glyphs_edges(stage):
    glyphs(stage, physically=True, edges=True)
    look_inside(stage)


@state("vtk")
def physical_glyphs_in_image_light(stage):
    glyphs(stage, physically=True)
    physical.light_by_image(stage, True)
    look_inside(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def physical_glyphs_peeled(stage):
    glyphs(stage, physically=True, opacity=0.5)
    looks.peel(stage)
    look_inside(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def physical_glyphs_summed(stage):
    glyphs(stage, physically=True, opacity=0.5)
    look_inside(stage)
