"""What the states of volumes share. Functions are given the stage, or its vtk module."""
import numpy as np
import shapes
from registry import state

PROGRAMS = ("vtk", "newer_vtk")
volumes = state(PROGRAMS, outside=False, close=True)


def field(shape=(24, 20, 28)):
    """A smooth field over a grid of points, z first."""
    z, y, x = np.meshgrid(*(np.linspace(-1, 1, n) for n in shape), indexing="ij")
    return np.sin(6 * x) * np.cos(5 * y) * np.sin(4 * z) + 1.5 * np.exp(-3 * (x * x + y * y + z * z))


def image_of(vtk, values, kind=np.float32, spacing=None):
    """vtkImageData over the cube from -1 to 1, or with a spacing of its own."""
    image = vtk.vtkImageData()
    size = values.shape[::-1]
    image.SetDimensions(*size)
    image.SetSpacing(*(spacing or (2 / (n - 1) for n in size)))
    image.SetOrigin(*(spacing and (0, 0, 0) or (-1, -1, -1)))
    scalars = shapes.array(values.ravel(), "values", kind)
    if kind == np.int8:  # as numbers of a type that VTK draws
        scalars, chars = vtk.vtkSignedCharArray(), scalars
        scalars.DeepCopy(chars)
    image.GetPointData().SetScalars(scalars)
    return image


def property_of(vtk, low, high, shade=False):
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for at, rgb in (0, (0, 0, 1)), (0.5, (1, 1, 1)), (1, (1, 0, 0)):
        color.AddRGBPoint(low + at * (high - low), *rgb)
    for at, a in (0, 0), (0.4, 0), (0.6, 0.3), (1, 0.9):
        opacity.AddPoint(low + at * (high - low), a)
    look = vtk.vtkVolumeProperty()
    look.SetColor(color)
    look.SetScalarOpacity(opacity)
    look.SetInterpolationTypeToLinear()
    look.SetScalarOpacityUnitDistance(0.1)
    look.SetShade(shade)
    return look


def show(stage, image, shade=False, blend="Composite", at=(0, 0, 0), sample=0.05):
    """The vtkVolume of an image."""
    vtk = stage.vtk
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(sample)
    getattr(mapper, f"SetBlendModeTo{blend}")()
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(property_of(vtk, *image.GetPointData().GetScalars().GetRange(), shade))
    volume.SetPosition(*at)
    stage.renderer.AddVolume(volume)
    return volume


def simple(stage, **how):
    """A volume that is looked at from two sides."""
    volume = show(stage, image_of(stage.vtk, field()), **how)
    stage.look()
    stage.orbit()
    return volume


def sphere_inside(stage):
    stage.show(shapes.sphere(stage.vtk, 32), color=(0.9, 0.8, 0.2), at=(0.4, 0.2, 0.3))


def gradient_opacity(stage, volume):
    function = stage.vtk.vtkPiecewiseFunction()
    function.AddPoint(0, 0)
    function.AddPoint(0.6, 1)
    volume.GetProperty().SetGradientOpacity(function)
