"""Scenes of the gallery that show fields: flow, density, tensors, regions of the brain. As those of scenes.py."""
import math

import numpy as np
import vtk
from looks.scenes import add, mapped
from shapes import polylines
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

TEMPLATES = "/usr/share/mricron/templates"


def creased(source, angle=30):
    """With normals that break at edges."""
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(source) if isinstance(source, vtk.vtkPolyData) else normals.SetInputConnection(source.GetOutputPort())
    normals.SetFeatureAngle(angle), normals.ConsistencyOn()
    return normals


def both_of(a, b, width):
    """The lesser of two distances, rounded over this width where they are equal."""
    return np.minimum(a, b) - width * np.log1p(np.exp(-np.abs(a - b) / width))


def image_of(values, low, high):
    """vtkImageData of values, indexed [x, y, z], between two corners."""
    image = vtk.vtkImageData()
    image.SetDimensions(*values.shape), image.SetOrigin(*low)
    image.SetSpacing(*[(b - a) / (n - 1) for a, b, n in zip(low, high, values.shape)])
    image.GetPointData().SetScalars(numpy_to_vtk(values.astype(np.float32).ravel(order="F"), deep=True))
    return image


def surface_at(image, value):
    """The isosurface of an image, or of an algorithm's."""
    surface = vtk.vtkFlyingEdges3D()
    surface.SetInputData(image) if isinstance(image, vtk.vtkImageData) else surface.SetInputConnection(image.GetOutputPort())
    surface.SetValue(0, value)
    return surface


def table_of(*stops):
    """A colour table from (share, colour) pairs."""
    function, table = vtk.vtkColorTransferFunction(), vtk.vtkLookupTable()
    for at, color in stops:
        function.AddRGBPoint(at, *color)
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255))
    return table


def ring_flow(points, radius=1.0, core=0.22, parts=90):
    """Velocities (rows) at points (rows) about a ring of vorticity in the plane z = 0, by the law of Biot and Savart with a smooth core."""
    flow = np.zeros_like(points)
    for angle in 2 * np.pi * np.arange(parts) / parts:
        place, along = radius * np.array((math.cos(angle), math.sin(angle), 0)), np.array((-math.sin(angle), math.cos(angle), 0))
        away = points - place
        flow += np.cross(along, away) / (np.sum(away * away, axis=1, keepdims=True) + core * core) ** 1.5
    return flow / parts


def vortex_ring(renderer):
    """Arrows of the flow about a vortex ring, in the colours of the speed, cut open at the front."""
    points = []
    for circle, at in zip((0.26, 0.47, 0.70), (20, 30, 40)):
        for i, j in np.ndindex(34, at // 3):
            around, about = 2 * math.pi * (i + 0.5 * (j % 2)) / 34, 2 * math.pi * j / (at // 3)
            r = 1.25 + circle * math.cos(about)
            points.append((r * math.cos(around), r * math.sin(around), circle * math.sin(about)))
    points = np.array([p for p in points if not (p[1] < 0 and abs(p[0]) < -0.9 * p[1])])
    flow = ring_flow(points, 1.25)
    speed = np.linalg.norm(flow, axis=1)
    data, places, arrow, glyph = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkArrowSource(), vtk.vtkGlyph3D()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True)), data.SetPoints(places)
    vectors, scalars = (numpy_to_vtk(values.astype(np.float32), deep=True) for values in (flow / speed[:, None], speed / speed.max()))
    vectors.SetName("way"), scalars.SetName("speed")
    data.GetPointData().SetVectors(vectors), data.GetPointData().SetScalars(scalars)
    arrow.SetShaftResolution(24), arrow.SetTipResolution(32), arrow.SetShaftRadius(0.075), arrow.SetTipRadius(0.19), arrow.SetTipLength(0.42)
    glyph.SetInputData(data), glyph.SetSourceConnection(arrow.GetOutputPort()), glyph.SetVectorModeToUseVector()
    glyph.SetScaleModeToDataScalingOff(), glyph.SetScaleFactor(0.34)
    add(renderer, mapped(creased(glyph, 40), (0.25, 1), table_of((0, (0.40, 0.55, 0.75)), (0.5, (0.93, 0.88, 0.76)), (1, (0.85, 0.42, 0.25))), "speed"))
    return (0.25, -1, 0.85), (0, 0, 1), 1.5


def random_field(side, power, seed):
    """A periodic random field of this spectrum, side^3 values of mean 0 and variance 1."""
    frequency = np.fft.fftfreq(side)
    k = np.sqrt(sum(axis**2 for axis in np.meshgrid(frequency, frequency, frequency, indexing="ij")))
    k[0, 0, 0] = 1
    field = np.fft.ifftn(np.fft.fftn(np.random.default_rng(seed).normal(size=(side,) * 3)) * power(k)).real
    return (field - field.mean()) / field.std()


def inside_box(side, margin):
    """Distances to the faces of a box within a grid of [-1, 1], positive inside."""
    line = np.linspace(-1, 1, side)
    return margin - np.max(np.abs(np.stack(np.meshgrid(line, line, line, indexing="ij"))), axis=0)


def rock(renderer):
    """The grains of a porous rock: a threshold of a random field, cut to a cube."""
    side = 150
    field = random_field(side, lambda k: np.exp(-((k / 0.045) ** 2)), 3)
    solid = both_of(0.085 * (field + 0.1), inside_box(side, 0.95), 0.012)
    add(renderer, mapped(surface_at(image_of(solid, (-1, -1, -1), (1, 1, 1)), 0)), (0.86, 0.74, 0.56))
    return (0.75, -1, 0.65), (0, 0, 1), 1.3


def gyroid(renderer):
    """The two labyrinths of a gyroid in a ball, one of them cut away at the front."""
    side = 200
    line = np.linspace(-1, 1, side)
    x, y, z = np.meshgrid(line, line, line, indexing="ij")
    a, b, c = (2 * np.pi * 1.6 * axis for axis in (x, y, z))
    wave, ball = np.sin(a) * np.cos(b) + np.sin(b) * np.cos(c) + np.sin(c) * np.cos(a), 0.95 - np.sqrt(x * x + y * y + z * z)
    box, corners = np.maximum(np.maximum(-x, y), -z), ((-1, -1, -1), (1, 1, 1))
    for part, color in ((both_of(0.066 * (wave - 0.55), ball, 0.03), (0.85, 0.52, 0.36)), (both_of(both_of(0.066 * (-wave - 0.55), ball, 0.03), box, 0.03), (0.42, 0.60, 0.78))):
        add(renderer, mapped(surface_at(image_of(part, *corners), 0)), color)
    return (0.75, -1, 0.65), (0, 0, 1), 1.62


def tensors(renderer):
    """Diffusion tensors along fibres that bend, as ellipsoids in the colours of their anisotropy, over a plane."""
    places, matrices, shares = [], [], []
    for i, j in np.ndindex(17, 12):
        x, y = i - 8, j - 1
        r = math.hypot(x, y)
        share = math.exp(-(((r - 6.0) / 2.4) ** 2))
        along = np.array((-y, x, 0.0)) / max(r, 1e-6)
        long, short = 0.36 + 0.30 * share, 0.36 - 0.12 * share
        places.append((x, y, 0)), shares.append(share)
        matrices.append(short * np.eye(3) + (long - short) * np.outer(along, along))
    data, points, ball, glyph, normals = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkSphereSource(), vtk.vtkTensorGlyph(), vtk.vtkPolyDataNormals()
    points.SetData(numpy_to_vtk(np.array(places, np.float32), deep=True)), data.SetPoints(points)
    data.GetPointData().SetTensors(numpy_to_vtk(np.array(matrices, np.float32).reshape(-1, 9), deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk(np.array(shares, np.float32), deep=True))
    ball.SetThetaResolution(48), ball.SetPhiResolution(32)
    glyph.SetInputData(data), glyph.SetSourceConnection(ball.GetOutputPort()), glyph.ExtractEigenvaluesOn(), glyph.SetScaleFactor(1.5), glyph.ColorGlyphsOn()
    glyph.SetColorModeToScalars()
    normals.SetInputConnection(glyph.GetOutputPort())
    add(renderer, mapped(normals, (0, 1), table_of((0, (0.42, 0.58, 0.80)), (0.5, (0.92, 0.90, 0.85)), (1, (0.82, 0.38, 0.26)))))
    plane = vtk.vtkPlaneSource()
    plane.SetOrigin(-8.8, -1.8, -0.62), plane.SetPoint1(8.8, -1.8, -0.62), plane.SetPoint2(-8.8, 10.8, -0.62)
    add(renderer, mapped(plane), (0.88, 0.88, 0.86))
    return (0.1, -0.8, 1.0), (0, 0, 1), 1.3


def regions(renderer):
    """The regions of a brain atlas (AAL), each in a colour of its own, moved apart."""
    reader = vtk.vtkNIFTIImageReader()
    reader.SetFileName(f"{TEMPLATES}/aal.nii.gz")
    reader.Update()
    labels = np.unique(vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()))[1:]
    middle = np.array(reader.GetOutput().GetCenter())
    order = np.random.default_rng(12).permutation(len(labels) // 2 + 2)
    for label in labels:
        surface, smooth, normals, color = vtk.vtkDiscreteFlyingEdges3D(), vtk.vtkWindowedSincPolyDataFilter(), vtk.vtkPolyDataNormals(), [0.0] * 3
        surface.SetInputConnection(reader.GetOutputPort()), surface.SetValue(0, label)
        smooth.SetInputConnection(surface.GetOutputPort()), smooth.SetNumberOfIterations(25), smooth.SetPassBand(0.02), smooth.NormalizeCoordinatesOn()
        normals.SetInputConnection(smooth.GetOutputPort()), normals.SplittingOff()
        number = order[int(np.searchsorted(labels, label)) // 2]
        vtk.vtkMath.HSVToRGB([(0.618 * number) % 1, 0.30 + 0.12 * (number % 3), 0.88 - 0.06 * (number % 2)], color)
        smooth.Update()
        bounds = np.array(smooth.GetOutput().GetBounds())
        actor = add(renderer, mapped(normals), tuple(color))
        actor.SetPosition(*(0.45 * (0.5 * (bounds[::2] + bounds[1::2]) - middle)))
    return (-0.85, 0.9, 0.55), (0, 0, 1), 1.62


def attractor(renderer):
    """Trajectories of the Lorenz system as plain lines, in the colours of their speed."""
    at = np.random.default_rng(1).normal((1, 1, 20), 2.0, (48, 3))
    lines, speeds = [], []

    def slope(p):
        x, y, z = p.T
        return np.stack([10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z], axis=1)

    for step in range(950):
        half = at + 0.003 * slope(at)
        at = at + 0.006 * slope(half)
        if step >= 500:
            lines.append(at), speeds.append(np.linalg.norm(slope(at), axis=1))
    lines, speeds = np.stack(lines, axis=1), np.stack(speeds, axis=1)
    data = polylines(lines)
    data.GetPointData().SetScalars(numpy_to_vtk(speeds.ravel().astype(np.float32), deep=True))
    add(renderer, mapped(data, (10, 220), table_of((0, (0.20, 0.28, 0.55)), (0.35, (0.45, 0.62, 0.75)), (0.7, (0.95, 0.78, 0.50)), (1, (0.80, 0.30, 0.20)))), LineWidth=4)
    return (0.45, -1, 0.12), (0, 0, 1), 1.55


SCENES = {f.__name__: f for f in (vortex_ring, rock, gyroid, tensors, regions, attractor)}
