"""Volumes with tables of two coordinates: transfer functions of scalars and gradients, or of scalars and labels. volumes.py says how they
are compared."""
import numpy as np
import shapes
from registry import state
from volume_lights import add_light
from volume_parts import add_plane, turned
from volume_shapes import field, gradient_opacity, image_of, show, sphere_inside, volumes

newer = state(("newer_vtk",), outside=False, close=True)


def table_of(vtk, size=(64, 48), factor=1, smooth=False):
    """Opacities grow with gradients. Unless it is `smooth`, some scalars are invisible; VTK's scaling makes opacities below 0 beside
    those."""
    u, v = np.meshgrid(np.linspace(0, 1, size[0]), np.linspace(0, 1, size[1]))
    opacity = np.where(u > 0.4, 0.15 * (v + 0.2), np.where(np.abs(u - 0.3) < 0.05, 0.3 * v * v, 0)) * factor
    if smooth:
        opacity = 0.2 + 0.3 * u * v
    image = vtk.vtkImageData()
    image.SetDimensions(*size, 1)
    values = np.stack([u, v, 1 - u, opacity], 2)
    image.GetPointData().SetScalars(shapes.array(values.reshape(-1, 4), "values", np.float32))
    return image


def with_table(stage, kind=np.float32, shade=False, blend="Composite", **table):
    values = field() if kind == np.float32 else np.clip((field() + 1.5) * 80, 0, 255)
    volume = show(stage, image_of(stage.vtk, values, kind), shade=shade, blend=blend)
    volume.GetProperty().SetTransferFunction2D(table_of(stage.vtk, **table))
    volume.GetProperty().SetTransferFunctionMode(1)
    return volume


@volumes
def volume_by_scalar_and_gradient(stage):
    turned(stage, with_table(stage))


@volumes
def volume_by_scalar_and_gradient_lit(stage):
    turned(stage, with_table(stage, np.uint8, shade=True))


@volumes
def volume_by_scalar_and_gradient_around_sphere(stage):
    sphere_inside(stage)
    volume = with_table(stage, factor=2)
    add_plane(stage, volume, (1, 0.3, 0))
    turned(stage, volume)


@volumes
def volume_by_scalar_and_gradient_changes(stage):
    volume = turned(stage, with_table(stage, size=(5, 3)))
    volume.GetProperty().SetTransferFunction2D(table_of(stage.vtk, factor=4))
    stage.shoot()


@volumes
def volume_by_scalar_and_gradient_nearest(stage):
    volume = with_table(stage, np.int16, size=(16, 8))
    volume.GetProperty().SetInterpolationTypeToNearest()
    turned(stage, volume)


@volumes
def volume_by_scalar_and_gradient_sliced(stage):
    volume = with_table(stage, blend="Slice", smooth=True)
    plane = stage.vtk.vtkPlane()
    plane.SetNormal(0.5, 0.8, 0.3)
    volume.GetProperty().SetSliceFunction(plane)
    turned(stage, volume)


@newer
def volume_by_scalar_and_gradient_lit_from_the_side(stage):
    """VTK 9.1 lights them in a way of its own."""
    add_light(stage, (3, 2, 1), (1, 0.8, 0.5))
    turned(stage, with_table(stage, shade=True))


def labelled(stage, shade=False, share=1.0):
    """Labels 0 to 3 in quarters of a volume; label 2 has no functions of its own."""
    values = field()
    volume = show(stage, image_of(stage.vtk, values), shade=shade)
    z, y, x = np.meshgrid(*(np.linspace(-1, 1, n) for n in values.shape), indexing="ij")
    labels = np.where(x > 0, 1, 0) + np.where(y > 0.2, 2, 0)
    mapper, look = volume.GetMapper(), volume.GetProperty()
    mapper.SetMaskInput(image_of(stage.vtk, labels, np.uint8))
    mapper.SetMaskTypeToLabelMap()
    mapper.SetMaskBlendFactor(share)
    low, high = values.min(), values.max()
    for label in (1, 3):
        color, opacity = stage.vtk.vtkColorTransferFunction(), stage.vtk.vtkPiecewiseFunction()
        color.AddRGBPoint(low, 0.3 * label, 1, 0)
        color.AddRGBPoint(high, 1, 0.2 * label, 0.4)
        for at, a in (low, 0), ((low + high) / 2, 0.08 * label), (high, 0.3):
            opacity.AddPoint(at, a)
        look.SetLabelColor(label, color)
        look.SetLabelScalarOpacity(label, opacity)
    return volume


@volumes
def volume_labelled(stage):
    turned(stage, labelled(stage))


@volumes
def volume_labelled_lit(stage):
    volume = turned(stage, labelled(stage, shade=True))
    gradient_opacity(stage, volume)
    stage.shoot()


@volumes
def volume_labelled_in_part(stage):
    volume = turned(stage, labelled(stage, shade=True, share=0.6))
    volume.GetMapper().SetMaskBlendFactor(0)
    stage.shoot()


@volumes
def volume_labelled_and_cropped(stage):
    sphere_inside(stage)
    mapper = labelled(stage, share=0.3).GetMapper()
    mapper.CroppingOn()
    mapper.SetCroppingRegionPlanes(-0.4, 0.5, -0.5, 0.3, -0.3, 0.6)
    mapper.SetCroppingRegionFlags(0x2ebfeba)
    turned(stage, mapper)
