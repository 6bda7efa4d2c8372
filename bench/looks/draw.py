"""The program whose pictures looks change: draws scenes into FOLDER/SCENE.png.

usage: draw.py FOLDER SIZE [--values] SCENE...    SIZE: 800x600
With --values also FOLDER/SCENE.values.png, surfaces without light in greys of their scalars (black: none), and SCENE.depth.npy.
Run by Python with VTK (python3-vtk9 or python3-paraview).
"""
import pathlib
import sys

import numpy as np
import vtk
from PIL import Image
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from scenes import SCENES


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


def show_values(renderer):
    """Surfaces in greys of their scalars, without light."""
    renderer.SetBackground(0, 0, 0)
    for actor in renderer.GetActors():
        actor.GetProperty().LightingOff()
        if actor.GetMapper().GetScalarVisibility():
            actor.GetMapper().SetLookupTable(greys())
        else:
            actor.GetProperty().SetColor(0, 0, 0)


def draw(name, folder, size, values):
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True), window.SetMultiSamples(0), window.SetSize(*size)
    renderer.SetBackground(0.32, 0.34, 0.43)
    window.AddRenderer(renderer)
    towards = SCENES[name](renderer)
    place(renderer, *towards)
    window.Render()
    Image.fromarray(np.ascontiguousarray(pixels(window))).save(folder / f"{name}.png")
    if values:
        np.save(folder / f"{name}.depth.npy", pixels(window, depth=True)[..., 0])
        for actor in list(renderer.GetActors2D()):
            renderer.RemoveActor2D(actor)
        show_values(renderer)
        window.Render()
        Image.fromarray(np.ascontiguousarray(pixels(window))).save(folder / f"{name}.values.png")


def main(arguments):
    values = "--values" in arguments
    folder, size, *names = [a for a in arguments if a != "--values"]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or SCENES:
        draw(name, folder, [int(n) for n in size.split("x")], values)
        print(name, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
