"""Windows: viewports, layers, stereo, images larger than the window, several windows at once, swaps."""
import shapes
from registry import state


def two_balls(stage):
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    stage.show(vtk.vtkCubeSource(), color=(0.3, 0.5, 0.9), at=(0.7, 0.3, -0.8))
    stage.look()


def stereo(stage, kind):
    stage.window.StereoCapableWindowOff()
    stage.window.StereoRenderOn()
    getattr(stage.window, f"SetStereoTypeTo{kind}")()
    two_balls(stage)
    stage.orbit()


@state("vtk", same_depth=False, outside=False)
def stereo_anaglyph(stage):
    stereo(stage, "Anaglyph")


@state("vtk", same_depth=False, outside=False)
def stereo_red_blue(stage):
    stereo(stage, "RedBlue")


@state("vtk", same_depth=False, outside=False)
def stereo_side_by_side(stage):
    stereo(stage, "SplitViewportHorizontal")


@state("vtk", same_depth=False, outside=False)
def stereo_interlaced(stage):
    stereo(stage, "Interlaced")


@state("vtk", same_depth=False, outside=False)
def stereo_right_eye(stage):
    stereo(stage, "Right")


@state("vtk")
def viewports(stage):
    vtk = stage.vtk
    stage.window.RemoveRenderer(stage.renderer)
    sphere = shapes.sphere(vtk, 24)
    for i in range(4):
        x, y = 0.5 * (i % 2), 0.5 * (i // 2)
        renderer = stage.new_renderer((x, y, x + 0.5, y + 0.5), (0.1 * i, 0.2, 0.4))
        actor = stage.show(sphere, color=(0.9, 0.3 * i, 0.3), renderer=renderer)
        actor.GetProperty().SetRepresentation(2 - (i == 3))
        stage.look(azimuth=30 * i, renderer=renderer)
    stage.orbit()


@state("vtk")
def viewports_overlap(stage):
    vtk = stage.vtk
    two_balls(stage)
    renderer = stage.new_renderer((0.55, 0.5, 0.95, 0.95), (0.5, 0.2, 0.2))
    stage.show(vtk.vtkConeSource(), renderer=renderer)
    stage.look(renderer=renderer)
    stage.orbit()


@state("vtk", same_depth=False, outside=False)
def layers(stage):
    """A second scene over the first, whose colours are kept and whose depth is cleared."""
    vtk = stage.vtk
    two_balls(stage)
    upper = stage.new_renderer(layer=1)
    stage.show(vtk.vtkConeSource(), color=(0.2, 0.9, 0.3), renderer=upper)
    stage.look(azimuth=100, zoom=0.5, renderer=upper)
    stage.orbit(3)


@state("vtk")
def layers_that_keep_depth(stage):
    vtk = stage.vtk
    two_balls(stage)
    upper = stage.new_renderer(layer=1)
    upper.PreserveDepthBufferOn()
    upper.SetActiveCamera(stage.renderer.GetActiveCamera())
    stage.show(vtk.vtkConeSource(), color=(0.2, 0.9, 0.3), renderer=upper)
    stage.orbit(3)


@state("vtk", same_depth=False, outside=False)
def layers_that_keep_colors(stage):
    vtk = stage.vtk
    two_balls(stage)
    second = stage.new_renderer()
    second.PreserveColorBufferOn()
    stage.show(vtk.vtkConeSource(), color=(0.2, 0.9, 0.3), renderer=second)
    stage.look(renderer=second)
    stage.orbit()


@state("vtk")
def orientation_widget(stage):
    vtk = stage.vtk
    two_balls(stage)
    interactor, widget, axes = vtk.vtkRenderWindowInteractor(), vtk.vtkOrientationMarkerWidget(), vtk.vtkAxesActor()
    interactor.SetRenderWindow(stage.window)
    interactor.Initialize()
    widget.SetOrientationMarker(axes)
    widget.SetInteractor(interactor)
    widget.SetEnabled(1)
    stage.orbit()
    widget.SetEnabled(0)


def image_of(stage, image):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    width, height, _ = image.GetDimensions()
    colors = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    stage.keep(colors[::-1, :, :3].copy())


@state("vtk")
def picture_in_tiles(stage):
    """Three times the window's size, tile by tile."""
    two_balls(stage)
    taker = stage.vtk.vtkWindowToImageFilter()
    taker.SetInput(stage.window)
    taker.SetScale(3)
    taker.Update()
    image_of(stage, taker.GetOutput())


@state("vtk")
def picture_from_front_buffer(stage):
    two_balls(stage)
    for front in (True, False):
        taker = stage.vtk.vtkWindowToImageFilter()
        taker.SetInput(stage.window)
        taker.SetReadFrontBuffer(front)
        taker.SetShouldRerender(True)
        taker.Update()
        image_of(stage, taker.GetOutput())


@state("vtk")
def depth_picture(stage):
    """The depth buffer as programs export it."""
    two_balls(stage)
    taker, scale = stage.vtk.vtkWindowToImageFilter(), stage.vtk.vtkImageShiftScale()
    taker.SetInput(stage.window)
    taker.SetInputBufferTypeToZBuffer()
    scale.SetInputConnection(taker.GetOutputPort())
    scale.SetScale(255)
    scale.SetOutputScalarTypeToUnsignedChar()
    scale.Update()
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    image = scale.GetOutput()
    width, height, _ = image.GetDimensions()
    grey = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width)[::-1]
    stage.keep(np.repeat(grey[:, :, None], 3, axis=2))


@state("pvbatch")
def screenshot_larger_than_window(stage):
    """SaveScreenshot renders again, in tiles if the window is too small."""
    stage.show(stage.simple.Superquadric(ThetaResolution=40, PhiResolution=40))
    stage.view.OrientationAxesVisibility = 1
    stage.look()
    stage.simple.Render(stage.view)
    from vtkmodules.vtkIOImage import vtkPNGReader
    for i, size in enumerate(([400, 300], [1100, 900])):
        reader = vtkPNGReader()
        reader.SetFileName(str(stage.folder / f"{stage.name}.shot{i}.png"))
        stage.simple.SaveScreenshot(reader.GetFileName(), stage.view, ImageResolution=size)
        reader.Update()
        image_of(stage, reader.GetOutput())


@state("pvbatch")
def two_views(stage):
    simple = stage.simple
    sphere = simple.Sphere(ThetaResolution=32, PhiResolution=32)
    other = stage.new_view(ViewSize=[260, 200])
    stage.show(sphere)
    stage.show(sphere, view=other, Representation="Wireframe")
    stage.look()
    stage.look(azimuth=80, view=other)
    for _ in range(2):
        stage.shoot()
        stage.shoot(other)
        stage.view.GetActiveCamera().Azimuth(20)


@state("pvbatch")
def view_made_again(stage):
    """The window goes away and another takes its place: names of objects are used again."""
    sphere = stage.simple.Sphere(ThetaResolution=32, PhiResolution=32)
    stage.show(sphere)
    stage.look()
    stage.shoot()
    stage.simple.Delete(stage.views.pop())
    stage.view = stage.new_view()
    stage.show(sphere, DiffuseColor=[0.3, 0.8, 0.4])
    stage.look(azimuth=60)
    stage.orbit()


@state("pvbatch")
def stereo_of_paraview(stage):
    stage.show(stage.simple.Superquadric(ThetaResolution=40, PhiResolution=40))
    stage.look()
    stage.view.StereoType = "Red-Blue"
    stage.view.StereoRender = 1
    stage.shoot()
    stage.view.StereoRender = 0
    stage.shoot()


@state("vtk")
def two_windows(stage):
    vtk = stage.vtk
    two_balls(stage)
    other, renderer = vtk.vtkRenderWindow(), vtk.vtkRenderer()
    other.SetMultiSamples(0)
    other.SetSize(250, 180)
    other.AddRenderer(renderer)
    stage.show(vtk.vtkConeSource(), renderer=renderer)
    stage.look(renderer=renderer)
    for _ in range(2):
        stage.shoot()
        other.Render()
        stage.read(other)
        stage.renderer.GetActiveCamera().Azimuth(30)
    other.Finalize()
    stage.shoot()


@state("vtk")
def off_screen(stage):
    stage.window.SetOffScreenRendering(1)
    two_balls(stage)
    stage.orbit()


@state("vtk")
def resized(stage):
    two_balls(stage)
    for size in ((400, 300), (300, 420), (400, 300)):
        stage.window.SetSize(*size)
        stage.shoot()
