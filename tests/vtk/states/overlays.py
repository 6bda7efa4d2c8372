"""Overlays and backgrounds: text, scalar bars, axes, backgrounds, layers of 2D shapes."""
import shapes
from registry import state


def ball(stage, **properties):
    display = stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32), **properties)
    stage.look()
    return display


@state("pvbatch")
def scalar_bar(stage):
    display = stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    display.SetScalarBarVisibility(stage.view, True)
    stage.look()
    stage.orbit()


@state("pvbatch")
def text(stage):
    simple = stage.simple
    ball(stage)
    simple.Show(simple.Text(Text="GLuRay\nsecond line"), stage.view, FontSize=30)
    stage.orbit()


@state("pvbatch")
def orientation_axes(stage):
    ball(stage)
    stage.view.OrientationAxesVisibility = 1
    stage.orbit(3)


@state("pvbatch")
def center_axes(stage):
    ball(stage)
    stage.view.CenterOfRotation = [0.4, 0.4, 0.3]
    stage.view.CenterAxesVisibility = 1
    stage.orbit()


@state("pvbatch")
def gradient_background(stage):
    ball(stage)
    stage.view.UseColorPaletteForBackground = 0
    stage.view.BackgroundColorMode = "Gradient"
    stage.view.Background, stage.view.Background2 = [0.1, 0.1, 0.5], [0.9, 0.8, 0.6]
    stage.orbit()


@state("pvbatch")
def textured_background(stage):
    ball(stage)
    stage.view.UseColorPaletteForBackground = 0
    stage.view.BackgroundColorMode = "Texture"
    stage.view.BackgroundTexture = stage.simple.CreateTexture(str(shapes.checkers(stage.folder / "background.png")))
    stage.orbit()


@state("pvbatch")
def axes_grid(stage):
    ball(stage)
    stage.view.AxesGrid.Visibility = 1
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def data_axes_grid(stage):
    ball(stage).DataAxesGrid.GridAxesVisibility = 1
    stage.look()
    stage.orbit()


@state("pvbatch")
def polar_axes(stage):
    ball(stage).PolarAxes.Visibility = 1
    stage.look()
    stage.orbit()


@state("pvbatch")
def ruler(stage):
    ball(stage)
    stage.show(stage.simple.Ruler(Point1=[-0.7, -0.7, 0], Point2=[0.7, 0.7, 0.3]))
    stage.orbit()


@state("vtk")
def flat_actors(stage):
    """Lines and polygons in window coordinates, in front of and behind the scene."""
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    for i, layer in enumerate(("SetDisplayLocationToForeground", "SetDisplayLocationToBackground")):
        source, mapper, actor = vtk.vtkRegularPolygonSource(), vtk.vtkPolyDataMapper2D(), vtk.vtkActor2D()
        source.SetRadius(60)
        source.SetNumberOfSides(5 + i)
        source.SetCenter(130 + 120 * i, 150, 0)
        mapper.SetInputConnection(source.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.2, 0.9, 0.3)
        actor.GetProperty().SetOpacity(0.6 + 0.4 * i)
        getattr(actor.GetProperty(), layer)()
        stage.renderer.AddActor2D(actor)
    stage.look()
    stage.orbit()


@state("vtk")
def cube_axes(stage):
    vtk = stage.vtk
    actor = stage.show(shapes.grid(vtk))
    axes = vtk.vtkCubeAxesActor()
    axes.SetBounds(actor.GetBounds())
    axes.SetCamera(stage.renderer.GetActiveCamera())
    axes.DrawXGridlinesOn()
    axes.DrawYGridlinesOn()
    stage.renderer.AddActor(axes)
    stage.look()
    stage.orbit()


@state("vtk")
def caption_and_corner_text(stage):
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    corner, caption, axes = vtk.vtkCornerAnnotation(), vtk.vtkCaptionActor2D(), vtk.vtkAxesActor()
    corner.SetText(0, "lower left")
    corner.SetText(3, "upper right")
    caption.SetCaption("a point")
    caption.SetAttachmentPoint(0.3, 0.3, 0.3)
    for prop in (corner, caption, axes):
        stage.renderer.AddViewProp(prop)
    stage.look()
    stage.orbit()


@state("vtk")
def picture_behind(stage):
    """An image actor in the scene, and a 2D mapper's image in front of it."""
    vtk = stage.vtk
    image = shapes.dotted_image(vtk)
    flat, actor, mapper = vtk.vtkImageActor(), vtk.vtkActor2D(), vtk.vtkImageMapper()
    flat.SetInputData(image)
    flat.SetPosition(-32, -32, -20)
    stage.show(shapes.sphere(vtk, 32, 20))
    stage.renderer.AddActor(flat)
    mapper.SetInputData(image)
    mapper.SetColorWindow(255)
    mapper.SetColorLevel(127)
    actor.SetMapper(mapper)
    actor.SetPosition(5, 5)
    stage.renderer.AddActor2D(actor)
    stage.look()
    stage.orbit()
