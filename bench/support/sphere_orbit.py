"""Run by Debian's Python with VTK: a cloud of spheres by VTK's sphere mapper, an orbit of the camera; prints one line of JSON."""
import json
import os
import pathlib
import resource
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("spheres", type=int)
    parser.add_argument("frames", type=int)
    parser.add_argument("size", type=int, help="pixels of the image, both ways")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import numpy as np  # noqa: E402
import vtk  # noqa: E402
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray  # noqa: E402


def resident():
    """Bytes of memory of this process."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def cloud(count):
    """Spheres strewn evenly over a cube, a third of it filled whatever their number."""
    places = np.random.default_rng(1).random((count, 3), dtype=np.float32)
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(places, deep=True))
    cells.SetCells(count, numpy_to_vtkIdTypeArray(np.stack([np.ones(count, np.int64), np.arange(count)], 1).ravel(), deep=True))
    data.SetPoints(points)
    data.SetVerts(cells)
    heights = numpy_to_vtk(places[:, 2].copy(), deep=True)
    data.GetPointData().SetScalars(heights)
    return data, 0.43 * count ** (-1 / 3)


def main(count, frames, size):
    data, radius = cloud(count)
    mapper, actor, renderer, window = vtk.vtkOpenGLSphereMapper(), vtk.vtkActor(), vtk.vtkRenderer(), vtk.vtkRenderWindow()
    mapper.SetInputData(data)
    mapper.SetRadius(radius)
    actor.SetMapper(mapper)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    # An empty image first, so that window and context exist when the clock starts.
    window.Render()
    before, start = resident(), time.perf_counter()
    renderer.AddActor(actor)
    renderer.ResetCamera()
    window.Render()
    window.WaitForCompletion()
    first = time.perf_counter() - start
    times = []
    for _ in range(frames):
        start = time.perf_counter()
        renderer.GetActiveCamera().Azimuth(360 / max(frames, 60))
        renderer.ResetCameraClippingRange()
        window.Render()
        window.WaitForCompletion()
        times.append(time.perf_counter() - start)
    times.sort()
    print(json.dumps({"triangles": count, "first_image_s": first, "frame_s": times[len(times) // 2], "build_s": 0,
                      "rss_bytes": resident() - before,
                      "peak_bytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}), flush=True)


main(OPTIONS.spheres, OPTIONS.frames, OPTIONS.size)
