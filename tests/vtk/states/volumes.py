"""Volume rendering (vtkGPUVolumeRayCastMapper): how samples become colours, light, types of data.

Volumes write no depth. Their pictures must be closer than those of surfaces (registry.State.close): other pixels differ where
rounding decides whether the box covers a pixel, which of two voxels is the nearest one, and whether a sample is in the range that
is averaged. Shaders differ between versions of VTK, so that two versions draw the states.
"""
import numpy as np
import shapes
from volume_shapes import field, gradient_opacity, image_of, property_of, show, simple, volumes


@volumes
def volume_composite(stage):
    simple(stage)


@volumes
def volume_shaded(stage):
    simple(stage, shade=True)


@volumes
def volume_shaded_highlights(stage):
    look = show(stage, image_of(stage.vtk, field()), shade=True).GetProperty()
    look.SetAmbient(0.2)
    look.SetDiffuse(0.6)
    look.SetSpecular(0.7)
    look.SetSpecularPower(20)
    stage.look()
    stage.orbit()


@volumes
def volume_gradient_opacity(stage):
    gradient_opacity(stage, show(stage, image_of(stage.vtk, field())))
    stage.look()
    stage.orbit()


@volumes
def volume_gradient_opacity_shaded(stage):
    gradient_opacity(stage, show(stage, image_of(stage.vtk, field()), shade=True))
    stage.look()
    stage.orbit()


@volumes
def volume_maximum(stage):
    simple(stage, blend="MaximumIntensity")


@volumes
def volume_maximum_shaded(stage):
    """Lit, and weighed, where the shader's loop ends."""
    gradient_opacity(stage, show(stage, image_of(stage.vtk, field()), shade=True, blend="MaximumIntensity"))
    stage.look()
    stage.orbit()


@volumes
def volume_minimum(stage):
    function = simple(stage, blend="MinimumIntensity").GetProperty().GetScalarOpacity()
    function.RemoveAllPoints()
    function.AddPoint(-1, 0.8)
    function.AddPoint(0, 0)
    stage.orbit()


@volumes
def volume_average(stage):
    simple(stage, blend="AverageIntensity").GetMapper().SetAverageIPScalarRange(0.1, 0.9)
    stage.orbit()


@volumes
def volume_additive(stage):
    simple(stage, blend="Additive")


def of_type(stage, kind, values):
    show(stage, image_of(stage.vtk, values, kind), shade=True)
    stage.look()
    stage.orbit()


@volumes
def volume_of_unsigned_chars(stage):
    of_type(stage, np.uint8, np.clip((field() + 1) * 100, 0, 255))


@volumes
def volume_of_signed_chars(stage):
    of_type(stage, np.int8, np.clip(field() * 100, -128, 127))


@volumes
def volume_of_shorts(stage):
    of_type(stage, np.int16, field() * 1000)


@volumes
def volume_of_unsigned_shorts(stage):
    of_type(stage, np.uint16, (field() + 1) * 2000)


@volumes
def volume_of_integers(stage):
    of_type(stage, np.int32, field() * 100000)


@volumes
def volume_of_doubles(stage):
    of_type(stage, np.float64, field() * 1e-3)


@volumes
def volume_nearest(stage):
    look = show(stage, image_of(stage.vtk, field((12, 10, 14)))).GetProperty()
    look.SetInterpolationTypeToNearest()
    stage.look()
    stage.orbit()


@volumes
def volume_of_cells(stage):
    """Scalars of cells: their voxels end at the box."""
    image = image_of(stage.vtk, field((13, 11, 15)))
    image.GetPointData().SetScalars(None)
    image.GetCellData().SetScalars(shapes.array(field((12, 10, 14)).ravel(), "values", np.float32))
    mapper = stage.vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.SetScalarModeToUseCellData()
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(0.05)
    volume = stage.vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(property_of(stage.vtk, -1, 1.8))
    stage.renderer.AddVolume(volume)
    stage.look()
    stage.orbit()


@volumes
def volume_jittered(stage):
    """Rays that begin at random: left to the real OpenGL unless it is known how."""
    volume = show(stage, image_of(stage.vtk, field()))
    volume.GetMapper().UseJitteringOn()
    stage.look()
    stage.orbit()
