"""Scenes of the gallery that show things: crystals, buildings, points of a laser scanner. As those of scenes.py."""
import math

import numpy as np
import vtk
from fields import creased, table_of
from looks.scenes import add, mapped
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def mesh(points, faces):
    """vtkPolyData of faces, rows of corner numbers."""
    data, vertices, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    faces = np.asarray(faces, np.int64)
    vertices.SetData(numpy_to_vtk(np.asarray(points, np.float32), deep=True))
    rows = np.hstack([np.full((len(faces), 1), faces.shape[1]), faces])
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(vertices), data.SetPolys(cells)
    return data


def balls(renderer, places, radius, color, **look):
    points, data, ball, glyph = vtk.vtkPoints(), vtk.vtkPolyData(), vtk.vtkSphereSource(), vtk.vtkGlyph3D()
    points.SetData(numpy_to_vtk(np.array(places, np.float32), deep=True)), data.SetPoints(points)
    ball.SetRadius(radius), ball.SetThetaResolution(48), ball.SetPhiResolution(32)
    glyph.SetInputData(data), glyph.SetSourceConnection(ball.GetOutputPort()), glyph.ScalingOff()
    add(renderer, mapped(glyph), color, **look)


def perovskite(renderer):
    """Three cells a side of a perovskite: octahedra of oxygen about titanium, and calcium between them."""
    octahedra, oxygen = vtk.vtkAppendPolyData(), set()
    for cell in np.ndindex(3, 3, 3):
        corners = [tuple(np.array(cell) + 0.5 * sign * np.eye(3)[axis]) for axis in range(3) for sign in (1, -1)]
        oxygen.update(corners)
        octahedra.AddInputData(mesh(corners, [(x, y, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]))
    add(renderer, mapped(creased(octahedra, 1)), (0.50, 0.66, 0.82))
    balls(renderer, sorted(oxygen), 0.11, (0.85, 0.25, 0.20))
    balls(renderer, [np.array(i) + 0.5 for i in np.ndindex(2, 2, 2)], 0.25, (0.95, 0.75, 0.35))
    return (0.38, -1, 0.30), (0, 0, 1), 1.4


def town(renderer):
    """Buildings of a town as blocks, the tall ones in its middle."""
    generator, blocks, roofs = np.random.default_rng(9), vtk.vtkAppendPolyData(), vtk.vtkAppendPolyData()

    def block(to, low, high, z, height):
        cube = vtk.vtkCubeSource()
        cube.SetBounds(low[0], high[0], low[1], high[1], z, z + height)
        to.AddInputConnection(cube.GetOutputPort())

    for i, j in np.ndindex(17, 17):
        if (i - 5) ** 2 + (j - 11) ** 2 < 3 or generator.uniform() < 0.03:
            continue  # squares
        middle = np.array((i - 8, j - 8)) + 0.0
        tall = 0.25 + 2.6 * math.exp(-((middle[0] - 1.5) ** 2 + (middle[1] + 1) ** 2) / 12) * generator.uniform(0.35, 1.25)
        for part in generator.permutation(4)[:generator.integers(2, 5)]:
            low = middle + np.array(((part % 2) * 0.42, (part // 2) * 0.42)) - 0.40
            size, height = generator.uniform(0.30, 0.40, 2), tall * generator.uniform(0.55, 1.1)
            block(blocks, low, low + size, 0, height)
            if height > 0.9:
                block(roofs, low + 0.25 * size, low + 0.75 * size, height, 0.12 + 0.1 * height)
    add(renderer, mapped(blocks), (0.90, 0.87, 0.82)), add(renderer, mapped(roofs), (0.80, 0.62, 0.50))
    ground = vtk.vtkCubeSource()
    ground.SetBounds(-9, 9, -9, 9, -0.2, 0)
    add(renderer, mapped(ground), (0.70, 0.73, 0.70))
    renderer.GetActiveCamera().SetWindowCenter(0, -0.22)
    return (0.55, -1, 0.72), (0, 0, 1), 2.2


def laser_scan(renderer):
    """Points of a laser scanner in a wood, drawn as points, in the colours of their heights."""
    generator = np.random.default_rng(21)

    def ground(x, y):
        return 0.5 * np.sin(0.5 * x) * np.cos(0.4 * y) + 0.12 * x

    flat = generator.uniform(-8, 8, (45000, 2))
    parts = [np.column_stack([flat, ground(*flat.T) + generator.normal(0, 0.02, len(flat))])]
    for x, y in generator.uniform(-7.5, 7.5, (60, 2)):
        height, wide = generator.uniform(2.2, 4.2), generator.uniform(0.6, 1.1)
        share, angle = generator.uniform(0, 1, 2600) ** 0.7, generator.uniform(0, 2 * np.pi, 2600)
        r = wide * (1 - share) * (1 + 0.25 * np.sin(9 * share * height)) * generator.uniform(0.75, 1, 2600)
        parts.append(np.column_stack([x + r * np.cos(angle), y + r * np.sin(angle), ground(x, y) + 0.5 + share * height]))
        angle = generator.uniform(0, 2 * np.pi, 160)
        parts.append(np.column_stack([x + 0.08 * np.cos(angle), y + 0.08 * np.sin(angle), ground(x, y) + generator.uniform(0, 0.6, 160)]))
    points = np.concatenate(parts)
    data, places, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    cells.SetCells(len(points), numpy_to_vtkIdTypeArray(np.column_stack([np.ones(len(points), np.int64), np.arange(len(points))]).ravel(), deep=True))
    data.SetPoints(places), data.SetVerts(cells)
    above = points[:, 2] - ground(points[:, 0], points[:, 1])
    data.GetPointData().SetScalars(numpy_to_vtk(above.astype(np.float32), deep=True))
    add(renderer, mapped(data, (0, 4.4), table_of((0, (0.66, 0.56, 0.44)), (0.12, (0.30, 0.45, 0.32)), (0.6, (0.48, 0.66, 0.38)), (1, (0.90, 0.88, 0.55)))), PointSize=4)
    renderer.GetActiveCamera().SetWindowCenter(0, -0.15)
    return (0.5, -1, 0.55), (0, 0, 1), 1.75


SCENES = {f.__name__: f for f in (perovskite, town, laser_scan)}
