"""Shapes of scenes.py: height fields, solids of revolution, lines of a magnetic field, atoms of a double helix."""
import math

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray


def height_field(x, y, z):
    """vtkPolyData with normals of a grid of points; arrays of equal shape."""
    points, corner = np.stack([x, y, z], axis=2).reshape(-1, 3), np.arange(x.size).reshape(x.shape)
    a, b, c, d = corner[:-1, :-1].ravel(), corner[:-1, 1:].ravel(), corner[1:, 1:].ravel(), corner[1:, :-1].ravel()
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    rows = np.hstack([np.full((len(triangles), 1), 3), triangles])
    data, vertices, cells, normals = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyDataNormals()
    vertices.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(vertices), data.SetPolys(cells)
    normals.SetInputData(data), normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def turned(outline):
    """The surface that an outline of (radius, height) sweeps about z."""
    points, cells, data, turn, normals = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData(), vtk.vtkRotationalExtrusionFilter(), vtk.vtkPolyDataNormals()
    cells.InsertNextCell(len(outline))
    for radius, height in outline:
        cells.InsertCellPoint(points.InsertNextPoint(radius, 0, height))
    data.SetPoints(points), data.SetLines(cells)
    turn.SetInputData(data), turn.SetResolution(240), turn.CappingOff()
    normals.SetInputConnection(turn.GetOutputPort()), normals.SetFeatureAngle(30), normals.ConsistencyOn()
    return normals


def polylines(lines):
    """vtkPolyData of lines, shape (count, steps, 3)."""
    count, steps, _ = lines.shape
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(lines.reshape(-1, 3).astype(np.float32), deep=True))
    rows = np.hstack([np.full((count, 1), steps), np.arange(count * steps).reshape(count, steps)])
    cells.SetCells(count, numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    data.SetPoints(points), data.SetLines(cells)
    return data


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


def field_lines(count, steps=80, radius=70.0, farthest=190.0):
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


# Bases in the frame of their pair, in angstroms: adenine and thymine (Olson and others 2001). Backbone in cylinder coordinates: radius, degrees, height.
ADENINE = (("N", -1.29, 4.50), ("C", 0.02, 4.90), ("N", 0.88, 3.90), ("C", 0.07, 2.77), ("C", 0.37, 1.40), ("N", 1.61, 0.91), ("N", -0.67, 0.53),
           ("C", -1.91, 1.02), ("N", -2.32, 2.29), ("C", -1.27, 3.12))
THYMINE = (("N", -1.28, 4.50), ("C", -1.46, 3.14), ("O", -2.56, 2.61), ("N", -0.30, 2.41), ("C", 0.99, 2.90), ("O", 1.94, 2.12), ("C", 1.11, 4.34),
           ("C", 2.47, 4.96), ("C", -0.02, 5.06))
BACKBONE = (("P", 8.91, 95.2, 2.08), ("O", 10.2, 91.1, 1.9), ("O", 8.8, 103.3, 1.3), ("O", 7.73, 88.0, 1.8), ("C", 7.70, 79.8, 2.77), ("C", 7.59, 69.9, 2.04),
            ("O", 6.22, 66.0, 1.83), ("C", 8.20, 69.9, 0.73), ("C", 7.04, 73.2, -0.07), ("C", 5.86, 67.4, 0.47))
ATOMS = {"C": (1.7, (0.72, 0.72, 0.70)), "N": (1.55, (0.35, 0.50, 0.85)), "O": (1.52, (0.85, 0.35, 0.30)), "P": (1.8, (0.95, 0.65, 0.25))}


def pair_atoms(number):
    """Atoms of a pair of bases and their backbones: (element, place)."""
    turn = math.radians(36 * number)
    backbone = [(e, (-r * math.cos(math.radians(a)), r * math.sin(math.radians(a)), -z)) for e, r, a, z in BACKBONE]
    for strand, base in ((1, (ADENINE, THYMINE)[number % 2]), (-1, (THYMINE, ADENINE)[number % 2])):
        for element, (x, y, z) in [*backbone, *((e, (x, y, 0.0)) for e, x, y in base)]:
            y, z = strand * y, strand * z
            yield element, (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z + 3.38 * number)
