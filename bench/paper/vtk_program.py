"""Run by Debian's Python with VTK: a mesh from a file, an orbit around it, nothing else; prints one line of JSON."""
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import program_options  # noqa: E402

OPTIONS = program_options.arguments(__doc__)  # before the imports of what a machine may lack
import measured_frames  # noqa: E402
import vtk  # noqa: E402


def main(options):
    mesh = measured_frames.read_mesh(options.mesh)
    mapper, actor, renderer, window = vtk.vtkPolyDataMapper(), vtk.vtkActor(), vtk.vtkRenderer(), vtk.vtkRenderWindow()
    mapper.SetInputData(mesh)
    actor.SetMapper(mapper)
    window.SetMultiSamples(0)
    window.SetSize(options.size, options.size)
    window.AddRenderer(renderer)
    window.Render()  # an empty image first, so that window and context exist when the clock starts
    camera = renderer.GetActiveCamera()
    camera.SetViewAngle(30)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 1, 0)

    def draw(position):
        camera.SetPosition(position)
        renderer.ResetCameraClippingRange()
        window.Render()
        window.WaitForCompletion()

    def draw_first():
        renderer.AddActor(actor)
        draw(measured_frames.place(0, 1, options.distance))

    def name():
        return next((line.split(":", 1)[1].strip() for line in window.ReportCapabilities().splitlines() if "OpenGL renderer" in line), "")

    measured_frames.measure(options, mesh.GetNumberOfPolys(), draw_first, draw, name)
    if options.dump:
        draw(measured_frames.place(0, 1, options.distance))
        image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
        image.SetInput(window)
        image.ReadFrontBufferOff()
        writer.SetInputConnection(image.GetOutputPort())
        writer.SetFileName(options.dump)
        writer.Write()


main(OPTIONS)
