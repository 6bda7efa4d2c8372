"""Spheres, sticks and discs that shaders cut out of flat cards: every look of the mappers that draw them."""
import numpy as np
import shapes
from registry import state


def cloud(stage, n=8, size=0.4):
    data = shapes.grid(stage.vtk, n, size)
    count = data.GetNumberOfPoints()
    data.GetPointData().AddArray(shapes.array([0.05 + 0.01 * (i % 5) for i in range(count)], "radius", np.float32))
    data.GetPointData().SetActiveScalars("bump")
    return data


def spheres(stage, scale=None, color=True):
    mapper = stage.vtk.vtkOpenGLSphereMapper()
    mapper.SetInputData(cloud(stage))
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
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_near(stage):
    """The viewer among them: the cards are cut off by the near plane, and corners of cards cut spheres."""
    stage.show(spheres(stage, 0.2))
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.35, 0.3, 0.5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(0.05, 5)
    for degrees in (0, 40, 160):
        camera.Azimuth(degrees)
        stage.shoot()


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
    """Radii are not scaled by the actor, nor by the matrix that far coordinates are brought near with."""
    actor = stage.show(spheres(stage))
    actor.SetScale(2, 1, 0.5)
    actor.RotateX(30)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_far_from_origin(stage):
    vtk, mapper = stage.vtk, spheres(stage)
    move, transform = vtk.vtkTransformPolyDataFilter(), vtk.vtkTransform()
    transform.Translate(2e5, -1e5, 3e4)
    move.SetTransform(transform)
    move.SetInputData(cloud(stage))
    mapper.SetInputConnection(move.GetOutputPort())
    stage.show(mapper)
    stage.look()
    stage.orbit(3)


@state("vtk")
def spheres_clipped(stage):
    """Planes take whole spheres away, by their centres."""
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
    stage.renderer.AutomaticLightCreationOff()
    for place, cone, color in (((2, 1, 2), 180, (1, 0.8, 0.6)), ((-1, 2, 2), 40, (0.4, 0.7, 1))):
        light = vtk.vtkLight()
        light.SetPosition(*place)
        light.SetFocalPoint(0, 0, 0)
        light.SetPositional(True)
        light.SetConeAngle(cone)
        light.SetColor(*color)
        light.SetLightTypeToSceneLight()
        stage.renderer.AddLight(light)
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


def peel(stage):
    stage.renderer.SetUseDepthPeeling(True)
    stage.renderer.SetMaximumNumberOfPeels(16)
    stage.window.SetAlphaBitPlanes(True)


@state("vtk", outside=False, reason="what is seen through has no depth")
def spheres_peeled(stage):
    """Translucent spheres and surfaces in one peel, and opaque spheres behind them."""
    peel(stage)
    stage.show(spheres(stage, 0.15))
    stage.show(spheres(stage, 0.25)).GetProperty().SetOpacity(0.4)
    stage.show(shapes.sphere(stage.vtk, 48, 0.45), color=(0.3, 0.5, 0.9)).GetProperty().SetOpacity(0.5)
    stage.look()
    stage.orbit(3)


@state("vtk", outside=False, reason="what is seen through has no depth")
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
    stage.look()
    stage.shoot()
    stage.keep_selected((200, 150), (230, 120), (10, 10))
    stage.shoot()


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


def sticks(stage, radius=0.08):
    vtk, data = stage.vtk, cloud(stage, 5, 0.8)
    n = data.GetNumberOfPoints()
    ways = [(np.sin(i), np.cos(2.3 * i), np.sin(0.7 * i + 1)) for i in range(n)]
    ways[0] = (0, 0, 1)
    data.GetPointData().AddArray(shapes.array(ways, "way", np.float32))
    data.GetPointData().AddArray(shapes.array([(0.3 + 0.1 * (i % 4), radius, radius) for i in range(n)], "size", np.float32))
    data.GetPointData().AddArray(shapes.array(range(n), "number", np.uint8))
    mapper = vtk.vtkOpenGLStickMapper()
    mapper.SetInputData(data)
    mapper.SetOrientationArray("way")
    mapper.SetScaleArray("size")
    mapper.SetSelectionIdArray("number")
    mapper.SetScalarRange(-1, 1)
    return mapper


@state("vtk")
def sticks_colored(stage):
    stage.show(sticks(stage))
    stage.look()
    stage.orbit(3)


@state("vtk")
def sticks_parallel(stage):
    stage.show(sticks(stage))
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.look()
    stage.orbit(3)


@state("vtk")
def sticks_near(stage):
    stage.show(sticks(stage, 0.2))
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.4, 0.5, 1.2)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(0.1, 8)
    for degrees in (0, 40, 160):
        camera.Azimuth(degrees)
        stage.shoot()


@state("vtk")
def sticks_turned(stage):
    actor = stage.show(sticks(stage))
    actor.RotateWXYZ(70, 1, 2, 3)
    actor.GetProperty().SetSpecular(0.5)
    stage.look()
    stage.orbit(3)


def molecule(stage, settings):
    vtk = stage.vtk
    made, mapper = vtk.vtkMolecule(), vtk.vtkMoleculeMapper()
    atoms = [made.AppendAtom(6 + i % 3, 1.3 * np.cos(i), 1.3 * np.sin(i), 0.35 * i) for i in range(20)]
    for a, b in zip(atoms, atoms[1:]):
        made.AppendBond(a, b, 1 + a.GetId() % 3)
    mapper.SetInputData(made)
    getattr(mapper, f"Use{settings}Settings")()
    return stage.show(mapper)


@state("vtk", outside=False, reason="what is seen through has no depth")
def molecule_peeled(stage):
    peel(stage)
    molecule(stage, "BallAndStick").GetProperty().SetOpacity(0.4)
    stage.show(shapes.sphere(stage.vtk, 48, 1.2), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(3)


@state("vtk")
def molecule_ball_and_stick(stage):
    molecule(stage, "BallAndStick")
    stage.look()
    stage.orbit(3)


@state("vtk")
def molecule_liquorice(stage):
    molecule(stage, "LiquoriceStick")
    stage.look(zoom=1.5)
    stage.orbit(3)


@state("vtk")
def molecule_filling_space(stage):
    molecule(stage, "VDWSpheres")
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.look()
    stage.orbit(3)


def points_of(stage, preset, **properties):
    stage.show(stage.simple.Sphere(ThetaResolution=20, PhiResolution=20), Representation="Point Gaussian", GaussianRadius=0.05,
               ShaderPreset=preset, **properties)
    stage.look()


@state("pvbatch")
def round_shades_colored(stage):
    stage.show(stage.simple.Wavelet(WholeExtent=[-3, 3] * 3), Representation="Point Gaussian", GaussianRadius=0.4,
               ShaderPreset="Sphere", color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def round_shades_parallel(stage):
    points_of(stage, "Sphere")
    stage.view.CameraParallelProjection = 1
    stage.look()
    stage.orbit(3)


@state("pvbatch", outside=False, reason="where discs cross, roundings decide")
def round_shades_near(stage):
    points_of(stage, "Sphere", DiffuseColor=[0.3, 0.7, 0.4])
    camera = stage.view.GetActiveCamera()
    camera.SetPosition(0.1, 0.2, 0.7)
    camera.SetFocalPoint(0, 0, 0)
    stage.view.GetRenderer().ResetCameraClippingRange()
    stage.orbit(3)


@state("pvbatch")
def round_shades_steady(stage):
    points_of(stage, "Sphere")
    stage.steady_orbit()


@state("pvbatch")
def gaussians_of_other_presets(stage):
    """None of them is for tracing: they blend, or are no figures we know."""
    for preset in ("Gaussian Blur", "Black-edged circle", "Triangle", "Square Outline"):
        points_of(stage, preset)
        stage.shoot()
        stage.simple.Delete(stage.simple.GetActiveSource())
