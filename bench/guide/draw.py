"""Run by Debian's Python with VTK: draws one of scenes.py off screen into a PNG."""
import pathlib
import sys
import time

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
from support.options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("scene", help="name in scenes.py")
    parser.add_argument("out", metavar="OUT.png")
    parser.add_argument("size", nargs="?", default="640x540", help="of the picture (640x540)")
    parser.add_argument("--samples", type=int, default=8, help="multisampling of the framebuffer (8, VTK's default); 0: none")
    parser.add_argument("--rate", type=int, default=0, metavar="FRAMES", help="turn the camera in a window for so many frames after the picture, and print frames a second")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import vtk  # noqa: E402
from scenes import SCENES  # noqa: E402


def rate(window, camera, frames):
    """Frames a second of a camera that turns; the first frames are not counted."""
    unseen = 2
    for frame in range(-unseen, frames):
        if frame == 0:
            began = time.monotonic()
        camera.Azimuth(1)
        window.Render()
    return frames / (time.monotonic() - began)


def main(scene, out, size, samples, frames):
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    renderer.SetBackground(1, 1, 1)
    window.SetOffScreenRendering(frames == 0)
    window.SetMultiSamples(samples), window.SetSize(*size)
    window.AddRenderer(renderer)
    towards, up, zoom = SCENES[scene](renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(towards)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(up)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()
    window.Render()
    image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    image.SetInput(window)
    image.ReadFrontBufferOff(), image.SetShouldRerender(False)
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(out)
    writer.Write()
    if frames:
        print(f"{rate(window, camera, frames):.3f}")


main(OPTIONS.scene, OPTIONS.out, [int(n) for n in OPTIONS.size.split("x")], OPTIONS.samples, OPTIONS.rate)
