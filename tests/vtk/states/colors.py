"""Colours from data: at points and cells, through colour maps and directly, with all odd contents of arrays."""
import numpy as np
import shapes
from registry import state


def sheet(stage):
    return stage.data(shapes.grid(shapes.vtk_modules()))


def sheet_with(stage, values, name="values", kind=np.float64, cells=False):
    data = shapes.grid(shapes.vtk_modules())
    (data.GetCellData() if cells else data.GetPointData()).AddArray(shapes.array(values(data), name, kind))
    return stage.data(data)


def wave(data):
    return np.linspace(-1, 1, data.GetNumberOfPoints())


@state("pvbatch")
def point_scalars(stage):
    stage.show(sheet(stage), color_by=("POINTS", "bump"), InterpolateScalarsBeforeMapping=1)
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def point_scalars_mapped_first(stage):
    stage.show(sheet(stage), color_by=("POINTS", "bump"), InterpolateScalarsBeforeMapping=0)
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def point_scalars_flat(stage):
    stage.show(sheet(stage), color_by=("POINTS", "bump"), Interpolation="Flat")
    stage.look()
    stage.orbit()


@state("pvbatch")
def cell_scalars(stage):
    stage.show(sheet(stage), color_by=("CELLS", "number"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def cell_scalars_many_blocks(stage):
    """Cell numbers continue from block to block: the blocks share textures of cell colours."""
    simple = stage.simple
    vtk = shapes.vtk_modules()
    parts = []
    for i in range(3):
        part = stage.data(shapes.grid(vtk, 10 + i))
        parts.append(simple.Transform(part))
        parts[-1].Transform.Translate = [2.2 * i, 0, 0]
    stage.show(simple.GroupDatasets(Input=parts), color_by=("CELLS", "number"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def direct_rgb(stage):
    source = sheet_with(stage, lambda data: np.stack([np.arange(data.GetNumberOfPoints()) * k % 256 for k in (1, 3, 7)], 1),
                        "rgb", np.uint8)
    stage.show(source, color_by=("POINTS", "rgb"), MapScalars=0)
    stage.look()
    stage.orbit()


@state("pvbatch")
def direct_rgb_of_cells(stage):
    source = sheet_with(stage, lambda data: np.stack([np.arange(data.GetNumberOfCells()) * k % 256 for k in (1, 3, 7)], 1),
                        "rgb", np.uint8, cells=True)
    stage.show(source, color_by=("CELLS", "rgb"), MapScalars=0)
    stage.look()
    stage.orbit()


@state("pvbatch")
def few_colors(stage):
    display = stage.show(sheet(stage), color_by=("POINTS", "bump"))
    display.LookupTable.NumberOfTableValues = 5
    stage.look()
    stage.orbit()


@state("pvbatch")
def out_of_range_colors(stage):
    display = stage.show(sheet(stage), color_by=("POINTS", "bump"))
    table = display.LookupTable
    table.RescaleTransferFunction(-0.4, 0.5)
    table.UseBelowRangeColor, table.BelowRangeColor = 1, [0, 1, 0]
    table.UseAboveRangeColor, table.AboveRangeColor = 1, [1, 0, 1]
    stage.look()
    stage.orbit()


@state("pvbatch")
def clamped_colors(stage):
    display = stage.show(sheet(stage), color_by=("POINTS", "bump"))
    display.LookupTable.RescaleTransferFunction(-0.2, 0.2)
    stage.look()
    stage.orbit()


def some_nan(data):
    values = wave(data)
    values[::7] = np.nan
    values[100:140] = np.nan
    values[3], values[4] = np.inf, -np.inf
    return values


@state("pvbatch")
def nan_scalars(stage):
    display = stage.show(sheet_with(stage, some_nan), color_by=("POINTS", "values"))
    display.LookupTable.RescaleTransferFunction(-1, 1)
    display.LookupTable.NanColor = [0.1, 0.9, 0.2]
    stage.look()
    stage.orbit()


@state("pvbatch")
def nan_scalars_mapped_first(stage):
    display = stage.show(sheet_with(stage, some_nan), color_by=("POINTS", "values"), InterpolateScalarsBeforeMapping=0)
    display.LookupTable.RescaleTransferFunction(-1, 1)
    stage.look()
    stage.orbit()


@state("pvbatch")
def log_scale(stage):
    display = stage.show(sheet_with(stage, lambda data: 10 ** (3 * wave(data))), color_by=("POINTS", "values"))
    display.LookupTable.MapControlPointsToLogSpace()
    display.LookupTable.UseLogScale = 1
    stage.look()
    stage.orbit()


@state("pvbatch")
def categories(stage):
    display = stage.show(sheet(stage), color_by=("CELLS", "number"))
    table = display.LookupTable
    table.InterpretValuesAsCategories = 1
    table.Annotations = [str(i // 2) for i in range(34)]
    table.IndexedColors = [c for i in range(17) for c in (i / 16, 1 - i / 16, i % 3 / 2)]
    stage.look()
    stage.orbit()


@state("pvbatch")
def vector_magnitude(stage):
    source = sheet_with(stage, lambda data: np.stack([wave(data), wave(data) ** 2, np.sin(9 * wave(data))], 1), "arrows")
    stage.show(source, color_by=("POINTS", "arrows"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def constant_scalars(stage):
    stage.show(sheet_with(stage, lambda data: 0 * wave(data) + 3.25), color_by=("POINTS", "values"))
    stage.look()
    stage.orbit()


@state("vtk")
def scalars_without_normals(stage):
    """Colours at the vertices; each triangle's normal is computed from its positions."""
    data = shapes.grid(stage.vtk)
    data.GetPointData().SetNormals(None)
    data.GetPointData().SetActiveScalars("bump")
    stage.show(data).GetMapper().SetScalarRange(-1, 1)
    stage.look()
    stage.orbit()


@state("vtk")
def cell_normals(stage):
    vtk = stage.vtk
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(shapes.grid(vtk, 12))
    normals.ComputePointNormalsOff()
    normals.ComputeCellNormalsOn()
    stage.show(normals)
    stage.look()
    stage.orbit()
