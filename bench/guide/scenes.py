"""Scenes of the guide to light, as VTK actors: a head scan, nested isosurfaces, magnetic field lines of a star, an impact.

Each function returns (actors, camera), where camera is (position relative to the centre, up, zoom).
"""
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

HEAD = "/usr/share/mricron/templates/ch2better.nii.gz"


def actor(source, color=(0.85, 0.8, 0.72)):
    mapper, result = vtk.vtkPolyDataMapper(), vtk.vtkActor()
    if isinstance(source, vtk.vtkPolyData):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetScalarVisibility(color is None)
    result.SetMapper(mapper)
    if color is not None:
        result.GetProperty().SetColor(color)
    return result


def head():
    """The brain of a head scan."""
    reader, smooth, surface = vtk.vtkNIFTIImageReader(), vtk.vtkImageGaussianSmooth(), vtk.vtkFlyingEdges3D()
    reader.SetFileName(HEAD)
    smooth.SetInputConnection(reader.GetOutputPort())
    smooth.SetStandardDeviation(0.8)
    surface.SetInputConnection(smooth.GetOutputPort())
    surface.SetValue(0, 60)
    return [actor(surface)], ((-0.7, 1.0, 0.35), (0, 0, 1), 1.45)


def wavelet():
    """Nested isosurfaces of VTK's Wavelet source, coloured by their value."""
    source, surfaces = vtk.vtkRTAnalyticSource(), vtk.vtkContourFilter()
    source.SetWholeExtent(-100, 100, -100, 100, -100, 100)
    surfaces.SetInputConnection(source.GetOutputPort())
    surfaces.GenerateValues(8, 90, 230)
    shown = actor(surfaces, None)
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.62, 0.06)
    table.SetSaturationRange(0.55, 0.55)
    shown.GetMapper().SetLookupTable(table)
    shown.GetMapper().SetScalarRange(90, 230)
    return [shown], ((0.8, 0.75, 1.0), (0, 1, 0), 1.05)


def magnetic_field(charges, points):
    """The field of magnetic charges, rows of (x, y, z, strength), at rows of points."""
    field = np.zeros_like(points)
    for x, y, z, strength in charges:
        away = points - (x, y, z)
        field += strength * away / np.sum(away * away, axis=1, keepdims=True) ** 1.5
    return field


def star_charges():
    generator = np.random.default_rng(7)
    charges = [(8, 30, 0, 1), (-8, -30, 0, -1)]
    for _ in range(14):
        place, way = (v / np.linalg.norm(v) for v in generator.normal(size=(2, 3)))
        charges += [(*(60 * place + 9 * way), 0.3), (*(60 * place - 9 * way), -0.3)]
    return charges


def field_lines(count, steps=60, radius=70.0, farthest=172.0):
    """Points of `count` lines, shape (count, steps, 3); lines that have ended repeat their last point."""
    charges, number = star_charges(), np.arange(count)
    height = 1 - (2 * number + 1) / count
    flat, angle = np.sqrt(1 - height**2), np.pi * (3 - np.sqrt(5)) * number
    at = 1.001 * radius * np.stack([flat * np.cos(angle), height, flat * np.sin(angle)], axis=1)
    outward = np.where(np.sum(magnetic_field(charges, at) * at, axis=1) < 0, -1.0, 1.0)[:, None]

    def way(points):
        field = outward * magnetic_field(charges, points)
        return field / np.maximum(np.linalg.norm(field, axis=1, keepdims=True), 1e-30)

    lines, alive = [at], np.ones(count, bool)
    for _ in range(steps - 1):
        middle = at + 1.5 * way(at)
        step = at + 3.0 * way(middle)
        r = np.linalg.norm(step, axis=1)
        alive &= (r >= radius) & (r <= farthest)
        at = np.where(alive[:, None], step, at)
        lines.append(at)
    return np.stack(lines, axis=1)


def star():
    """48,000 magnetic field lines of a star, drawn as lines 2 pixels wide."""
    lines = field_lines(48000)
    count, steps, _ = lines.shape
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(lines.reshape(-1, 3).astype(np.float32), deep=True))
    rows = np.hstack([np.full((count, 1), steps), np.arange(count * steps).reshape(count, steps)])
    cells.SetCells(count, numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(points), data.SetLines(cells)
    distance = numpy_to_vtk(np.linalg.norm(lines, axis=2).ravel().astype(np.float32), deep=True)
    data.GetPointData().SetScalars(distance)
    shown = actor(data, None)
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.02, 0.14)
    table.SetValueRange(0.9, 1)
    shown.GetMapper().SetLookupTable(table)
    shown.GetMapper().SetScalarRange(70, 150)
    shown.GetProperty().SetLineWidth(2)
    shown.GetProperty().SetRenderLinesAsTubes(True)
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(69.5), sphere.SetThetaResolution(120), sphere.SetPhiResolution(120)
    return [shown, actor(sphere, (0.95, 0.6, 0.25))], ((0.3, 0.35, 1.0), (0, 1, 0), 1.35)


def plate(radius=4.0, count=260):
    """A plate with a crater: a height field with a raised, jagged rim and ripples that fade outwards."""
    x, y = np.meshgrid(np.linspace(-radius, radius, count), np.linspace(-radius, radius, count))
    r, angle = np.hypot(x, y), np.arctan2(y, x)
    rim = 1.15 + 0.08 * np.sin(7 * angle) + 0.05 * np.sin(17 * angle + 1)
    z = 0.55 * np.exp(-((r - rim) / 0.22) ** 2) - 0.85 * np.exp(-((r / rim) ** 4)) + 0.05 * np.sin(9 * r) * np.exp(-r)
    points, cells = np.stack([x, y, z], axis=2).reshape(-1, 3), []
    corner = np.arange(count * count).reshape(count, count)
    a, b, c, d = corner[:-1, :-1].ravel(), corner[:-1, 1:].ravel(), corner[1:, 1:].ravel(), corner[1:, :-1].ravel()
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    rows = np.hstack([np.full((len(triangles), 1), 3), triangles])
    data, vertices, array = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    vertices.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    array.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(vertices), data.SetPolys(array)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetFeatureAngle(60)
    return actor(normals, (0.62, 0.64, 0.68))


def impact():
    """A ball that has hit a plate, and the fragments that fly off: in the manner of the paper's Figure 5."""
    generator = np.random.default_rng(3)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(0.62), ball.SetCenter(0, 0, 0.5), ball.SetThetaResolution(90), ball.SetPhiResolution(90)
    actors = [plate(), actor(ball, (0.75, 0.76, 0.8))]
    fragments = vtk.vtkAppendPolyData()
    for _ in range(420):
        angle, speed, lift = generator.uniform(0, 2 * np.pi), generator.uniform(0.9, 2.9), generator.uniform(0.3, 1.15)
        rock = vtk.vtkSphereSource()
        rock.SetRadius(generator.uniform(0.02, 0.085))
        rock.SetCenter(speed * np.cos(angle), speed * np.sin(angle), 0.25 + lift * speed * 0.75)
        rock.SetThetaResolution(12), rock.SetPhiResolution(8)
        fragments.AddInputConnection(rock.GetOutputPort())
    actors.append(actor(fragments, (0.8, 0.55, 0.35)))
    return actors, ((0.25, -1.0, 0.62), (0, 0, 1), 1.6)


def balls():
    """Nine balls, numbered by row from the back left, and a small one over them; materials.toml says what they are of."""
    actors = []
    colors = [(0.8, 0.35, 0.25), (0.2, 0.4, 0.8), (0.9, 0.9, 0.9), (0.95, 0.95, 0.95), (0.95, 0.95, 0.95), (0.95, 0.95, 0.95),
              (0.85, 0.95, 0.9), (0.9, 0.95, 1.0), (0.3, 0.7, 0.3)]
    for index, color in enumerate(colors):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(0.46), ball.SetCenter(index % 3 - 1, 1 - index // 3, 0.46), ball.SetThetaResolution(120), ball.SetPhiResolution(120)
        actors.append(actor(ball, color))
    lamp = vtk.vtkSphereSource()
    lamp.SetRadius(0.15), lamp.SetCenter(0.5, -0.5, 1.0), lamp.SetThetaResolution(60), lamp.SetPhiResolution(60)
    actors.append(actor(lamp, (1.0, 0.7, 0.35)))
    return actors, ((0.2, -1.0, 0.9), (0, 0, 1), 1.2)


SCENES = {"balls": balls, "head": head, "wavelet": wavelet, "star": star, "impact": impact}
