"""The edges of surfaces, painted by VTK's shaders."""
import shapes
from registry import state


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
    """Coplanar neighbours that face the viewer: where they grow over each other their depths are equal."""
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
    """The inside of a ball through its culled front, and the front with the back culled."""
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
    """Surfaces at nearly equal depth; the mapper moves one of them, with edges, back."""
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
    """Left to the real OpenGL: near the viewer's plane triangles may grow by any number of pixels."""
    edged(stage, width=3)
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.1, 0.1, 0.2)
    camera.SetFocalPoint(0.4, 0.3, 0)
    camera.SetClippingRange(0.01, 5)
    stage.orbit(2)


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
