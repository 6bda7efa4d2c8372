"""Degenerate data: empty data, triangles without area, NaN and infinity."""
import numpy as np
import shapes
from registry import state


def beside(stage):
    """A valid ball, which must be visible in any case."""
    return stage.show(shapes.sphere(stage.vtk, 24), color=(0.4, 0.6, 0.9), at=(1.6, 0, 0))


def look(stage):
    """From fixed places: a camera cannot be placed by bounds that are NaN."""
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(2, 2, 6)
    camera.SetFocalPoint(0.7, 0, 0)
    camera.SetClippingRange(2, 12)
    stage.shoot()
    camera.Azimuth(20)
    stage.shoot()


@state("vtk")
def nothing_at_all(stage):
    stage.look()
    stage.orbit()


@state("vtk")
def empty_actors(stage):
    vtk = stage.vtk
    stage.show(vtk.vtkPolyData())
    stage.show(shapes.poly_data(vtk, np.zeros((0, 3))))
    stage.show(shapes.poly_data(vtk, np.ones((5, 3))))
    beside(stage)
    look(stage)


@state("vtk")
def invisible_actors(stage):
    stage.show(shapes.sphere(stage.vtk)).VisibilityOff()
    stage.show(shapes.sphere(stage.vtk), at=(0.4, 0, 0)).GetProperty().SetOpacity(0)
    beside(stage)
    look(stage)


@state("vtk")
def no_area(stage):
    """Triangles whose corners coincide or lie on a line, among valid ones."""
    vtk = stage.vtk
    points = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, 0, 0], [0, 0, 0], [0.5, 0.5, 0.4]])
    corners = [[0, 1, 2], [0, 0, 1], [0, 3, 1], [0, 4, 2], [2, 2, 2], [1, 2, 5]]
    stage.show(shapes.poly_data(vtk, points, [[3, *c] for c in corners]))
    beside(stage)
    look(stage)


def spoiled(stage, value):
    data = shapes.grid(stage.vtk, 10)
    points = data.GetPoints()
    for i in (0, 37, 55, 99):
        x, y, _ = points.GetPoint(i)
        points.SetPoint(i, x, y, value)
    data.GetPoints().Modified()
    actor = stage.show(data)
    actor.GetMapper().SetVBOShiftScaleMethod(0)
    # VTK does not draw actors whose bounds are NaN.
    actor.UseBoundsOff()
    beside(stage)
    look(stage)


@state("vtk", same_depth=False, outside=False)
def vertices_not_a_number(stage):
    spoiled(stage, np.nan)


@state("vtk", same_depth=False, outside=False)
def vertices_infinite(stage):
    spoiled(stage, np.inf)


@state("vtk")
def vertices_very_far(stage):
    spoiled(stage, 1e30)


@state("vtk")
def normals_of_no_length(stage):
    data = shapes.grid(stage.vtk, 12)
    normals = np.zeros((144, 3), np.float32)
    normals[::3] = (0, 0, 1)
    normals[1::3] = (0, 0, 25)
    data.GetPointData().SetNormals(shapes.array(normals, "Normals", np.float32))
    stage.show(data)
    look(stage)


@state("vtk")
def normals_turned_away(stage):
    data = shapes.grid(stage.vtk, 12)
    normals = np.tile(np.array([[0, 0, -1]], np.float32), (144, 1))
    data.GetPointData().SetNormals(shapes.array(normals, "Normals", np.float32))
    stage.show(data)
    look(stage)


@state("vtk")
def flat_matrix(stage):
    """An actor scaled flat: its matrix has no inverse."""
    stage.show(shapes.sphere(stage.vtk, 24)).SetScale(1, 1, 0)
    beside(stage)
    look(stage)


@state("vtk")
def one_triangle_twice(stage):
    """The same triangle with two colours: the second is visible, because the depth function is LEQUAL."""
    vtk = stage.vtk
    points = np.array([[0, 0, 0], [1, 0, 0.3], [0.5, 1, 0]])
    for color in ((0.9, 0.2, 0.2), (0.2, 0.9, 0.2)):
        stage.show(shapes.poly_data(vtk, points, [[3, 0, 1, 2]]), color=color)
    beside(stage)
    look(stage)


@state("vtk")
def coincident_sheets(stage):
    """Two coincident surfaces, separated by the mapper's offsets."""
    vtk = stage.vtk
    for i, color in enumerate(((0.9, 0.2, 0.2), (0.2, 0.9, 0.2))):
        mapper = stage.mapper(shapes.grid(vtk, 12, 1e-9))
        mapper.SetResolveCoincidentTopologyToPolygonOffset()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0 * i, -2.0 * i)
        stage.show(mapper, color=color)
    look(stage)


@state("vtk")
def sliver_triangles(stage):
    data = shapes.grid(stage.vtk, 60)
    actor = stage.show(data)
    actor.SetScale(1, 1e-3, 1)
    look(stage)


@state("vtk")
def huge_beside_small(stage):
    stage.show(shapes.sphere(stage.vtk, 24, 1e-4), at=(0.7, 0, 5))
    stage.show(stage.vtk.vtkCubeSource(), color=(0.3, 0.5, 0.3), at=(0, -600, 0)).SetScale(1000)
    beside(stage)
    look(stage)
