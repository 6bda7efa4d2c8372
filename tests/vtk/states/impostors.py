"""Impostors (spheres and discs that shaders cut out of flat billboards): every look of the mappers that draw them."""
import looks
import shapes
from registry import state


def spheres(stage, scale=None, color=True):
    mapper = stage.vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(shapes.cloud(stage.vtk))
    if scale:
        mapper.SetRadius(scale)
    else:
        mapper.SetScaleArray("radius")
    mapper.SetScalarVisibility(color)
    mapper.SetScalarRange(-1, 1)
    return mapper


@state("vtk")
def spheres_parallel(stage):
    stage.show(spheres(stage))
    looks.orbit_in_parallel(stage)


@state("vtk")
def spheres_near(stage):
    """The viewer among them: the near plane cuts billboards, and corners of billboards cut spheres."""
    stage.show(spheres(stage, 0.2))
    looks.from_among(stage, place=(0.35, 0.3, 0.5), clipping=(0.05, 5))


@state("vtk")
def sphere_around_viewer(stage):
    vtk = stage.vtk
    points, data, mapper = vtk.vtkPoints(), vtk.vtkPolyData(), vtk.vtkOpenGLSphereMapper()
    verts = vtk.vtkCellArray()
    for place in ((0, 0, 0), (0.6, 0.2, -2), (0, -0.3, 3)):
        verts.InsertNextCell(1)
        verts.InsertCellPoint(points.InsertNextPoint(*place))
    data.SetPoints(points)
    data.SetVerts(verts)
    mapper.SetInputData(data)
    mapper.SetRadius(1)
    actor = stage.show(mapper)
    actor.GetProperty().SetSpecular(0.6)
    actor.GetProperty().SetSpecularPower(20)
    camera = stage.renderer.GetActiveCamera()
    for place in ((0, 0, 2.2), (0, 0, 0.5), (0.3, 0, -0.4)):
        camera.SetPosition(*place)
        camera.SetFocalPoint(place[0], place[1] + 0.1, place[2] - 1)
        camera.SetClippingRange(0.1, 20)
        stage.shoot()


@state("vtk")
def spheres_stretched(stage):
    """Neither the actor nor the matrix that shifts far coordinates scales the radii."""
    actor = stage.show(spheres(stage))
    actor.SetScale(2, 1, 0.5)
    actor.RotateX(30)
    stage.look()
    stage.orbit(3)


def far_cloud(vtk, *filters):
    """The cloud of spheres(), each point rounded to 1/64: coordinates of 2e5 have no finer steps."""
    data = shapes.cloud(vtk)
    for away in filters:
        move, transform = vtk.vtkTransformPolyDataFilter(), vtk.vtkTransform()
        transform.Translate(away * 2e5, away * -1e5, away * 3e4)
        move.SetTransform(transform)
        move.SetInputData(data)
        move.Update()
        data = move.GetOutput()
    return data


@state("vtk")
def spheres_far_from_origin(stage):
    """This mapper sends the coordinates as they are. OpenGL multiplies them in single precision, so that its products are
    rounded by several pixels, in an order that it does not define: the real OpenGL draws them."""
    mapper = spheres(stage)
    mapper.SetInputData(far_cloud(stage.vtk, 1))
    stage.show(mapper)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_of_far_actor(stage):
    """The same spheres around an origin that the actor moves far away. VTK multiplies the matrices in double precision, so that
    they are drawn where they are."""
    mapper = spheres(stage)
    mapper.SetInputData(far_cloud(stage.vtk, 1, -1))
    stage.show(mapper, at=(2e5, -1e5, 3e4))
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_clipped(stage):
    """Planes remove whole spheres, by their centres."""
    mapper, plane = spheres(stage, 0.15), stage.vtk.vtkPlane()
    plane.SetNormal(1, 0.3, 0)
    mapper.AddClippingPlane(plane)
    stage.show(mapper)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_lit_by_lamps(stage):
    vtk, actor = stage.vtk, stage.show(spheres(stage, 0.2))
    actor.GetProperty().SetSpecular(0.5)
    actor.GetProperty().SetSpecularPower(12)
    looks.light_by_lamps(stage)
    light = vtk.vtkLight()
    light.SetPosition(0, -3, 1)
    light.SetColor(0.4, 0.4, 0.4)
    stage.renderer.AddLight(light)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_through_surface(stage):
    """Triangles and spheres, each before and behind the other."""
    stage.show(spheres(stage, 0.15))
    stage.show(shapes.sphere(stage.vtk, 48, 0.45), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_recolored(stage):
    mapper = spheres(stage)
    actor = stage.show(mapper)
    stage.look()
    stage.shoot()
    mapper.ScalarVisibilityOff()
    actor.GetProperty().SetColor(0.2, 0.8, 0.3)
    stage.shoot()
    mapper.SetRadius(0.3)
    mapper.SetScaleArray(None)
    stage.shoot()
    actor.GetProperty().SetOpacity(0.5)
    stage.shoot()


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def spheres_peeled(stage):
    """Translucent spheres and surfaces in one peel, and opaque spheres behind them."""
    looks.peel(stage)
    stage.show(spheres(stage, 0.15))
    stage.show(spheres(stage, 0.25)).GetProperty().SetOpacity(0.4)
    stage.show(shapes.sphere(stage.vtk, 48, 0.45), color=(0.3, 0.5, 0.9)).GetProperty().SetOpacity(0.5)
    stage.look()
    stage.orbit(3)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def spheres_summed(stage):
    """The same without peeling: weighted blending."""
    stage.show(spheres(stage, 0.15))
    stage.show(spheres(stage, 0.25)).GetProperty().SetOpacity(0.4)
    stage.show(shapes.sphere(stage.vtk, 48, 0.45), color=(0.3, 0.5, 0.9)).GetProperty().SetOpacity(0.5)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_picked(stage):
    stage.show(spheres(stage, 0.2))
    looks.shoot_and_pick(stage)


@state("vtk")
def spheres_steady(stage):
    stage.show(spheres(stage))
    stage.look()
    stage.steady_orbit()


@state("vtk")
def spheres_multisampled(stage):
    stage.window.SetMultiSamples(4)
    stage.show(spheres(stage, 0.2))
    stage.show(shapes.sphere(stage.vtk, 48, 0.45), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(2)
