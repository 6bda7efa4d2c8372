"""Parts of volumes: cropping, clip planes, masks, isosurfaces, slices; voxels of several components. volumes.py says how they are
compared."""
import numpy as np
import shapes
from volume_shapes import field, image_of, show, sphere_inside, volumes


def turned(stage, volume):
    """Looks at a volume from two sides."""
    stage.look()
    stage.orbit()
    return volume


def add_plane(stage, volume, normal, origin=(0, 0, 0)):
    plane = stage.vtk.vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*origin)
    volume.GetMapper().AddClippingPlane(plane)
    return plane


@volumes
def volume_cut_by_a_plane(stage):
    volume = show(stage, image_of(stage.vtk, field()))
    add_plane(stage, volume, (1, 0.3, 0))
    turned(stage, volume)


@volumes
def volume_cut_to_a_wedge(stage):
    volume = show(stage, image_of(stage.vtk, field()), shade=True)
    volume.SetOrientation(20, 30, 40)
    volume.SetScale(1.2, 0.8, 1)
    plane = add_plane(stage, volume, (1, 0.3, 0), (0.1, 0, 0))
    add_plane(stage, volume, (-0.3, 0.2, -1), (0, 0, 0.4))
    turned(stage, volume)
    plane.SetNormal(-1, 0, 0.2)
    stage.shoot()


@volumes
def volume_cut_maximum_around_sphere(stage):
    sphere_inside(stage)
    volume = show(stage, image_of(stage.vtk, field()), blend="MaximumIntensity")
    add_plane(stage, volume, (0.2, 1, 0))
    turned(stage, volume)


@volumes
def volume_cut_jittered(stage):
    volume = show(stage, image_of(stage.vtk, field()))
    volume.GetMapper().UseJitteringOn()
    add_plane(stage, volume, (0.2, 1, 0.4))
    turned(stage, volume)


def cropped(stage, flags, **how):
    volume = show(stage, image_of(stage.vtk, field()), **how)
    mapper = volume.GetMapper()
    mapper.CroppingOn()
    mapper.SetCroppingRegionPlanes(-0.4, 0.5, -0.5, 0.3, -0.3, 0.6)
    mapper.SetCroppingRegionFlags(flags)
    return turned(stage, volume)


@volumes
def volume_regions_cropped(stage):
    cropped(stage, 0x2ebfeba)  # a fence


@volumes
def volume_cropped_to_one_region(stage):
    volume = cropped(stage, 0x2000, shade=True)
    volume.GetMapper().SetCroppingRegionPlanes(-0.8, 0.2, -0.9, 0.9, -0.6, 0.6)
    stage.shoot()


@volumes
def volume_cropped_minimum(stage):
    volume = cropped(stage, 0x5412345, blend="MinimumIntensity")
    volume.GetProperty().GetScalarOpacity().AddPoint(-1, 0.7)
    stage.shoot()


@volumes
def volume_cropped_average(stage):
    cropped(stage, 0x1f3a5c7, blend="AverageIntensity")


@volumes
def volume_masked(stage):
    volume = show(stage, image_of(stage.vtk, field()), shade=True)
    values = field()
    z, y, x = np.meshgrid(*(np.linspace(-1, 1, n) for n in values.shape), indexing="ij")
    inside = np.where(x * x + y * y + z * z < 0.7, 255, 0)
    volume.GetMapper().SetMaskInput(image_of(stage.vtk, inside, np.uint8))
    volume.GetMapper().SetMaskTypeToBinary()
    turned(stage, volume)


@volumes
def volume_isosurface(stage):
    volume = show(stage, image_of(stage.vtk, field()), blend="IsoSurface", shade=True)
    volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.5)
    turned(stage, volume)


@volumes
def volume_isosurfaces(stage):
    volume = show(stage, image_of(stage.vtk, field()), blend="IsoSurface", sample=0.02)
    contours = volume.GetProperty().GetIsoSurfaceValues()
    for i, value in enumerate((0.1, 0.4, 0.9)):
        contours.SetValue(i, value)
    turned(stage, volume)
    contours.SetNumberOfContours(2)
    stage.shoot()


@volumes
def volume_sliced(stage):
    sphere_inside(stage)
    volume = show(stage, image_of(stage.vtk, field()), blend="Slice")
    plane = stage.vtk.vtkPlane()
    plane.SetNormal(0.5, 0.8, 0.3)
    plane.SetOrigin(0.1, 0.05, 0)
    volume.GetProperty().SetSliceFunction(plane)
    turned(stage, volume)
    plane.SetNormal(0, 0, 1)
    stage.shoot()


def of_components(stage, count, **how):
    values = np.stack([np.clip((field() + k) * 80, 0, 255) for k in (1, 0.5, 0, 0.8)[:count]], 3)
    image = image_of(stage.vtk, values[..., 0])
    image.GetPointData().SetScalars(shapes.array(values.reshape(-1, count), "values", np.uint8))
    return show(stage, image, **how)


def independent(stage, count, shade=False, blend="Composite"):
    volume = of_components(stage, count, shade=shade, blend=blend)
    look = volume.GetProperty()
    for i in range(count):
        color, opacity = stage.vtk.vtkColorTransferFunction(), stage.vtk.vtkPiecewiseFunction()
        color.AddRGBPoint(0, 0.2 * i, 1, 0)
        color.AddRGBPoint(255, 1, 0.3 * i, 0.4)
        for at, a in ((0, 0), (90, 0), (140, 0.1 + 0.1 * i), (255, 0.4)):
            opacity.AddPoint(at, a)
        look.SetColor(i, color)
        look.SetScalarOpacity(i, opacity)
        look.SetScalarOpacityUnitDistance(i, 0.1)
        look.SetComponentWeight(i, (0.7, 0.4, 0.9, 0.2)[i])
        look.SetShade(i, shade)
    return volume


@volumes
def volume_of_two_components(stage):
    """Colours by the first one, opacities by the second one."""
    volume = of_components(stage, 2, shade=True)
    volume.GetProperty().IndependentComponentsOff()
    turned(stage, volume)


@volumes
def volume_of_four_components(stage):
    """Colours and opacities."""
    volume = of_components(stage, 4, shade=True)
    volume.GetProperty().IndependentComponentsOff()
    turned(stage, volume)


@volumes
def volume_of_four_components_weighted(stage):
    volume = of_components(stage, 4)
    volume.GetProperty().IndependentComponentsOff()
    function = stage.vtk.vtkPiecewiseFunction()
    function.AddPoint(0, 0)
    function.AddPoint(40, 1)
    volume.GetProperty().SetGradientOpacity(function)
    turned(stage, volume)


@volumes
def volume_of_two_independent_components(stage):
    turned(stage, independent(stage, 2))


@volumes
def volume_of_four_independent_components(stage):
    turned(stage, independent(stage, 4, shade=True))


@volumes
def volume_of_components_maximum(stage):
    turned(stage, independent(stage, 2, shade=True, blend="MaximumIntensity"))


@volumes
def volume_of_components_average(stage):
    turned(stage, independent(stage, 3, blend="AverageIntensity")).GetMapper().SetAverageIPScalarRange(40, 200)
    stage.shoot()


@volumes
def volume_of_components_additive(stage):
    turned(stage, independent(stage, 4, blend="Additive"))


@volumes
def volume_of_three_components_cropped(stage):
    volume = independent(stage, 3)
    mapper = volume.GetMapper()
    mapper.CroppingOn()
    mapper.SetCroppingRegionPlanes(-0.4, 0.5, -0.5, 0.3, -0.3, 0.6)
    mapper.SetCroppingRegionFlagsToInvertedCross()
    add_plane(stage, volume, (0, 0.3, 1))
    turned(stage, volume)
