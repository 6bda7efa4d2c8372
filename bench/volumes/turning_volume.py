"""Frames of a volume that turns, drawn by VTK's ray caster (python3-vtk9, or ParaView's Python).

Prints a line of JSON: the median time of a frame after the first ones, and the memory that is resident after the last one.
"""
import json
import pathlib
import statistics
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("--field", choices=("dense", "sparse"), default="dense", help="a smooth field, a third of it empty; or tubes")
    parser.add_argument("--voxels", type=int, default=256, help="along each axis")
    parser.add_argument("--step", type=float, default=1, help="of rays, in voxels")
    parser.add_argument("--bytes", action="store_true", help="voxels of 8 bits in place of floats")
    parser.add_argument("--lit", action="store_true", help="with light")
    parser.add_argument("--warm", type=int, default=2, help="frames before those that count")
    parser.add_argument("--frames", type=int, default=5)
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import numpy as np  # noqa: E402
import vtk  # noqa: E402
from vtk.util.numpy_support import numpy_to_vtk  # noqa: E402

SIZE = (800, 600)
OPACITIES = {"dense": ((0, 0), (0.35, 0), (0.6, 0.04), (1, 0.1)), "sparse": ((0, 0), (0.1, 0), (1, 0.5))}


def dense(x, y, z):
    return 0.5 + 0.5 * np.sin(5 * x) * np.cos(4 * y) * np.sin(3 * z)


def sparse(*axes):
    """Fourteen winding tubes."""
    field = np.zeros(np.broadcast_shapes(*(axis.shape for axis in axes)), "f4")
    generator = np.random.default_rng(1)
    for tube in range(14):
        (a, b), phase, along = generator.uniform(-0.8, 0.8, 2), generator.uniform(0, 6), tube % 3
        first = a + 0.15 * np.sin(3 * axes[along] + phase)
        second = b + 0.15 * np.cos(4 * axes[along] + phase)
        square = (axes[(along + 1) % 3] - first) ** 2 + (axes[(along + 2) % 3] - second) ** 2
        field = np.maximum(field, np.exp(-square / 0.002))
    return field


def image():
    count = OPTIONS.voxels
    line = np.linspace(-1, 1, count, dtype="f4")
    z, y, x = np.meshgrid(line, line, line, indexing="ij", sparse=True)
    field = np.empty((count,) * 3, "u1" if OPTIONS.bytes else "f4")
    for first in range(0, count, 16):  # large volumes need no more memory than their voxels
        part = slice(first, first + 16)
        values = {"dense": dense, "sparse": sparse}[OPTIONS.field](x, y, z[part])
        field[part] = 255 * values if OPTIONS.bytes else values
    data = vtk.vtkImageData()
    data.SetDimensions(count, count, count)
    data.SetSpacing(*[2 / (count - 1)] * 3)
    data.SetOrigin(-1, -1, -1)
    data.GetPointData().SetScalars(numpy_to_vtk(field.ravel()))
    return data


def look():
    most = 255 if OPTIONS.bytes else 1
    color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for at, rgb in ((0, (0, 0, 1)), (0.5, (1, 1, 1)), (1, (1, 0, 0))):
        color.AddRGBPoint(at * most, *rgb)
    for at, value in OPACITIES[OPTIONS.field]:
        opacity.AddPoint(at * most, value)
    made = vtk.vtkVolumeProperty()
    made.SetColor(color)
    made.SetScalarOpacity(opacity)
    made.SetInterpolationTypeToLinear()
    made.SetScalarOpacityUnitDistance(0.05)
    made.SetShade(OPTIONS.lit)
    return made


def resident():
    """Bytes."""
    status = pathlib.Path("/proc/self/status").read_text()
    return int(next(line for line in status.splitlines() if line.startswith("VmRSS")).split()[1]) * 1024


def main():
    mapper = vtk.vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image())
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(OPTIONS.step * 2 / (OPTIONS.voxels - 1))
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look())
    renderer, window, pixel = vtk.vtkRenderer(), vtk.vtkRenderWindow(), vtk.vtkUnsignedCharArray()
    renderer.SetBackground(0.1, 0.2, 0.3)
    renderer.AddVolume(volume)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    renderer.GetActiveCamera().Azimuth(30)
    renderer.GetActiveCamera().Elevation(25)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.3)
    seconds = []
    for _ in range(OPTIONS.warm + OPTIONS.frames):
        renderer.GetActiveCamera().Azimuth(1)
        begin = time.perf_counter()
        window.Render()
        window.GetRGBACharPixelData(0, 0, 0, 0, 0, pixel)
        seconds.append(time.perf_counter() - begin)
    print(json.dumps({"first_image_s": seconds[0], "frame_s": statistics.median(seconds[OPTIONS.warm:]), "rss_bytes": resident()}), flush=True)


if __name__ == "__main__":
    main()
