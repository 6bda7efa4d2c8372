"""Run by pvbatch: contours of ParaView's Wavelet source, an orbit of the camera around them; prints one line of JSON.

"frame_s" is the median of FRAMES frames.
"""
import json
import math
import os
import pathlib
import resource
import statistics
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from options import Parser  # noqa: E402

LOOKS = ("surface", "edges", "translucent", "summed")


def arguments():
    parser = Parser(__doc__, usage="pvbatch paraview_orbit.py ISOVALUES FRAMES SIZE [IMAGE [LOOK or SOURCE [WARM]]]")
    parser.add_argument("isovalues", type=float, help="number of isosurfaces; with SOURCE one value")
    parser.add_argument("frames", type=int)
    parser.add_argument("size", type=int, help="pixels of the image, both ways")
    parser.add_argument("picture", nargs="?", default="-", help="PNG file of the first frame; -: none (-)")
    parser.add_argument("look", nargs="?", default="surface", metavar="LOOK or SOURCE",
                        help="LOOK: surface, edges, translucent (peeled) or summed (translucent without peeling). "
                             "SOURCE: a NIfTI or other file that ParaView reads, in place of the Wavelet (surface)")
    parser.add_argument("warm", nargs="?", type=float, default=0, help='seconds of orbit before the frames that count, "early_frame_s" (0)')
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
from paraview import simple  # noqa: E402


def resident():
    """Bytes of memory of this process."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def isosurfaces(count):
    """Nested surfaces as in the measurements of the paper: `count` values evenly over the data's range."""
    low, high = 33.951, 286.341
    wavelet = simple.Wavelet()
    wavelet.WholeExtent = [-100, 100] * 3
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"])
    contour.Isosurfaces = [low + (i + 0.5) / count * (high - low) for i in range(count)]
    contour.UpdatePipeline()
    return contour


def scan(file, value):
    """The isosurface of a scan."""
    reader = simple.OpenDataFile(file)
    reader.UpdatePipeline()
    contour = simple.Contour(Input=reader, ContourBy=["POINTS", reader.PointData[0].Name], Isosurfaces=[value])
    contour.UpdatePipeline()
    return contour


def orbit(view, up):
    """A function that puts the camera on its orbit, at an angle in degrees from the start."""
    centre, eye = list(view.CameraFocalPoint), list(view.CameraPosition)
    distance = math.dist(centre, eye)
    lift = math.radians(35.26)
    view.CameraViewUp = up

    def place(degrees):
        angle = math.radians(30 + degrees)
        flat = [math.cos(lift) * math.sin(angle), math.cos(lift) * math.cos(angle)]
        way = [flat[0], math.sin(lift), flat[1]] if up[1] else [flat[0], -flat[1], math.sin(0.2)]
        view.CameraPosition = [c + distance * w for c, w in zip(centre, way)]
    return place


def style(display, look, source):
    """How the surface is drawn."""
    if not source:
        simple.ColorBy(display, ("POINTS", "RTData"))
    else:
        display.ColorArrayName = [None, ""]  # one colour
        display.DiffuseColor = [0.95, 0.83, 0.73]
        display.Specular = 0.3
    if look == "edges":
        display.Representation = "Surface With Edges"
    elif look in ("translucent", "summed"):
        display.Opacity = 0.4
        simple.GetSettingsProxy("RenderViewSettings").DepthPeeling = int(look == "translucent")


def main(options):
    count, frames, size = options.isovalues, options.frames, options.size
    look, source = (options.look, None) if options.look in LOOKS else ("surface", options.look)
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    view.ViewSize = [size, size]
    surface = scan(source, count) if source else isosurfaces(int(count))
    triangles = surface.GetDataInformation().GetNumberOfCells()
    window = view.GetRenderWindow()
    # An empty image first, so that window and context exist when the clock starts.
    simple.Render(view)
    before = resident()
    start = time.perf_counter()
    display = simple.Show(surface, view)
    style(display, look, source)
    simple.ResetCamera(view)
    simple.Render(view)
    window.WaitForCompletion()
    first = time.perf_counter() - start
    place = orbit(view, [0, 0, 1] if source else [0, 1, 0])

    def frame_time(number):
        """Seconds that one frame of the orbit takes."""
        start = time.perf_counter()
        place(360 * number / max(frames, 60))
        simple.Render(view)
        window.WaitForCompletion()
        return time.perf_counter() - start

    early, end = [], time.perf_counter() + options.warm
    while time.perf_counter() < end:
        early.append(frame_time(len(early)))
    times = [frame_time(number) for number in range(frames)]
    place(0)
    if options.picture != "-":
        simple.SaveScreenshot(options.picture, view, ImageResolution=[size, size])
    print(json.dumps({"triangles": triangles, "first_image_s": first, **({"early_frame_s": statistics.median(early)} if early else {}),
                      "frame_s": statistics.median(times), "build_s": 0, "rss_bytes": resident() - before,
                      "peak_bytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}), flush=True)


main(OPTIONS)
