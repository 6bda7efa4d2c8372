"""Lines as tubes and points as spheres, sized in pixels: every look of their mappers."""
import looks
import numpy as np
import shapes
from registry import state


def tubes(stage, source=None, width=6, color=(0.9, 0.6, 0.3)):
    """The edges of a surface as tubes."""
    actor = stage.show(source or shapes.sphere(stage.vtk, 12), color=color)
    look = actor.GetProperty()
    look.SetRepresentationToWireframe()
    look.RenderLinesAsTubesOn()
    look.SetLineWidth(width)
    return actor


def beads(stage, source=None, size=9, color=(0.9, 0.6, 0.3)):
    """The points of a surface as spheres."""
    actor = stage.show(source or shapes.sphere(stage.vtk, 12), color=color)
    look = actor.GetProperty()
    look.SetRepresentationToPoints()
    look.RenderPointsAsSpheresOn()
    look.SetPointSize(size)
    return actor


def both(stage, width=6, size=14):
    tubes(stage, width=width)
    beads(stage, shapes.sphere(stage.vtk, 8, 0.6), size=size, color=(0.4, 0.7, 0.9))


@state("vtk")
def tubes_alone(stage):
    tubes(stage)
    stage.look()
    stage.orbit(3)


@state("vtk")
def beads_alone(stage):
    beads(stage)
    stage.look()
    stage.orbit(3)


@state("vtk")
def pixels_parallel(stage):
    both(stage)
    looks.orbit_in_parallel(stage)


@state("vtk")
def pixels_upright(stage):
    """Lines and points at the centres of pixels and on their borders."""
    tubes(stage, shapes.grid(stage.vtk, 6), width=5)
    beads(stage, shapes.grid(stage.vtk, 4), size=8, color=(0.4, 0.7, 0.9))
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.renderer.ResetCamera()
    stage.renderer.GetActiveCamera().SetParallelScale(1.5)
    stage.orbit(2, 90)


@state("vtk")
def pixels_near(stage):
    """The viewer among them: lines are cut by the near plane, or end behind the viewer."""
    both(stage)
    looks.from_among(stage, place=(0.35, 0.3, 0.45), clipping=(0.02, 5))


@state("vtk")
def pixels_at_the_border(stage):
    """Clipping removes points whose centre is outside, and cuts lines."""
    both(stage)
    stage.look(zoom=2.5)
    stage.orbit(2)


@state("vtk")
def pixels_thick(stage):
    """Thicker than long, so that lines grow at their ends."""
    both(stage, width=25, size=40.5)
    stage.look()
    stage.orbit(2)


@state("vtk")
def pixels_thin(stage):
    both(stage, width=1.5, size=2)
    stage.look()
    stage.orbit(2)


@state("vtk")
def pixels_clipped(stage):
    plane = stage.vtk.vtkPlane()
    plane.SetNormal(1, 0.3, 0.1)
    both(stage)
    for actor in stage.renderer.GetActors():
        actor.GetMapper().AddClippingPlane(plane)
    stage.look()
    stage.orbit(3)


@state("vtk")
def pixels_on_surfaces(stage):
    """Half inside triangles and each other."""
    both(stage)
    stage.show(shapes.sphere(stage.vtk, 12), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(3)


def spirals(vtk, count=12, steps=40):
    """Lines that share no segment."""
    points, lines = vtk.vtkPoints(), vtk.vtkCellArray()
    for i in range(count):
        lines.InsertNextCell(steps)
        for t in np.linspace(0, 6, steps):
            at = (0.1 + 0.04 * i) * np.array([np.cos(t + i), np.sin(t + i)])
            lines.InsertCellPoint(points.InsertNextPoint(*at, 0.1 * t + 0.02 * np.sin(3 * i)))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetPointData().SetScalars(shapes.array([np.sin(0.1 * i) for i in range(count * steps)], "bump"))
    return data


def colored(stage, add, cells):
    data = spirals(stage.vtk) if add is tubes else shapes.grid(stage.vtk, 10)
    if cells:
        data.GetCellData().SetScalars(shapes.array(np.arange(data.GetNumberOfCells()) % 7, "kind"))
    else:
        data.GetPointData().SetActiveScalars("bump")
    mapper = add(stage, data).GetMapper()
    mapper.SetScalarRange(*((0, 6) if cells else (-0.5, 0.5)))
    return mapper


@state("vtk")
def pixels_colored_by_points(stage):
    colored(stage, tubes, False)
    stage.look()
    stage.orbit(2)
    stage.renderer.RemoveAllViewProps()
    colored(stage, beads, False).InterpolateScalarsBeforeMappingOn()
    stage.orbit(2)
    stage.renderer.RemoveAllViewProps()
    colored(stage, tubes, False).InterpolateScalarsBeforeMappingOn()
    stage.orbit(2)


@state("vtk")
def pixels_colored_by_cells(stage):
    colored(stage, tubes, True)
    stage.look()
    stage.orbit(2)
    stage.renderer.RemoveAllViewProps()
    colored(stage, beads, True)
    stage.orbit(2)


@state("vtk")
def pixels_lit_by_lamps(stage):
    both(stage)
    for actor in stage.renderer.GetActors():
        actor.GetProperty().SetSpecular(0.6)
        actor.GetProperty().SetSpecularPower(15)
    looks.light_by_lamps(stage)
    stage.look()
    stage.orbit(3)


@state("vtk")
def pixels_without_light(stage):
    both(stage)
    for actor in stage.renderer.GetActors():
        actor.GetProperty().LightingOff()
    stage.look()
    stage.orbit(2)


@state("vtk")
def pixels_scaled(stage):
    """Neither the actor's scale nor far coordinates change their size."""
    both(stage)
    for actor in stage.renderer.GetActors():
        actor.SetScale(2e3, 1e3, 5e2)
        actor.AddPosition(1e5, -2e5, 3e4)
        actor.RotateX(30)
    stage.look()
    stage.orbit(3)


def pushed_forward(stage, slope):
    vtk = stage.vtk
    mapper = vtk.vtkMapper
    before = mapper.GetResolveCoincidentTopology()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    both(stage)
    for actor in stage.renderer.GetActors():
        actor.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(slope, -400)
        actor.GetMapper().SetRelativeCoincidentTopologyPointOffsetParameter(-400)
    stage.show(shapes.sphere(vtk, 12, 0.503), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(2)
    mapper.SetResolveCoincidentTopology(before)


@state("vtk")
def pixels_pushed_forward(stage):
    """Coincident topology resolved by a constant: lines and points move towards the viewer."""
    pushed_forward(stage, 0)


@state("vtk")
def pixels_pushed_by_their_slope(stage):
    """VTK reads the slope of gl_FragDepth before it writes it: left to the real OpenGL."""
    pushed_forward(stage, 1)


@state("vtk")
def tubes_multisampled(stage):
    stage.window.SetMultiSamples(4)
    tubes(stage)
    stage.look()
    stage.orbit(2)


@state("vtk")
def pixels_changed(stage):
    """Size and colour change between frames, without new geometry."""
    both(stage)
    stage.look()
    stage.shoot()
    for actor in stage.renderer.GetActors():
        actor.GetProperty().SetLineWidth(3)
        actor.GetProperty().SetPointSize(20)
        actor.GetProperty().SetColor(0.3, 0.8, 0.4)
    stage.shoot()
    stage.window.SetSize(320, 280)
    stage.shoot()


@state("vtk")
def pixels_steady(stage):
    both(stage)
    stage.look()
    stage.steady_orbit()


@state("vtk")
def pixels_picked(stage):
    both(stage)
    looks.shoot_and_pick(stage)


@state("vtk")
def beads_multisampled(stage):
    """Left to the real OpenGL."""
    stage.window.SetMultiSamples(4)
    beads(stage)
    stage.look()
    stage.orbit(2)


@state("vtk")
def edges_as_tubes(stage):
    look = stage.show(shapes.sphere(stage.vtk, 12)).GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.2, 0.7, 0.3)
    look.RenderLinesAsTubesOn()
    look.SetLineWidth(5)
    stage.look()
    stage.orbit(3)
