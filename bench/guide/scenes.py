"""Scenes of the guide to light, made by VTK: a head scan, molecules, field lines, terrain, parts of machines, an impact.

Each function fills a vtkRenderer and returns the place of its camera: (direction towards the viewer, up, zoom), as those of bench/looks/scenes.py do.
"""
import math

import numpy as np
import fields
import objects
import vtk
from looks.scenes import add, bright, mapped, streamlines, wavelet
from shapes import ATOMS, field_lines, height_field, pair_atoms, polylines, turned
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

HEAD = "/usr/share/mricron/templates/ch2better.nii.gz"


def raise_by(renderer, share):
    """Moves the picture up by this share of half its height."""
    renderer.GetActiveCamera().SetWindowCenter(0, -share)


def head(renderer):
    """The brain of a head scan."""
    reader, smooth, surface = vtk.vtkNIFTIImageReader(), vtk.vtkImageGaussianSmooth(), vtk.vtkFlyingEdges3D()
    reader.SetFileName(HEAD)
    smooth.SetInputConnection(reader.GetOutputPort())
    smooth.SetStandardDeviation(1.2)
    surface.SetInputConnection(smooth.GetOutputPort())
    surface.SetValue(0, 60)
    whole = vtk.vtkPolyDataConnectivityFilter()
    whole.SetInputConnection(surface.GetOutputPort())
    whole.SetExtractionModeToLargestRegion()
    add(renderer, mapped(whole), (0.87, 0.80, 0.74))
    return (-0.75, 1.0, 0.4), (0, 0, 1), 1.65


def head_from_afar(renderer):
    """The brain with room for its shadow."""
    towards, up, zoom = head(renderer)
    return towards, up, 0.75 * zoom


def cut(renderer):
    """A volume with a corner cut out, in the colours of its values, with a colour bar."""
    box, source, clipped, surface = vtk.vtkBox(), wavelet(60), vtk.vtkClipDataSet(), vtk.vtkDataSetSurfaceFilter()
    source.SetStandardDeviation(0.8)
    box.SetBounds(0, 90, 0, 90, 0, 90)
    clipped.SetInputConnection(source.GetOutputPort()), clipped.SetClipFunction(box)
    surface.SetInputConnection(clipped.GetOutputPort())
    mapper = mapped(surface, (40, 280), bright(), "RTData")
    add(renderer, mapper)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable()), bar.SetTitle("value"), bar.SetNumberOfLabels(4)
    bar.SetPosition(0.86, 0.12), bar.SetWidth(0.12), bar.SetHeight(0.76), bar.SetLabelFormat("%.0f"), bar.SetVerticalTitleSeparation(12)
    for text in (bar.GetLabelTextProperty(), bar.GetTitleTextProperty()):
        text.SetColor(0, 0, 0), text.ItalicOff(), text.ShadowOff(), text.BoldOff()
    renderer.AddActor2D(bar)
    return (1, 0.6, 0.9), (0, 1, 0), 0.93


def bars(renderer):
    """A histogram of two quantities: a bar for each pair of ranges, in the colour of its height."""
    count = 18
    x, y = np.meshgrid(np.linspace(-3, 3, count), np.linspace(-3, 3, count))
    height = 3.2 * np.exp(-((x - 0.8) ** 2 + (y - 0.7) ** 2) / 1.6) + 1.8 * np.exp(-((x + 1.4) ** 2 / 1.0 + (y + 1.2) ** 2 / 1.6))
    height = 0.15 + height * np.random.default_rng(5).uniform(0.75, 1.25, height.shape)
    low, high = np.array((0.93, 0.90, 0.82)), np.array((0.80, 0.28, 0.20))
    for at_x, at_y, h in zip(x.ravel(), y.ravel(), height.ravel()):
        bar, share = vtk.vtkCubeSource(), min(h / 3.2, 1)
        bar.SetBounds(at_x - 0.15, at_x + 0.15, at_y - 0.15, at_y + 0.15, 0, h)
        add(renderer, mapped(bar), tuple(low + share * (high - low)))
    floor = vtk.vtkCubeSource()
    floor.SetBounds(-3.3, 3.3, -3.3, 3.3, -0.12, 0)
    add(renderer, mapped(floor), (0.9, 0.9, 0.9))
    raise_by(renderer, 0.25)
    return (-0.5, -1.0, 0.95), (0, 0, 1), 1.25


def bars_detail(renderer):
    """A part of the histogram, as in a large print."""
    bars(renderer)
    raise_by(renderer, 0)
    return (-0.5, -1.0, 0.95), (0, 0, 1), 3.2


def star(renderer):
    """Magnetic field lines of a star, drawn as plain lines 5 pixels wide, in the colours of their distance."""
    lines = field_lines(1200)
    data = polylines(lines)
    data.GetPointData().SetScalars(numpy_to_vtk(np.linalg.norm(lines, axis=2).ravel().astype(np.float32), deep=True))
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.6, 0.08), table.SetSaturationRange(0.65, 0.75), table.SetValueRange(0.8, 1)
    add(renderer, mapped(data, (70, 150), table), LineWidth=5)
    return (0.3, 0.35, 1.0), (0, 1, 0), 1.6


def helix(renderer):
    """A double helix of 15 pairs of bases, its atoms as balls of their van der Waals radii."""
    atoms = [atom for number in range(15) for atom in pair_atoms(number)]
    for element, (radius, color) in ATOMS.items():
        points, data, ball, glyph = vtk.vtkPoints(), vtk.vtkPolyData(), vtk.vtkSphereSource(), vtk.vtkGlyph3D()
        for place in (place for kind, place in atoms if kind == element):
            points.InsertNextPoint(place)
        data.SetPoints(points)
        ball.SetRadius(radius), ball.SetThetaResolution(48), ball.SetPhiResolution(32)
        glyph.SetInputData(data), glyph.SetSourceConnection(ball.GetOutputPort()), glyph.ScalingOff()
        add(renderer, mapped(glyph), color)
    return (1, -0.25, 0.1), (0.2, 1, 0.9), 1.2


def helix_along(renderer):
    """The double helix from near its end: the rest of it lies farther and farther away."""
    helix(renderer)
    renderer.GetActiveCamera().SetViewAngle(50)
    return (0.7, -0.2, 1), (0.2, 1, 0.2), 1.75


def helix_detail(renderer):
    """A part of the double helix."""
    towards, up, _ = helix(renderer)
    return towards, up, 3.66


def tubes(renderer):
    """Tubes along streamlines, all of them inside the picture."""
    towards, up, zoom = streamlines(renderer)
    return towards, up, 0.92 * zoom


def mountains(renderer):
    """A landscape with z upwards, in the colours of its heights."""
    count, generator = 360, np.random.default_rng(11)
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(count), np.fft.fftfreq(count)))
    frequency[0, 0] = 1
    noise = np.fft.ifft2(np.fft.fft2(generator.normal(size=(count, count))) * frequency**-2.1).real
    noise = (noise - noise.min()) / np.ptp(noise)
    x, y = np.meshgrid(np.linspace(-5, 5, count), np.linspace(-5, 5, count))
    height = np.maximum(2.6 * noise**1.3, 0.72)
    data = height_field(x, y, height)
    data.GetPointData().SetScalars(numpy_to_vtk(height.ravel().astype(np.float32), deep=True))
    function, table = vtk.vtkColorTransferFunction(), vtk.vtkLookupTable()
    for at, color in ((0, (0.42, 0.60, 0.75)), (0.01, (0.45, 0.60, 0.38)), (0.3, (0.62, 0.68, 0.45)), (0.6, (0.70, 0.60, 0.45)), (0.85, (0.75, 0.72, 0.70)), (1, (0.97, 0.97, 0.97))):
        function.AddRGBPoint(at, *color)
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255))
    add(renderer, mapped(data, (0.72, 2.4), table))
    raise_by(renderer, 0.08)
    return (0.35, -1, 0.6), (0, 0, 1), 1.3


def bearing(renderer):
    """A ball bearing: two rings with grooves, a brass cage and twelve balls."""
    groove = [(math.sin(a) / 2, math.cos(a) / 2) for a in np.linspace(0, math.pi, 41)]  # of the balls' path, from above
    steel, middle = (0.78, 0.80, 0.83), 2.62
    outer = [(2.98, -0.6), (3.62, -0.6), (3.7, -0.52), (3.7, 0.52), (3.62, 0.6), (2.98, 0.6), (2.9, 0.52)]
    inner = [(2.26, -0.6), (1.62, -0.6), (1.54, -0.52), (1.54, 0.52), (1.62, 0.6), (2.26, 0.6), (2.34, 0.52)]
    outer += [(middle + r, z) for r, z in groove if middle + r > 2.9] + [(2.9, -0.52)]
    inner += [(middle - r, z) for r, z in groove if middle - r < 2.34] + [(2.34, -0.52)]
    cage = [(2.53, -0.2), (2.71, -0.2), (2.74, -0.17), (2.74, 0.17), (2.71, 0.2), (2.53, 0.2), (2.5, 0.17), (2.5, -0.17)]
    for outline, color in ((outer, steel), (inner, steel), (cage, (0.88, 0.68, 0.28))):
        add(renderer, mapped(turned([*outline, outline[0]])), color, Specular=0.3, SpecularPower=40)
    for i in range(12):
        ball = vtk.vtkSphereSource()
        ball.SetCenter(middle * math.cos(math.pi * i / 6), middle * math.sin(math.pi * i / 6), 0), ball.SetRadius(0.48)
        ball.SetThetaResolution(120), ball.SetPhiResolution(80)
        add(renderer, mapped(ball), steel, Specular=0.5, SpecularPower=60)
    return (0.5, -0.8, 1.1), (0, 0, 1), 1.45


def plate(radius=3.4, count=420):
    """A plate with a crater, and its sides: a height field with a raised, jagged rim and ripples that fade outwards."""
    line = np.linspace(-radius, radius, count)
    line = np.concatenate([[-radius - 0.02], line, [radius + 0.02]])
    x, y = np.meshgrid(line, line)
    r, angle = np.hypot(x, y), np.arctan2(y, x)
    rim = 1.15 + 0.08 * np.sin(7 * angle) + 0.05 * np.sin(17 * angle + 1)
    z = 0.55 * np.exp(-((r - rim) / 0.22) ** 2) - 0.85 * np.exp(-((r / rim) ** 4)) + 0.05 * np.sin(9 * r) * np.exp(-r)
    z[[0, -1], :] = z[:, [0, -1]] = -1.0
    return height_field(x, y, z)


def impact(renderer):
    """A ball that has hit a plate, in the colours of its height, and the fragments that fly off: in the manner of the paper's Figure 5."""
    generator = np.random.default_rng(3)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(0.62), ball.SetCenter(0, 0, 0.3), ball.SetThetaResolution(180), ball.SetPhiResolution(120)
    data, table = plate(), vtk.vtkColorTransferFunction()
    for height, color in ((-0.85, (0.16, 0.32, 0.52)), (0, (0.91, 0.90, 0.86)), (0.6, (0.86, 0.56, 0.34))):
        table.AddRGBPoint(height, *color)
    data.GetPointData().SetScalars(numpy_to_vtk(vtk_to_numpy(data.GetPoints().GetData())[:, 2].copy(), deep=True))
    add(renderer, mapped(data, (-0.85, 0.6), table))
    add(renderer, mapped(ball), (0.85, 0.86, 0.88))
    fragments = vtk.vtkAppendPolyData()
    for _ in range(220):
        angle, speed, lift = generator.uniform(0, 2 * np.pi), generator.uniform(0.9, 2.9), generator.uniform(0.15, 0.75)
        rock = vtk.vtkSphereSource()
        rock.SetRadius(generator.uniform(0.02, 0.09))
        rock.SetCenter(speed * np.cos(angle), speed * np.sin(angle), 0.25 + lift * speed * 0.75)
        rock.SetThetaResolution(36), rock.SetPhiResolution(24)
        fragments.AddInputConnection(rock.GetOutputPort())
    add(renderer, mapped(fragments), (0.80, 0.40, 0.20))
    return (0.35, -1.0, 1.0), (0, 0, 1), 1.1


def impact_side_lit(renderer):
    """The impact under a light of the program that stands at the side, with some ambient light."""
    place = impact(renderer)
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight(), light.SetPosition(-4, -4, 9), light.SetFocalPoint(0, 0, 0)
    renderer.AddLight(light)
    for actor in renderer.GetActors():
        actor.GetProperty().SetAmbient(0.35), actor.GetProperty().SetAmbientColor(actor.GetProperty().GetColor()), actor.GetProperty().SetDiffuse(0.65)
    raise_by(renderer, 0.2)
    towards, up, zoom = place
    return towards, up, 1.15 * zoom


def balls(renderer):
    """Nine balls, numbered by row from the back left, and a small one over them; materials.toml says what they are of."""
    colors = [(0.8, 0.35, 0.25), (0.2, 0.4, 0.8), (0.9, 0.9, 0.9), (0.95, 0.95, 0.95), (0.95, 0.95, 0.95), (0.95, 0.95, 0.95),
              (0.85, 0.95, 0.9), (0.9, 0.95, 1.0), (0.3, 0.7, 0.3)]
    for index, color in enumerate(colors):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(0.46), ball.SetCenter(index % 3 - 1, 1 - index // 3, 0.46), ball.SetThetaResolution(240), ball.SetPhiResolution(160)
        add(renderer, mapped(ball), color)
    lamp = vtk.vtkSphereSource()
    lamp.SetRadius(0.15), lamp.SetCenter(0.5, -0.5, 1.0), lamp.SetThetaResolution(60), lamp.SetPhiResolution(60)
    add(renderer, mapped(lamp), (1.0, 0.7, 0.35))
    return (0.2, -1.0, 0.9), (0, 0, 1), 1.35


def orbital(renderer):
    """A wave function of hydrogen (4f) by volume rendering, its signs in two colours, over a table."""
    side = 128
    x, y, z = np.meshgrid(*[np.linspace(-36, 36, side)] * 3, indexing="ij")
    r = np.sqrt(x * x + y * y + z * z)
    wave = (5 * z * z - 3 * r * r) * z * np.exp(-r / 4)
    image = vtk.vtkImageData()
    image.SetDimensions(side, side, side), image.SetSpacing(*[72 / (side - 1)] * 3), image.SetOrigin(-36, -36, -36)
    image.GetPointData().SetScalars(numpy_to_vtk((wave / abs(wave).max()).astype(np.float32).ravel(order="F"), deep=True))
    mapper, volume, look = vtk.vtkGPUVolumeRayCastMapper(), vtk.vtkVolume(), vtk.vtkVolumeProperty()
    mapper.SetInputData(image), mapper.SetSampleDistance(0.3), mapper.SetAutoAdjustSampleDistances(False)
    colors, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for value, color in ((-1, (0.10, 0.25, 0.62)), (-0.1, (0.35, 0.60, 0.90)), (0.1, (0.97, 0.72, 0.40)), (1, (0.75, 0.22, 0.12))):
        colors.AddRGBPoint(value, *color)
    for value, alpha in ((-1, 0.95), (-0.1, 0.5), (-0.06, 0), (0.06, 0), (0.1, 0.5), (1, 0.95)):
        opacity.AddPoint(value, alpha)
    look.SetColor(colors), look.SetScalarOpacity(opacity), look.SetInterpolationTypeToLinear(), look.SetScalarOpacityUnitDistance(0.7)
    look.ShadeOn(), look.SetAmbient(0.3), look.SetDiffuse(0.75), look.SetSpecular(0.1)
    volume.SetMapper(mapper), volume.SetProperty(look)
    renderer.AddVolume(volume)
    table = vtk.vtkDiskSource()
    table.SetInnerRadius(0), table.SetOuterRadius(64), table.SetCircumferentialResolution(200)
    add(renderer, mapped(table), (0.9, 0.88, 0.84), Ambient=0.4, Diffuse=0.6)
    renderer.GetActors().GetLastActor().SetPosition(0, 0, -34)
    raise_by(renderer, 0.16)
    return (0.5, -1.0, 0.75), (0, 0, 1), 1.6


def grains(renderer):
    """A porous aggregate of 27,000 grains of 384 triangles each, in the colours of their distance from its middle."""
    generator, line = np.random.default_rng(7), np.arange(-23.0, 24.0)
    x, y, z = (axis.ravel() for axis in np.meshgrid(line, line, line, indexing="ij"))
    place = np.stack([x + 0.5 * (y % 2), 0.87 * y + 0.29 * (z % 2), 0.82 * z], axis=1) + generator.normal(0, 0.07, (x.size, 3))
    radius = np.linalg.norm(place, axis=1)
    pores = sum(np.sin(0.33 * a) * np.cos(0.33 * b) for a, b in zip(place.T, np.roll(place.T, -1, axis=0)))
    kept = (radius < 20) & (pores + 0.25 * generator.normal(size=x.size) < 0.25)
    points, data, ball, mapper = vtk.vtkPoints(), vtk.vtkPolyData(), vtk.vtkSphereSource(), vtk.vtkGlyph3DMapper()
    points.SetData(numpy_to_vtk(place[kept], deep=True)), data.SetPoints(points)
    data.GetPointData().SetScalars(numpy_to_vtk(radius[kept].astype(np.float32), deep=True))
    ball.SetRadius(0.52), ball.SetThetaResolution(16), ball.SetPhiResolution(14)
    table = vtk.vtkColorTransferFunction()
    for at, color in ((8, (0.20, 0.38, 0.58)), (14, (0.90, 0.60, 0.36)), (20, (0.93, 0.90, 0.84))):
        table.AddRGBPoint(at, *color)
    mapper.SetInputData(data), mapper.SetSourceConnection(ball.GetOutputPort()), mapper.ScalingOff()
    mapper.SetLookupTable(table), mapper.SetScalarRange(8, 20)
    add(renderer, mapper)
    return (0.6, -1.0, 0.55), (0, 0, 1), 1.5


SCENES = {f.__name__: f for f in (orbital, head, head_from_afar, bars, bars_detail, cut, star, helix, helix_along, helix_detail, tubes, mountains, bearing, impact, impact_side_lit, balls, grains)} | fields.SCENES | objects.SCENES
