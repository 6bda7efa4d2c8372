"""Run by Debian's Python with VTK: draws one of scenes.py off screen into a PNG: python3 draw.py SCENE OUT.png [PIXELS]."""
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import vtk  # noqa: E402
from scenes import SCENES  # noqa: E402


def main(scene, out, size=512):
    actors, (position, up, zoom) = SCENES[scene]()
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    for actor in actors:
        renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(int(size), int(size))
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    window.Render()
    image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(out)
    writer.Write()


main(*sys.argv[1:])
