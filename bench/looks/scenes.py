"""Scenes by which looks are judged: what scientists and engineers show, made by VTK's own sources, so that no data are needed.

Each function fills a vtkRenderer, and may place its camera: (direction towards the viewer, up, zoom) is what it returns.
"""
import math

import vtk

WARM = (0.85, 0.80, 0.72)


def mapped(source, scalars=None, table=None, field=None):
    """A mapper of an algorithm's output; `scalars`: the range that the table covers."""
    mapper = vtk.vtkPolyDataMapper()
    if isinstance(source, vtk.vtkPolyData):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetScalarVisibility(scalars is not None)
    if scalars is not None:
        mapper.SetLookupTable(table or rainbow())
        mapper.SetUseLookupTableScalarRange(False)
        mapper.SetScalarRange(*scalars)
        if field:
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray(field)
    return mapper


def add(renderer, mapper, color=WARM, **values):
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    for name, value in values.items():
        getattr(actor.GetProperty(), f"Set{name}")(value)
    renderer.AddActor(actor)
    return actor


def rainbow():
    table = vtk.vtkLookupTable()
    table.SetHueRange(0.667, 0.0)
    table.SetNumberOfTableValues(256)
    table.Build()
    return table


def bright():
    """Dark violet to light yellow: luminance grows along the table."""
    function = vtk.vtkColorTransferFunction()
    for at, color in ((0, (0.27, 0.0, 0.33)), (0.25, (0.23, 0.32, 0.55)), (0.5, (0.13, 0.57, 0.55)), (0.75, (0.37, 0.79, 0.38)), (1, (0.99, 0.91, 0.14))):
        function.AddRGBPoint(at, *color)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255))
    return table


def wavelet(extent=40):
    source = vtk.vtkRTAnalyticSource()
    source.SetWholeExtent(*(3 * [-extent, extent]))
    return source


def clip(renderer):
    """A volume with an eighth cut out, coloured by its value."""
    box = vtk.vtkBox()
    box.SetBounds(0, 30, 0, 30, 0, 30)
    source, clipped, surface = wavelet(20), vtk.vtkClipDataSet(), vtk.vtkDataSetSurfaceFilter()
    clipped.SetInputConnection(source.GetOutputPort())
    clipped.SetClipFunction(box)
    surface.SetInputConnection(clipped.GetOutputPort())
    add(renderer, mapped(surface, (37, 277), bright(), "RTData"))
    return (1, 0.6, 0.9), (0, 1, 0), 1.2


def contours(renderer):
    """Nested isosurfaces in the colours of their values."""
    source, surfaces = wavelet(), vtk.vtkContourFilter()
    surfaces.SetInputConnection(source.GetOutputPort())
    surfaces.GenerateValues(12, 90, 240)
    add(renderer, mapped(surfaces, (90, 240)))
    return (0.8, 0.75, 1.0), (0, 1, 0), 1.2


def glyphs(renderer):
    """Arrows of a field on a sphere's points."""
    points, field, arrow, glyph = vtk.vtkSphereSource(), vtk.vtkElevationFilter(), vtk.vtkArrowSource(), vtk.vtkGlyph3D()
    points.SetThetaResolution(24), points.SetPhiResolution(16), points.SetRadius(4)
    field.SetInputConnection(points.GetOutputPort())
    field.SetLowPoint(0, 0, -4), field.SetHighPoint(0, 0, 4)
    arrow.SetShaftResolution(16), arrow.SetTipResolution(24)
    glyph.SetInputConnection(field.GetOutputPort())
    glyph.SetSourceConnection(arrow.GetOutputPort())
    glyph.SetVectorModeToUseNormal(), glyph.SetScaleModeToDataScalingOff(), glyph.SetScaleFactor(1.6)
    add(renderer, mapped(glyph, (0, 1), bright(), "Elevation"))
    return (0.4, -1, 0.5), (0, 0, 1), 1.3


def streamlines(renderer):
    """Tubes along lines that wind about each other."""
    for i in range(60):
        line, points, tube = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkTubeFilter()
        cells, values = vtk.vtkCellArray(), vtk.vtkFloatArray()
        values.SetName("speed")
        cells.InsertNextCell(200)
        for k in range(200):
            t, a = k / 199, 2.4 * i
            r = 0.3 + 0.1 * (i % 9) + 0.5 * t * math.sin(3 * t + i)
            points.InsertNextPoint(r * math.cos(a + 9 * t), r * math.sin(a + 9 * t), 4 * t - 2 + 0.2 * math.sin(i))
            values.InsertNextValue(abs(r) / 1.6)
            cells.InsertCellPoint(k)
        line.SetPoints(points), line.SetLines(cells), line.GetPointData().SetScalars(values)
        tube.SetInputData(line)
        tube.SetRadius(0.03), tube.SetNumberOfSides(12), tube.CappingOn()
        add(renderer, mapped(tube, (0, 1), bright()))
    return (1, -0.7, 0.3), (0, 0, 1), 1.3


def heights(up):
    """A landscape over a square, `up`: the axis of heights."""
    plane, warp, normals, height = vtk.vtkPlaneSource(), vtk.vtkProgrammableFilter(), vtk.vtkPolyDataNormals(), vtk.vtkElevationFilter()
    plane.SetOrigin(-5, -5, 0), plane.SetPoint1(5, -5, 0), plane.SetPoint2(-5, 5, 0)
    plane.SetXResolution(160), plane.SetYResolution(160)

    def raise_points():
        given, made, points = warp.GetPolyDataInput(), warp.GetPolyDataOutput(), vtk.vtkPoints()
        made.ShallowCopy(given)
        for i in range(given.GetNumberOfPoints()):
            x, y, _ = given.GetPoint(i)
            z = math.sin(1.3 * x) * math.cos(0.9 * y) + 0.35 * math.sin(3.1 * x + 1.7 * y) + 0.15 * math.sin(7 * y - 5 * x) + 2 * math.exp(-(x - 1) ** 2 - (y + 1) ** 2)
            points.InsertNextPoint(*((x, y, z) if up == 2 else (x, z, -y)))
        made.SetPoints(points)

    warp.SetInputConnection(plane.GetOutputPort())
    warp.SetExecuteMethod(raise_points)
    normals.SetInputConnection(warp.GetOutputPort())
    normals.SplittingOff()
    height.SetInputConnection(normals.GetOutputPort())
    height.SetLowPoint(*[-1.3 * (i == up) for i in range(3)]), height.SetHighPoint(*[2.4 * (i == up) for i in range(3)])
    return mapped(height, (0, 1), bright(), "Elevation")


def terrain_z(renderer):
    """A landscape with z upwards."""
    add(renderer, heights(2))
    return (0.2, -1, 0.7), (0, 0, 1), 1.5


def terrain_y(renderer):
    """The same landscape with y upwards."""
    add(renderer, heights(1))
    return (0.6, 0.8, 1), (0, 1, 0), 1.4


def molecule(renderer):
    """A helix of balls and sticks."""
    colors = ((0.56, 0.56, 0.56), (0.19, 0.31, 0.97), (1.0, 0.05, 0.05), (0.9, 0.9, 0.9))
    last = None
    for i in range(70):
        a = 0.55 * i
        at = (1.6 * math.cos(a), 1.6 * math.sin(a), 0.13 * i)
        ball = vtk.vtkSphereSource()
        ball.SetCenter(*at), ball.SetRadius((0.42, 0.40, 0.38, 0.28)[i % 4]), ball.SetThetaResolution(32), ball.SetPhiResolution(24)
        add(renderer, mapped(ball), colors[i % 4], Specular=0.3, SpecularPower=30)
        if last:
            line, tube = vtk.vtkLineSource(), vtk.vtkTubeFilter()
            line.SetPoint1(*last), line.SetPoint2(*at)
            tube.SetInputConnection(line.GetOutputPort())
            tube.SetRadius(0.12), tube.SetNumberOfSides(16)
            add(renderer, mapped(tube), (0.7, 0.7, 0.7))
        last = at
    renderer.SetBackground(1, 1, 1)
    return (1, -0.3, 0.15), (0, 0, 1), 1.4


def ring(renderer, inner, outer, width, color, **values):
    disk, solid = vtk.vtkDiskSource(), vtk.vtkLinearExtrusionFilter()
    disk.SetInnerRadius(inner), disk.SetOuterRadius(outer), disk.SetCircumferentialResolution(96)
    solid.SetInputConnection(disk.GetOutputPort())
    solid.SetExtrusionTypeToVectorExtrusion(), solid.SetVector(0, 0, width), solid.CappingOn()
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(solid.GetOutputPort())
    normals.SetFeatureAngle(30)
    add(renderer, mapped(normals), color, **values)


def bearing(renderer):
    """A ball bearing, a part of a machine."""
    ring(renderer, 2.9, 3.5, 1, (0.75, 0.77, 0.80), Specular=0.3, SpecularPower=40)
    ring(renderer, 1.4, 1.9, 1, (0.75, 0.77, 0.80), Specular=0.3, SpecularPower=40)
    ring(renderer, 2.3, 2.5, 0.3, (0.85, 0.65, 0.25))
    for i in range(12):
        ball = vtk.vtkSphereSource()
        ball.SetCenter(2.4 * math.cos(math.pi * i / 6), 2.4 * math.sin(math.pi * i / 6), 0.5)
        ball.SetRadius(0.47), ball.SetThetaResolution(48), ball.SetPhiResolution(32)
        add(renderer, mapped(ball), (0.6, 0.62, 0.66), Specular=0.5, SpecularPower=60)
    return (0.3, -0.8, 1), (0, 1, 0), 1.4


def shells(renderer):
    """Thin open shells, seen from both sides."""
    for i in range(3):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(1 + 0.6 * i), ball.SetThetaResolution(96), ball.SetPhiResolution(64)
        ball.SetEndTheta(250 - 30 * i)
        add(renderer, mapped(ball), ((0.85, 0.45, 0.35), (0.45, 0.65, 0.85), (0.8, 0.8, 0.75))[i])
    return (0.7, -1, 0.4), (0, 0, 1), 1.4


def inward(renderer):
    """A surface whose normals and orientation point inwards."""
    knot, normals, turned = vtk.vtkParametricFunctionSource(), vtk.vtkPolyDataNormals(), vtk.vtkReverseSense()
    shape = vtk.vtkParametricTorus()
    shape.SetRingRadius(1.5), shape.SetCrossSectionRadius(0.6)
    knot.SetParametricFunction(shape), knot.SetUResolution(120), knot.SetVResolution(60)
    normals.SetInputConnection(knot.GetOutputPort())
    normals.ConsistencyOn()
    turned.SetInputConnection(normals.GetOutputPort())
    turned.ReverseNormalsOn(), turned.ReverseCellsOn()
    add(renderer, mapped(turned), (0.55, 0.75, 0.55))
    return (0.5, -1, 0.8), (0, 0, 1), 1.4


def dark(renderer):
    """Bumps on a ball before black."""
    ball, bumps = vtk.vtkParametricFunctionSource(), vtk.vtkParametricSuperEllipsoid()
    ball.SetParametricFunction(bumps), ball.SetUResolution(80), ball.SetVResolution(80)
    bumps.SetN1(0.4), bumps.SetN2(1.6)
    for i in range(27):
        copy = vtk.vtkTransform()
        copy.Translate(2.2 * (i % 3), 2.2 * (i // 3 % 3), 2.2 * (i // 9))
        moved = vtk.vtkTransformPolyDataFilter()
        moved.SetInputConnection(ball.GetOutputPort())
        moved.SetTransform(copy)
        add(renderer, mapped(moved), (0.3 + 0.3 * (i % 3), 0.35 + 0.2 * (i // 3 % 3), 0.8 - 0.2 * (i // 9)))
    renderer.SetBackground(0, 0, 0)
    return (1, 0.7, 0.9), (0, 1, 0), 1.3


def chart(renderer):
    """A surface over a plane with a title and a colour bar, on white."""
    mapper = heights(2)
    add(renderer, mapper)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable()), bar.SetTitle("height")
    bar.GetLabelTextProperty().SetColor(0, 0, 0), bar.GetTitleTextProperty().SetColor(0, 0, 0)
    title = vtk.vtkTextActor()
    title.SetInput("Heights over the plane"), title.SetPosition(10, 10), title.GetTextProperty().SetColor(0, 0, 0)
    renderer.AddActor2D(bar), renderer.AddActor2D(title)
    renderer.SetBackground(1, 1, 1)
    return (0.1, -0.4, 1), (0, 1, 0), 1.3


SCENES = {f.__name__: f for f in (clip, contours, glyphs, streamlines, terrain_z, terrain_y, molecule, bearing, shells, inward, dark, chart)}
