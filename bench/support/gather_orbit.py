"""Run by pvbatch, on any number of ranks: isosurfaces of ParaView's Wavelet source, cut among the ranks; prints one line of JSON on rank 0.

The image has 1000x800 pixels; each frame turns the camera by 5 degrees. "frame_s" is the median of FRAMES frames after two others.
"""
import json
import pathlib
import statistics
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__, usage="pvbatch gather_orbit.py EXTENT ISOVALUES FRAMES")
    parser.add_argument("extent", type=int, help="the source has twice as many points each way, and one")
    parser.add_argument("isovalues", type=int, help="number of isosurfaces")
    parser.add_argument("frames", type=int)
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
from paraview import simple  # noqa: E402


def main(extent, count, frames):
    low, high = 33.951, 286.341
    wavelet = simple.Wavelet(WholeExtent=[-extent, extent] * 3)
    values = [low + (i + 0.5) / count * (high - low) for i in range(count)]
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=values)
    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 800]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.9, 0.9, 1]
    simple.Show(contour, view)
    simple.ResetCamera(view)
    seconds = []
    for frame in range(frames + 2):
        simple.GetActiveCamera().Azimuth(5)
        begin = time.monotonic()
        simple.Render(view)
        if frame >= 2:
            seconds.append(time.monotonic() - begin)
    triangles = contour.GetDataInformation().GetNumberOfCells()  # of all ranks
    print(json.dumps({"frame_s": statistics.median(seconds), "triangles": triangles}), flush=True)


main(OPTIONS.extent, OPTIONS.isovalues, OPTIONS.frames)
