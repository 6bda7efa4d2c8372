"""Data and images that several states draw. Functions are given the vtk module of the program that they run in."""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "live"))
import images  # noqa: E402


def vtk_modules():
    """VTK classes that states for ParaView need beside its proxies: its `vtk` module does not always exist."""
    import vtkmodules.vtkCommonCore as core
    import vtkmodules.vtkCommonDataModel as model
    import vtkmodules.vtkFiltersSources as sources

    class Modules:
        def __getattr__(self, name):
            for module in (core, model, sources):
                if hasattr(module, name):
                    return getattr(module, name)
            raise AttributeError(name)

    return Modules()


def checkers(path, size=64, step=8):
    """A PNG of dark and bright squares, one corner red so that its orientation shows."""
    i, j = np.indices((size, size)) // step
    image = np.where(((i + j) % 2)[..., None] == 0, [60, 60, 200], [240, 230, 120]).astype(np.uint8)
    image[: 2 * step, : 2 * step] = [255, 0, 0]
    images.write_png(path, image)
    return path


def array(values, name, kind=np.float64):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    made = numpy_to_vtk(np.ascontiguousarray(values, kind), deep=True)
    made.SetName(name)
    return made


def dotted_image(vtk, size=64):
    """RGBA: opaque dots of two colours, nothing between them."""
    i, j = np.indices((size, size)) % 16 - 8
    inside = (i * i + j * j < 40)[..., None]
    pixels = np.where(inside, [250, 120, 40, 255], [0, 0, 0, 0])
    image = vtk.vtkImageData()
    image.SetDimensions(size, size, 1)
    image.GetPointData().SetScalars(array(pixels.reshape(-1, 4), "rgba", np.uint8))
    return image


def sphere(vtk, resolution=32, radius=0.5):
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetRadius(radius)
    return source


def grid(vtk, count=24, height=0.25):
    """A wavy sheet of triangles with normals, `bump` at the points and `number` at the cells."""
    x, y = np.meshgrid(np.linspace(-1, 1, count), np.linspace(-1, 1, count))
    z = height * np.sin(4 * x) * np.cos(3 * y)
    gradient = np.stack([-4 * height * np.cos(4 * x) * np.cos(3 * y), 3 * height * np.sin(4 * x) * np.sin(3 * y), 1 + 0 * x], -1)
    a = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    triangles = np.stack([np.full(a.size * 2, 3), *np.concatenate(
        [np.stack([a, a + 1, a + count + 1], 1), np.stack([a, a + count + 1, a + count], 1)]).T], 1)
    data = poly_data(vtk, np.stack([x, y, z], -1).reshape(-1, 3), triangles)
    gradient = gradient.reshape(-1, 3)
    data.GetPointData().SetNormals(array(gradient / np.linalg.norm(gradient, axis=1, keepdims=True), "Normals", np.float32))
    data.GetPointData().AddArray(array(z.ravel() / height, "bump"))
    data.GetCellData().AddArray(array(np.arange(triangles.shape[0]) % 17, "number"))
    return data


def poly_data(vtk, points, polygons=None, lines=None):
    """`polygons`, `lines`: rows of a count and as many indices."""
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    data, where = vtk.vtkPolyData(), vtk.vtkPoints()
    where.SetData(array(points, "points"))
    data.SetPoints(where)
    for rows, put in ((polygons, data.SetPolys), (lines, data.SetLines)):
        if rows is not None:
            cells = vtk.vtkCellArray()
            cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(np.ascontiguousarray(rows, np.int64).ravel(), deep=True))
            put(cells)
    return data


def star(vtk, corners=7):
    """One polygon that is not convex: VTK cuts it into triangles."""
    a = np.arange(2 * corners) * np.pi / corners
    radius = np.where(np.arange(2 * corners) % 2, 0.25, 0.6)
    points = np.stack([radius * np.cos(a), radius * np.sin(a), 0 * a], 1)
    return poly_data(vtk, points, np.concatenate([[2 * corners], np.arange(2 * corners)])[None])


def cloud(vtk, n=8, size=0.4):
    """Points in a grid with radii and a scalar."""
    data = grid(vtk, n, size)
    count = data.GetNumberOfPoints()
    data.GetPointData().AddArray(array([0.05 + 0.01 * (i % 5) for i in range(count)], "radius", np.float32))
    data.GetPointData().SetActiveScalars("bump")
    return data
