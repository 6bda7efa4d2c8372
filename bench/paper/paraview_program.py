"""Run by pvbatch: a mesh from a file in ParaView's view with its own settings and one colour, an orbit around it; prints one line of JSON."""
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import program_options  # noqa: E402

OPTIONS = program_options.arguments(__doc__)  # before the imports of what a machine may lack
import measured_frames  # noqa: E402
from paraview import simple  # noqa: E402


def main(options):
    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    view.ViewSize = [options.size, options.size]
    mesh = measured_frames.read_mesh(options.mesh)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(mesh)
    source.UpdatePipeline()
    window = view.GetRenderWindow()
    simple.Render(view)  # an empty image first, so that window and context exist when the clock starts
    view.CameraViewAngle = 30
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 1, 0]
    view.CameraPosition = measured_frames.place(0, 1, options.distance)

    def draw(position):
        view.CameraPosition = position
        simple.Render(view)
        window.WaitForCompletion()

    def draw_first():
        display = simple.Show(source, view)
        display.Representation = "Surface"
        display.ColorArrayName = [None, ""]  # one colour
        draw(view.CameraPosition)

    def renderer():
        return next((line.split(":", 1)[1].strip() for line in window.ReportCapabilities().splitlines() if "OpenGL renderer" in line), "")

    measured_frames.measure(options, mesh.GetNumberOfPolys(), draw_first, draw, renderer)
    if options.dump:
        draw(measured_frames.place(0, 1, options.distance))
        simple.SaveScreenshot(options.dump, view, ImageResolution=[options.size, options.size])


main(OPTIONS)
