"""Surfaces and glyphs without lights: every source of their colours."""
import looks
import numpy as np
import shapes
from registry import state


def sheet(stage, colors="none", opacity=1, peels=False):
    """A wavy sheet without lights, behind a ball that is lit."""
    vtk, data = stage.vtk, shapes.grid(stage.vtk, 10)
    actor = stage.show(data)
    mapper, look = actor.GetMapper(), actor.GetProperty()
    look.LightingOff()
    look.SetAmbient(0.3)
    look.SetDiffuse(0.6)
    look.SetOpacity(opacity)
    if colors in ("vertices", "map"):
        data.GetPointData().SetActiveScalars("bump")
        mapper.SetScalarRange(-1, 1)
        mapper.SetInterpolateScalarsBeforeMapping(colors == "map")
    elif colors == "cells":
        data.GetCellData().SetActiveScalars("number")
        mapper.SetScalarRange(0, 17)
    elif colors == "direct":
        n = np.arange(data.GetNumberOfPoints())
        data.GetPointData().SetScalars(shapes.array(np.stack([n * k % 256 for k in (1, 3, 7)], 1), "rgb", np.uint8))
    stage.show(shapes.sphere(vtk, 32, 0.4), color=(0.3, 0.6, 0.9))
    if opacity < 1:
        stage.renderer.UseDepthPeelingOff()
    if peels:
        looks.peel(stage)
    stage.look()
    stage.orbit(3)
    return actor


@state("vtk")
def unlit_vertex_colors(stage):
    sheet(stage, "vertices")


@state("vtk")
def unlit_color_map(stage):
    sheet(stage, "map")


@state("vtk")
def unlit_cell_colors(stage):
    sheet(stage, "cells")


@state("vtk")
def unlit_direct_colors(stage):
    sheet(stage, "direct")


@state("vtk")
def unlit_both_sides(stage):
    """Another colour on back faces."""
    other = stage.vtk.vtkProperty()
    other.SetColor(1, 0.2, 0.1)
    other.LightingOff()
    sheet(stage).SetBackfaceProperty(other)
    stage.look(elevation=-60)
    stage.orbit()


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def unlit_peeled(stage):
    sheet(stage, "map", 0.5, peels=True)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def unlit_summed(stage):
    sheet(stage, "vertices", 0.5)


def arrows(stage, opacity=1):
    vtk, data, mapper = stage.vtk, shapes.grid(stage.vtk, 4), stage.vtk.vtkGlyph3DMapper()
    data.GetPointData().SetActiveScalars("bump")
    stage.kept = vtk.vtkArrowSource()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(stage.kept.GetOutputPort())
    mapper.SetScaleFactor(0.6)
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScalarRange(-1, 1)
    look = stage.show(mapper).GetProperty()
    look.LightingOff()
    look.SetOpacity(opacity)
    stage.look()
    stage.orbit(3)


@state("vtk")
def unlit_arrows(stage):
    arrows(stage)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def unlit_arrows_peeled(stage):
    looks.peel(stage)
    arrows(stage, 0.5)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def unlit_arrows_summed(stage):
    stage.renderer.UseDepthPeelingOff()
    arrows(stage, 0.5)
