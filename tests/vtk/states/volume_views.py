"""Volumes: cameras, surfaces in them, changes from frame to frame, windows. volumes.py says how they are compared."""
import numpy as np
import shapes
from volume_shapes import field, image_of, show, simple, sphere_inside, volumes


@volumes
def volume_around_sphere(stage):
    sphere_inside(stage)
    simple(stage)


@volumes
def volume_parallel_projection(stage):
    show(stage, image_of(stage.vtk, field()), shade=True)
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.look()
    stage.orbit()


@volumes
def volume_around_sphere_maximum(stage):
    sphere_inside(stage)
    simple(stage, blend="MaximumIntensity")


@volumes
def volume_camera_inside(stage):
    show(stage, image_of(stage.vtk, field()))
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(0.3, 0.2, 0.1)
    camera.SetFocalPoint(-1, 0, 0)
    stage.renderer.ResetCameraClippingRange()
    stage.orbit(3, 40)


@volumes
def volume_camera_straight_on(stage):
    """The diagonals of the box's faces lie on the centres of pixels."""
    stage.window.SetSize(300, 300)
    show(stage, image_of(stage.vtk, field((16, 16, 16))))
    stage.look(azimuth=0, elevation=0)
    stage.orbit(2, 90)


@volumes
def volume_near_plane_cuts(stage):
    show(stage, image_of(stage.vtk, field()), shade=True)
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetClippingRange(camera.GetDistance() - 0.4, camera.GetDistance() + 0.6)
    stage.shoot()


@volumes
def volume_anisotropic(stage):
    show(stage, image_of(stage.vtk, field((9, 33, 17)), spacing=(0.05, 0.11, 0.4)), shade=True)
    stage.look()
    stage.orbit()


@volumes
def volume_turned_and_scaled(stage):
    volume = show(stage, image_of(stage.vtk, field()), shade=True)
    volume.SetOrientation(30, 40, 50)
    volume.SetScale(1.5, 0.7, 1)
    stage.look()
    stage.orbit()


@volumes
def volume_behind_another(stage):
    show(stage, image_of(stage.vtk, field()), at=(-0.8, 0, 0))
    show(stage, image_of(stage.vtk, -field((10, 30, 20))), at=(0.9, 0.3, -2.5), shade=True)
    stage.look()
    stage.orbit(3, 50)


@volumes
def volume_functions_change(stage):
    look = simple(stage).GetProperty()
    look.GetScalarOpacity().AddPoint(0, 0.5)
    stage.shoot()
    look.GetRGBTransferFunction().AddRGBPoint(0, 0, 1, 0)
    stage.shoot()
    look.GetScalarOpacity().RemoveAllPoints()
    look.GetScalarOpacity().AddPoint(0.6, 0)
    look.GetScalarOpacity().AddPoint(0.7, 0.8)
    stage.shoot()
    look.ShadeOn()
    stage.shoot()


@volumes
def volume_voxels_change(stage):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    image = image_of(stage.vtk, field())
    show(stage, image)
    stage.look()
    stage.shoot()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    values[:] = np.roll(values, len(values) // 3)
    image.GetPointData().GetScalars().Modified()
    image.Modified()
    stage.shoot()
    values[len(values) // 2:] = -1
    image.GetPointData().GetScalars().Modified()
    image.Modified()
    stage.shoot()


@volumes
def volume_sphere_moves(stage):
    ball = stage.show(shapes.sphere(stage.vtk, 32), at=(0.4, 0.2, 0.3))
    simple(stage)
    ball.SetPosition(-0.5, 0, 0.5)
    stage.shoot()
    ball.VisibilityOff()
    stage.shoot()


@volumes
def volume_window_reduced(stage):
    """VTK casts rays for fewer pixels and enlarges the picture."""
    volume = show(stage, image_of(stage.vtk, field()), shade=True)
    volume.GetMapper().SetImageSampleDistance(2)
    stage.look()
    stage.orbit()


@volumes
def volume_window_resized(stage):
    simple(stage)
    stage.window.SetSize(250, 200)
    stage.orbit()


@volumes
def volume_in_viewports(stage):
    stage.renderer.SetViewport(0.1, 0.2, 0.55, 0.9)
    simple(stage)
    stage.renderer = stage.new_renderer((0.55, 0, 1, 0.7), (0.4, 0.2, 0.1))
    show(stage, image_of(stage.vtk, -field()), shade=True)
    stage.look()
    stage.orbit()


@volumes
def volume_multisampled(stage):
    stage.window.SetMultiSamples(4)
    sphere_inside(stage)
    simple(stage)
