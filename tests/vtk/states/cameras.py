"""Cameras and spaces: projections, large coordinates, clip planes, the camera inside the model."""
import numpy as np
import shapes
from registry import state


@state("pvbatch")
def parallel_projection(stage):
    stage.show(stage.simple.Superquadric(ThetaResolution=40, PhiResolution=40))
    stage.look()
    stage.view.CameraParallelProjection = 1
    stage.orbit(3)


@state("pvbatch")
def parallel_projection_no_normals(stage):
    stage.show(stage.simple.Box())
    stage.show(stage.simple.Cone(Resolution=9, Center=[1, 0, 0]))
    stage.look()
    stage.view.CameraParallelProjection = 1
    stage.orbit()


@state("pvbatch")
def camera_inside(stage):
    stage.show(stage.simple.Sphere(Radius=10, ThetaResolution=32, PhiResolution=32))
    stage.show(stage.simple.Box(Center=[0, 0, -5]))
    stage.look()
    camera = stage.view.GetActiveCamera()
    camera.SetPosition(0, 1, 2)
    camera.SetFocalPoint(0, 0, -5)
    stage.view.GetRenderer().ResetCameraClippingRange()
    stage.orbit(3, 40)


@state("pvbatch")
def near_plane_cuts(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32))
    stage.look()
    camera = stage.view.GetActiveCamera()
    distance = camera.GetDistance()
    renderer = stage.view.GetRenderer()
    stage.shoot()
    camera.SetClippingRange(distance - 0.3, distance + 0.1)
    renderer.GetRenderWindow().Render()  # ParaView's own Render would put the range back
    stage.read(stage.view.GetRenderWindow())


@state("pvbatch", outside=False)  # the axes' corner has no depth, but shows the surface behind it
def zoomed_far_in(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=200, PhiResolution=200))
    stage.look(zoom=1)
    stage.view.GetActiveCamera().SetViewAngle(0.8)
    stage.orbit(2, 3)


def far_away(stage, place):
    stage.show(stage.simple.Sphere(Center=place, ThetaResolution=32, PhiResolution=32))
    stage.show(stage.simple.Cone(Center=[place[0] + 1, place[1], place[2]], Resolution=20), DiffuseColor=[0.9, 0.7, 0.2])
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def coordinates_of_a_million(stage):
    far_away(stage, [1e6, -2e6, 5e5])


@state("pvbatch")
def coordinates_of_a_hundred_thousand(stage):
    far_away(stage, [1e5, 2e5, 0])


@state("pvbatch")
def tiny_model(stage):
    stage.show(stage.simple.Sphere(Radius=1e-6, ThetaResolution=32, PhiResolution=32))
    stage.look()
    stage.orbit()


@state("pvbatch")
def huge_model(stage):
    stage.show(stage.simple.Sphere(Radius=1e7, ThetaResolution=32, PhiResolution=32))
    stage.look()
    stage.orbit()


@state("vtk", beyond=0.0025, reason="coordinates of 10,000 in a view of ten units: the real OpenGL's floats are rounded too")
def shifted_and_scaled(stage):
    """The same data with each of VTK's methods for shifting large coordinates before they are uploaded."""
    vtk = stage.vtk
    modes = ("DISABLE_SHIFT_SCALE", "AUTO_SHIFT_SCALE", "ALWAYS_AUTO_SHIFT_SCALE", "AUTO_SHIFT")
    for i, mode in enumerate(modes):
        data = shapes.grid(vtk, 16)
        move = vtk.vtkTransform()
        move.Translate(2.2 * i + 1e4, 0, 0)
        move.Scale(1, 1, 0.5 + i)
        moved = vtk.vtkTransformPolyDataFilter()
        moved.SetTransform(move)
        moved.SetInputData(data)
        actor = stage.show(moved)
        actor.GetMapper().SetVBOShiftScaleMethod(getattr(vtk.vtkOpenGLVertexBufferObject, mode, i))
        actor.SetScale(1, 1 + 0.2 * i, 1)
    stage.look()
    stage.orbit(3)


@state("vtk")
def mirrored_and_sheared(stage):
    """Actors whose matrices turn the surface inside out."""
    vtk = stage.vtk
    for i, values in enumerate(((-1, 1, 1), (1, -1, -1), (-1, -1, -1), (3, 0.2, 1))):
        actor = stage.show(shapes.sphere(vtk, 24), at=(1.2 * i, 0, 0))
        actor.SetScale(*values)
        actor.RotateWXYZ(40, 1, 2, 3)
    matrix = vtk.vtkMatrix4x4()
    matrix.DeepCopy((1, 0.6, 0, 0, 0, 1, 0.4, 1.5, 0, 0, 1, 0, 0, 0, 0, 1))
    stage.show(vtk.vtkCubeSource(), color=(0.4, 0.6, 0.9)).SetUserMatrix(matrix)
    stage.look()
    stage.orbit()


@state("vtk")
def clip_planes(stage):
    vtk = stage.vtk
    mapper = stage.mapper(shapes.sphere(vtk, 32))
    for normal, origin in (((1, 0, 0.2), (-0.1, 0, 0)), ((0, 1, 0), (0, -0.2, 0))):
        plane = vtk.vtkPlane()
        plane.SetNormal(*normal)
        plane.SetOrigin(*origin)
        mapper.AddClippingPlane(plane)
    stage.show(mapper)
    stage.show(shapes.sphere(vtk, 32, 0.2), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(3)


@state("vtk")
def clip_plane_moves(stage):
    vtk = stage.vtk
    mapper, plane = stage.mapper(shapes.sphere(vtk, 32)), vtk.vtkPlane()
    plane.SetNormal(0.5, 0.5, -0.2)
    mapper.AddClippingPlane(plane)
    stage.show(mapper)
    stage.look()
    for i in range(3):
        plane.SetOrigin(0.15 * i - 0.1, 0, 0)
        stage.shoot()


@state("vtk")
def off_axis(stage):
    stage.show(shapes.sphere(stage.vtk, 32))
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetWindowCenter(0.4, -0.3)
    camera.SetViewShear(0.2, 0.1, 1)
    stage.orbit()


@state("vtk")
def explicit_projection(stage):
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    stage.look()
    camera, matrix = stage.renderer.GetActiveCamera(), vtk.vtkMatrix4x4()
    near, far = 0.5, 20
    matrix.DeepCopy((2.2, 0, 0.1, 0, 0, 3, 0, 0, 0, 0, -(far + near) / (far - near), -2 * far * near / (far - near), 0, 0, -1, 0))
    camera.UseExplicitProjectionTransformMatrixOn()
    camera.SetExplicitProjectionTransformMatrix(matrix)
    stage.orbit()


@state("vtk")
def wide_angle(stage):
    for i in range(5):
        stage.show(shapes.sphere(stage.vtk, 24), at=(1.2 * np.cos(i), 1.2 * np.sin(i), 0.3 * i))
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetViewAngle(120)
    camera.SetPosition(0, 0, 2)
    camera.SetFocalPoint(0, 0, 0)
    stage.renderer.ResetCameraClippingRange()
    stage.orbit()
