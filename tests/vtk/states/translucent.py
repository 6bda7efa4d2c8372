"""Translucent surfaces: depth peeling, order-independent transparency, sorted blending, volumes.

Translucent surfaces leave no depth: where they are anti-aliased is not told from where there is nothing (outside=False).
"""
import numpy as np
import shapes
from registry import state


def three_shells(stage, **properties):
    simple = stage.simple
    stage.show(simple.Box(XLength=0.6, YLength=0.6, ZLength=0.6), DiffuseColor=[0.9, 0.8, 0.1])
    for radius, color in ((0.7, [1, 0.2, 0.2]), (0.9, [0.2, 0.9, 0.3])):
        stage.show(simple.Sphere(Radius=radius, ThetaResolution=24, PhiResolution=24), Opacity=0.4, DiffuseColor=color, **properties)
    stage.look()


@state("pvbatch", outside=False)
def peeled(stage):
    stage.set(DepthPeeling=1, MaximumNumberOfPeels=4)
    three_shells(stage)
    stage.orbit()


@state("pvbatch", outside=False)
def peeled_scalars(stage):
    stage.set(DepthPeeling=1, MaximumNumberOfPeels=4)
    vtk = shapes.vtk_modules()
    stage.show(stage.data(shapes.grid(vtk)), color_by=("POINTS", "bump"), Opacity=0.5)
    stage.show(stage.simple.Sphere(Radius=0.4, ThetaResolution=24, PhiResolution=24))
    stage.look()
    stage.orbit()


def six_balls(stage, peels, ratio=0):
    """One image of twelve layers, with a limit on peels or a minimum share of pixels for a peel (occlusion ratio)."""
    for i in range(6):
        stage.show(shapes.sphere(stage.vtk, 16, 0.5), at=(0.1 * i, 0, i), color=(i % 2, i / 6, 1 - i / 6)).GetProperty().SetOpacity(0.2)
    stage.window.SetAlphaBitPlanes(True)
    stage.renderer.UseDepthPeelingOn()
    stage.renderer.SetMaximumNumberOfPeels(peels)
    stage.renderer.SetOcclusionRatio(ratio)
    stage.look()
    stage.shoot()


@state("vtk", outside=False)
def first_picture_of_six_balls(stage):
    six_balls(stage, 20)


@state("vtk", outside=False)
def six_balls_in_few_peels(stage):
    six_balls(stage, 1)


@state("vtk", outside=False)
def six_balls_by_occlusion_ratio(stage):
    six_balls(stage, 20, 0.1)


@state("pvbatch", outside=False)
def order_independent(stage):
    stage.set(DepthPeeling=0)
    three_shells(stage)
    stage.orbit()


@state("pvbatch", outside=False)
def order_independent_scalars(stage):
    """Point and cell colours; lines and labels among the summed surfaces."""
    stage.set(DepthPeeling=0)
    vtk = shapes.vtk_modules()
    stage.show(stage.data(shapes.grid(vtk)), color_by=("POINTS", "bump"), Opacity=0.5)
    stage.show(stage.simple.Sphere(Radius=0.4, ThetaResolution=24, PhiResolution=24))
    stage.show(stage.simple.Sphere(Radius=0.6, ThetaResolution=12, PhiResolution=12), Representation="Wireframe", Opacity=0.6)
    stage.show(stage.simple.Sphere(Radius=0.5), Opacity=0.3, Interpolation="PBR", Roughness=0.4, Metallic=0.3)
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False)
def order_independent_glyphs(stage):
    stage.set(DepthPeeling=0)
    simple = stage.simple
    stage.show(simple.Sphere(ThetaResolution=16, PhiResolution=12), Representation="3D Glyphs", GlyphType="Cone", Opacity=0.5,
               Scaling=1, ScaleFactor=0.3, Orient=1, SelectOrientationVectors="Normals")
    for _ in range(2):  # at one place
        stage.show(simple.Sphere(Radius=0.45, ThetaResolution=24, PhiResolution=24), Opacity=0.3, DiffuseColor=[0.2, 0.9, 0.3])
    stage.show(simple.Box(XLength=0.4, YLength=0.4, ZLength=0.4))
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False)
def opaque_becomes_translucent(stage):
    """The opacity of the same representation between frames."""
    display = stage.show(stage.simple.Sphere(ThetaResolution=24, PhiResolution=24))
    stage.show(stage.simple.Cone(Resolution=20), DiffuseColor=[0.2, 0.4, 0.9])
    stage.look()
    for opacity in (1, 0.5, 1):
        display.Opacity = opacity
        stage.shoot()


@state("pvbatch", outside=False)
def opacity_from_color_map(stage):
    display = stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    display.LookupTable.EnableOpacityMapping = 1
    stage.show(stage.simple.Sphere(Radius=0.4, ThetaResolution=24, PhiResolution=24))
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False)
def opacity_from_array(stage):
    data = shapes.grid(shapes.vtk_modules())
    data.GetPointData().AddArray(shapes.array(np.linspace(0, 1, data.GetNumberOfPoints()), "veil"))
    stage.show(stage.data(data), OpacityByArray=1, OpacityArray=["POINTS", "veil"])
    stage.show(stage.simple.Sphere(Radius=0.4, ThetaResolution=24, PhiResolution=24))
    stage.look()
    stage.orbit()


@state("vtk")
def blended_in_order(stage):
    """No peeling: translucent actors are blended in the order of drawing."""
    vtk = stage.vtk
    stage.show(vtk.vtkCubeSource(), color=(0.9, 0.8, 0.1))
    for radius, color in ((0.9, (1, 0.2, 0.2)), (1.1, (0.2, 0.9, 0.3))):
        stage.show(shapes.sphere(vtk, 24, radius), color=color).GetProperty().SetOpacity(0.4)
    stage.renderer.UseDepthPeelingOff()
    stage.look()
    stage.orbit()


@state("vtk", outside=False)
def rgba_at_points(stage):
    data = shapes.grid(stage.vtk)
    n = data.GetNumberOfPoints()
    rgba = np.stack([np.arange(n) * k % 256 for k in (1, 3, 7)] + [np.where(np.arange(n) % 48 < 24, 255, 90)], 1)
    data.GetPointData().SetScalars(shapes.array(rgba, "rgba", np.uint8))
    stage.show(data)
    stage.show(shapes.sphere(stage.vtk, 24, 0.4))
    stage.renderer.UseDepthPeelingOn()
    stage.look()
    stage.orbit()


@state("vtk")
def forced_opaque(stage):
    """Colours with an alpha, on an actor that says it is opaque."""
    data = shapes.grid(stage.vtk)
    n = data.GetNumberOfPoints()
    rgba = np.stack([np.arange(n) * k % 256 for k in (1, 3, 7)] + [np.where(np.arange(n) % 48 < 24, 255, 90)], 1)
    data.GetPointData().SetScalars(shapes.array(rgba, "rgba", np.uint8))
    stage.show(data).ForceOpaqueOn()
    stage.show(shapes.sphere(stage.vtk, 24, 0.4))
    stage.look()
    stage.orbit()


@state("vtk")
def translucent_property_forced_opaque(stage):
    stage.show(shapes.sphere(stage.vtk, 24)).GetProperty().SetOpacity(0.4)
    stage.renderer.GetActors().GetLastActor().ForceOpaqueOn()
    stage.show(stage.vtk.vtkConeSource(), color=(0.3, 0.4, 0.9))
    stage.look()
    stage.orbit()


def wavelet(stage):
    return stage.simple.Wavelet(WholeExtent=[-8, 8] * 3)


@state("pvbatch")
def volume(stage):
    stage.show(wavelet(stage), Representation="Volume", color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def volume_and_surface(stage):
    source = wavelet(stage)
    stage.show(source, Representation="Volume", color_by=("POINTS", "RTData"))
    stage.show(stage.simple.Contour(source, ContourBy=["POINTS", "RTData"], Isosurfaces=[180]), color_by=("POINTS", ""))
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False, close=True)
def volume_cropped(stage):
    display = stage.show(wavelet(stage), Representation="Volume", color_by=("POINTS", "RTData"))
    display.Shade = 1
    display.UseCropping = 1
    display.CroppingOrigin, display.CroppingScale = [1, 1, 1], [0.6, 0.6, 0.6]
    stage.show(stage.simple.Sphere(Radius=3, ThetaResolution=24, PhiResolution=24))
    stage.look()
    stage.orbit()


@state("vtk")
def textured_labels(stage):
    """Text in the scene: textured rectangles with an alpha."""
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 24))
    for i in range(4):
        text, mapper, actor = vtk.vtkVectorText(), vtk.vtkTextActor3D(), vtk.vtkFollower()
        text.SetText(f"label {i}")
        mapper.SetInput(f"flat {i}")
        mapper.SetPosition(-0.8, 0.3 * i - 0.6, 0.3)
        mapper.SetScale(0.01)
        stage.renderer.AddActor(mapper)
        actor.SetMapper(stage.mapper(text))
        actor.SetScale(0.1)
        actor.SetPosition(0.5, 0.3 * i - 0.5, 0.2)
        actor.SetCamera(stage.renderer.GetActiveCamera())
        stage.renderer.AddActor(actor)
    stage.look()
    stage.orbit()
