"""Picking and selecting: ids are drawn as colours and read back, positions are read from the depth buffer."""
import shapes
from registry import state


def clear(stage):
    for source in stage.simple.GetSources().values():
        stage.simple.ClearSelection(source)


def found_by(stage, select, **where):
    """The result of a selection in the window as text: for each source pairs of process and id, or names of blocks."""
    simple = stage.simple
    clear(stage)
    select(View=stage.view, **where)
    words = []
    for number, source in enumerate(simple.GetSources().values()):
        chosen = source.GetSelectionInput(0)
        if not chosen:
            continue
        for part in chosen.Input if "Input" in chosen.ListProperties() else [chosen]:
            for name in ("IDs", "Blocks", "BlockSelectors", "Selectors"):
                if name in part.ListProperties():
                    words.append(f"source {number}: " + " ".join(map(str, part.GetPropertyValue(name))))
    return "; ".join(words) or "nothing"


def select_everywhere(stage, source, *kinds):
    """Selects by rectangles, one of which is empty, and by a polygon; then shows the selection."""
    simple = stage.simple
    stage.look()
    simple.SetActiveSource(source)
    for name in kinds:
        select = getattr(simple, f"SelectSurface{name}")
        for box in ([180, 130, 220, 160], [0, 0, 400, 300], [200, 150, 200, 150], [2, 2, 6, 6]):
            stage.keep_text([f"{name} in {box}: {found_by(stage, select, Rectangle=box)}"])
        polygon = [150, 100, 260, 120, 200, 220]
        stage.keep_text([f"{name} in a polygon: {found_by(stage, select, Polygon=polygon)}"])
        stage.shoot()
    clear(stage)
    stage.shoot()


@state("pvbatch")
def select_cells_and_points(stage):
    source = stage.data(shapes.grid(shapes.vtk_modules()))
    stage.show(source)
    select_everywhere(stage, source, "Cells", "Points")


@state("pvbatch")
def select_colored_cells(stage):
    source = stage.data(shapes.grid(shapes.vtk_modules()))
    stage.show(source, color_by=("CELLS", "number"))
    select_everywhere(stage, source, "Cells", "Points")


@state("pvbatch")
def select_behind_others(stage):
    """Only visible cells are selected: another surface hides half of them."""
    source = stage.simple.Sphere(ThetaResolution=24, PhiResolution=24)
    stage.show(source)
    stage.show(stage.simple.Box(Center=[0.25, 0, 0.6], XLength=0.3, YLength=0.3, ZLength=0.2))
    select_everywhere(stage, source, "Cells", "Points")


@state("pvbatch")
def select_between_frames(stage):
    """Selecting after each camera move, frames in between."""
    source = stage.data(shapes.grid(shapes.vtk_modules()))
    stage.show(source, color_by=("POINTS", "bump"))
    stage.look()
    simple = stage.simple
    simple.SetActiveSource(source)
    for _ in range(3):
        stage.shoot()
        stage.keep_text([found_by(stage, simple.SelectSurfaceCells, Rectangle=[190, 140, 215, 160])])
        clear(stage)
        stage.view.GetActiveCamera().Azimuth(25)


@state("pvbatch")
def select_blocks(stage):
    simple = stage.simple
    source = simple.GroupDatasets(Input=[simple.Sphere(ThetaResolution=16, PhiResolution=16), simple.Box(Center=[1, 0, 0])])
    stage.show(source, color_by=("FIELD", "vtkBlockColors"))
    stage.look()
    simple.SetActiveSource(source)
    stage.keep_text([found_by(stage, simple.SelectSurfaceBlocks, Rectangle=[0, 0, 200, 300])])
    stage.shoot()


def nodes(vtk, selection):
    """A vtkSelection as text, sorted."""
    lines = []
    for i in range(selection.GetNumberOfNodes()):
        node = selection.GetNode(i)
        keys, listed = node.GetProperties(), node.GetSelectionList()
        prop = keys.Get(vtk.vtkSelectionNode.PROP_ID()) if keys.Has(vtk.vtkSelectionNode.PROP_ID()) else -1
        block = keys.Get(vtk.vtkSelectionNode.COMPOSITE_INDEX()) if keys.Has(vtk.vtkSelectionNode.COMPOSITE_INDEX()) else -1
        found = sorted(listed.GetValue(k) for k in range(listed.GetNumberOfTuples())) if listed else []
        lines.append(f"{prop} {block}: {found}")
    return sorted(lines)


def select_by_hardware(stage):
    vtk = stage.vtk
    stage.window.Render()
    for field in (vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS):
        for box in ((0, 0, 399, 299), (180, 130, 220, 170), (200, 150, 200, 150)):
            selector = vtk.vtkHardwareSelector()
            selector.SetRenderer(stage.renderer)
            selector.SetArea(*box)
            selector.SetFieldAssociation(field)
            selection = selector.Select()
            stage.keep_text([f"{field} in {box}:", *nodes(vtk, selection)])
    stage.shoot()


@state("vtk")
def hardware_selector(stage):
    vtk = stage.vtk
    stage.show(shapes.grid(vtk))
    stage.show(shapes.sphere(vtk, 16), at=(0.3, 0.2, 0.5))
    stage.look()
    select_by_hardware(stage)


@state("vtk")
def hardware_selector_of_glyphs(stage):
    vtk = stage.vtk
    shape, mapper = shapes.sphere(vtk, 8), vtk.vtkGlyph3DMapper()
    mapper.SetInputData(shapes.grid(vtk, 8))
    mapper.SetSourceConnection(shape.GetOutputPort())
    mapper.SetScaleFactor(0.2)
    stage.show(mapper)
    stage.show(shapes.sphere(vtk, 16, 0.3))
    stage.look()
    select_by_hardware(stage)


@state("vtk")
def hardware_selector_lines_and_points(stage):
    vtk = stage.vtk
    stage.show(shapes.grid(vtk, 10)).GetProperty().SetRepresentationToWireframe()
    points = stage.show(shapes.sphere(vtk, 12), at=(0.3, 0.2, 0.5))
    points.GetProperty().SetRepresentationToPoints()
    points.GetProperty().SetPointSize(5)
    stage.look()
    select_by_hardware(stage)


@state("vtk")
def place_under_cursor(stage):
    """World coordinates from the depth buffer, one pixel at a time and after each frame."""
    vtk = stage.vtk
    stage.show(shapes.grid(vtk))
    stage.show(shapes.sphere(vtk, 32, 0.3), at=(0, 0, 0.3))
    stage.look()
    picker = vtk.vtkWorldPointPicker()
    for _ in range(3):
        stage.shoot()
        for x, y in ((200, 150), (160, 120), (240, 200), (3, 3)):
            picker.Pick(x, y, 0, stage.renderer)
            stage.keep_text(["%.2f %.2f %.2f" % tuple(value + 0.0 for value in picker.GetPickPosition())])
        stage.renderer.GetActiveCamera().Azimuth(20)


@state("vtk")
def prop_under_cursor(stage):
    vtk = stage.vtk
    actors = [stage.show(shapes.sphere(vtk, 24), at=(0.8 * i, 0, 0)) for i in range(3)]
    stage.look()
    stage.window.Render()
    picker = vtk.vtkPropPicker()
    for x in range(20, 400, 40):
        picker.Pick(x, 150, 0, stage.renderer)
        found = picker.GetActor()
        stage.keep_text([f"{x}: {actors.index(found) if found else 'nothing'}"])
    stage.shoot()
