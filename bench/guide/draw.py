"""Run by Debian's Python with VTK: draws one of scenes.py off screen into a PNG."""
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..")]
from support.options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("scene", help="name in scenes.py")
    parser.add_argument("out", metavar="OUT.png")
    parser.add_argument("pixels", nargs="?", type=int, default=512, help="width and height (512)")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import vtk  # noqa: E402
from scenes import SCENES  # noqa: E402


def main(scene, out, size):
    actors, (position, up, zoom) = SCENES[scene]()
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    for actor in actors:
        renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
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


main(OPTIONS.scene, OPTIONS.out, OPTIONS.pixels)
