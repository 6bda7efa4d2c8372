"""The program whose pictures looks change: draws scenes of scenes.py into FOLDER/SCENE.png.

With --values also FOLDER/SCENE.colors.png, surfaces without light; SCENE.values.png, the same in greys of their scalars (black: none); and SCENE.depth.npy.
Run by a Python with VTK (python3-vtk9 or python3-paraview).
"""
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
from support.options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("size", help="of the pictures, such as 800x600")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="names in scenes.py (all)")
    parser.add_argument("--values", action="store_true", help="draws the scalars and the depths, too")
    parser.add_argument("--samples", type=int, default=0, help="of multisampling (0: none)")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import numpy as np  # noqa: E402
import vtk  # noqa: E402
from PIL import Image  # noqa: E402
from scenes import SCENES  # noqa: E402
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402


def pixels(window, depth=False):
    """Rows from the top: bytes of red, green, blue, or depths."""
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window), grab.ReadFrontBufferOff(), grab.SetShouldRerender(False)
    grab.SetInputBufferTypeToZBuffer() if depth else grab.SetInputBufferTypeToRGB()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def place(renderer, towards, up, zoom):
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0), camera.SetPosition(*towards), camera.SetViewUp(*up)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()


def greys():
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *(3 * [i / 255]))
    return table


def show_colors(renderer):
    """Surfaces alone, without light."""
    for actor in list(renderer.GetActors2D()):
        renderer.RemoveActor2D(actor)
    for actor in renderer.GetActors():
        actor.GetProperty().LightingOff()


def show_values(renderer):
    """Surfaces in greys of their scalars."""
    renderer.SetBackground(0, 0, 0)
    for actor in renderer.GetActors():
        if actor.GetMapper().GetScalarVisibility():
            actor.GetMapper().SetLookupTable(greys())
        else:
            actor.GetProperty().SetColor(0, 0, 0)


def save(window, path):
    Image.fromarray(np.ascontiguousarray(pixels(window))).save(path)


def draw(name, folder, size, values, samples):
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True), window.SetMultiSamples(samples), window.SetSize(*size)
    renderer.SetBackground(0.32, 0.34, 0.43)
    window.AddRenderer(renderer)
    towards = SCENES[name](renderer)
    place(renderer, *towards)
    window.Render()
    save(window, folder / f"{name}.png")
    if values:
        np.save(folder / f"{name}.depth.npy", pixels(window, depth=True)[..., 0])
        for show, kind in ((show_colors, "colors"), (show_values, "values")):
            show(renderer)
            window.Render()
            save(window, folder / f"{name}.{kind}.png")


def main(options):
    options.folder.mkdir(parents=True, exist_ok=True)
    for name in options.scenes or SCENES:
        draw(name, options.folder, [int(n) for n in options.size.split("x")], options.values, options.samples)
        print(name, flush=True)


main(OPTIONS)
