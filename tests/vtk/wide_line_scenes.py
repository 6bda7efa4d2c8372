"""Lines drawn by ParaView or VTK, for wide_lines.py.

    pvbatch wide_line_scenes.py FOLDER WIDTH NAME ...
    python3 wide_line_scenes.py FOLDER WIDTH NAME ...      scenes whose names begin with vtk_

Writes FOLDER/NAME.png, with lines WIDTH pixels wide.
"""
import math
import pathlib
import sys

SIZE = 320, 240
TURNS, POINTS = 3, 40


def helices(vtk, normals=False):
    """Three lines of 39 segments each, with scalars at points; with normals VTK lights them."""
    points, cells, height, up = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkFloatArray(), vtk.vtkFloatArray()
    height.SetName("height")
    up.SetName("Normals")
    up.SetNumberOfComponents(3)
    for turn in range(TURNS):
        cells.InsertNextCell(POINTS)
        for i in range(POINTS):
            at = math.cos(0.3 * i) + 0.4 * turn, math.sin(0.3 * i), 0.08 * i - 0.5 * turn
            cells.InsertCellPoint(points.InsertNextPoint(*at))
            height.InsertNextValue(at[2])
            up.InsertNextTuple3(0, 0.6, 0.8)
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetLines(cells)
    data.GetPointData().AddArray(height)
    if normals:
        data.GetPointData().SetNormals(up)
    kinds = vtk.vtkFloatArray()
    kinds.SetName("kind")
    for turn in range(TURNS):
        kinds.InsertNextValue(turn)
    data.GetCellData().AddArray(kinds)
    return data


def paraview(file, width, color_by=None, **look):
    import vtk
    from paraview import simple
    view = simple.CreateRenderView(ViewSize=list(SIZE), OrientationAxesVisibility=0, UseFXAA=0)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(helices(vtk, look.pop("normals", False)))
    source.UpdatePipeline()
    display = simple.Show(source, view)
    display.LineWidth = width
    for name, value in look.items():
        setattr(display, name, value)
    if color_by:
        simple.ColorBy(display, color_by)
        display.RescaleTransferFunctionToDataRange(True, False)
        display.SetScalarBarVisibility(view, False)
    simple.ResetCamera(view)
    view.GetActiveCamera().Azimuth(20)
    view.GetActiveCamera().Elevation(25)
    view.GetRenderer().ResetCameraClippingRange()
    simple.SaveScreenshot(file, view, ImageResolution=list(SIZE))
    simple.Delete(view)


def plain(file, width, normals=False):
    """Two crossing lines by VTK itself, which leaves widths to OpenGL up to OpenGL's limit."""
    import vtk
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    append = vtk.vtkAppendPolyData()
    for sign in (-1, 1):
        line = vtk.vtkLineSource()
        line.SetPoint1(-1, -0.6, 0.3 * sign)
        line.SetPoint2(1, 0.6 * sign, -0.3 * sign)
        append.AddInputConnection(line.GetOutputPort())
    append.Update()
    data = append.GetOutput()
    if normals:
        up = vtk.vtkFloatArray()
        up.SetNumberOfComponents(3)
        for _ in range(data.GetNumberOfPoints()):
            up.InsertNextTuple3(0, 0.6, 0.8)
        data.GetPointData().SetNormals(up)
    mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
    mapper.SetInputData(data)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.9, 0.6, 0.3)
    actor.GetProperty().SetLineWidth(width)
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Dolly(0.3)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


SCENES = {
    "unlit": lambda file, width: paraview(file, width, AmbientColor=[0.9, 0.6, 0.3], DiffuseColor=[0.9, 0.6, 0.3]),
    "lit": lambda file, width: paraview(file, width, normals=True, DiffuseColor=[0.9, 0.6, 0.3]),
    "scalars": lambda file, width: paraview(file, width, color_by=("POINTS", "height")),
    "lit_scalars": lambda file, width: paraview(file, width, normals=True, color_by=("POINTS", "height")),
    "cells": lambda file, width: paraview(file, width, color_by=("CELLS", "kind")),
    "vtk_unlit": plain,
    "vtk_lit": lambda file, width: plain(file, width, normals=True),
}

if __name__ == "__main__":
    for name in sys.argv[3:]:
        SCENES[name](str(pathlib.Path(sys.argv[1]) / f"{name}.png"), float(sys.argv[2]))
