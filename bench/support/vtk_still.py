"""Run by python3 with VTK: a sphere, drawn so many times turned by a degree each, and so many times unchanged; prints one line of JSON."""
import json
import pathlib
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("resolution", type=int, help="of the sphere, both ways")
    parser.add_argument("frames", type=int)
    parser.add_argument("samples", nargs="?", type=int, default=0, help="of the window, each pixel (0)")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import vtk  # noqa: E402


def main(resolution, frames, samples):
    source, mapper, actor = vtk.vtkSphereSource(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetSize(1024, 1024)
    window.SetMultiSamples(samples)
    window.AddRenderer(renderer)
    renderer.AddActor(actor)
    renderer.ResetCamera()
    for _ in range(2):
        window.Render()

    def milliseconds(degrees=None):
        """Milliseconds of a frame; without degrees nothing changes in between."""
        start = time.perf_counter()
        for _ in range(frames):
            if degrees is not None:
                renderer.GetActiveCamera().Azimuth(degrees)
            window.Render()
        return 1000 * (time.perf_counter() - start) / frames

    rounds = [(milliseconds(1), milliseconds()) for _ in range(3)]
    print(json.dumps({"triangles": source.GetOutput().GetNumberOfCells(), "moving_ms": [a for a, _ in rounds],
                      "unchanged_ms": [b for _, b in rounds]}))


main(OPTIONS.resolution, OPTIONS.frames, OPTIONS.samples)
