"""Pictures by VTK itself: its vertex-pulling mapper, glyphs, impostors, composite mappers."""
import math
import sys

import vtk

import scene_list

SIZE = 500, 400


def sphere(resolution=40):
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(resolution), source.SetPhiResolution(resolution)
    elevation = vtk.vtkElevationFilter()
    elevation.SetLowPoint(0, 0, -0.5), elevation.SetHighPoint(0, 0, 0.5)
    elevation.SetInputConnection(source.GetOutputPort())
    elevation.Update()
    return elevation.GetOutput()


def picture(file, *actors, change=None, samples=0):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.2, 0.3, 0.4)
    for actor in actors:
        renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    if change:
        change(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(20), renderer.GetActiveCamera().Elevation(25)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(file)
    writer.Write()


def peeling(renderer):
    renderer.UseDepthPeelingOn()
    renderer.GetRenderWindow().SetAlphaBitPlanes(1)


def shown(mapper, *, data=sphere, scalars=False, cells=False, change=lambda actor: None, samples=0, view=None):
    """A scene of one actor. `mapper`: the name of its class; `view`: a change of the renderer."""
    def draw(file):
        made = getattr(vtk, mapper)()
        mesh = data()
        if cells:
            convert = vtk.vtkPointDataToCellData()
            convert.SetInputData(mesh)
            convert.Update()
            mesh = convert.GetOutput()
            made.SetScalarModeToUseCellData()
        made.SetInputDataObject(mesh)
        made.SetScalarVisibility(scalars or cells)
        actor = vtk.vtkActor()
        actor.SetMapper(made)
        actor.GetProperty().SetColor(0.9, 0.6, 0.3)
        change(actor)
        picture(file, actor, change=view, samples=samples)
    return draw


def prop(method, *values):
    return lambda actor: getattr(actor.GetProperty(), method)(*values)


def props(**values):
    def change(actor):
        for name, value in values.items():
            getattr(actor.GetProperty(), f"Set{name}")(value)
    return change


def both(*changes):
    return lambda actor: [change(actor) for change in changes]


def quads():
    """A cylinder of quads, whose triangles have inner edges."""
    source = vtk.vtkCylinderSource()
    source.SetResolution(14), source.CappingOff()
    source.Update()
    return source.GetOutput()


def flat():
    mesh = sphere(20)
    plain = vtk.vtkPolyData()
    plain.SetPoints(mesh.GetPoints()), plain.SetPolys(mesh.GetPolys())
    return plain


def helix():
    """Three lines with scalars of points, of many segments."""
    points, lines, values = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkFloatArray()
    values.SetName("height")
    for strand in range(3):
        lines.InsertNextCell(25)
        for i in range(25):
            angle = i / 4 + 2 * strand
            lines.InsertCellPoint(points.InsertNextPoint((0.3 + 0.1 * strand) * math.cos(angle), (0.3 + 0.1 * strand) * math.sin(angle), i / 24 - 0.5))
            values.InsertNextValue(i / 24)
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points), mesh.SetLines(lines)
    mesh.GetPointData().SetScalars(values)
    return mesh


def spheres(actor):
    actor.GetProperty().SetRepresentationToPoints()
    actor.GetProperty().RenderPointsAsSpheresOn(), actor.GetProperty().SetPointSize(9)


def tubes(actor):
    actor.GetProperty().RenderLinesAsTubesOn(), actor.GetProperty().SetLineWidth(7)


def gaussians(*changes, look=None, solid=False):
    """vtkPointGaussianMapper: its own look, or that of a shader. `changes`: of the mapper and its actor."""
    def draw(file):
        mapper, elevation = vtk.vtkPointGaussianMapper(), sphere(14)
        mapper.SetInputData(elevation), mapper.SetScaleFactor(0.05), mapper.EmissiveOff(), mapper.SetSplatShaderCode(look)
        actor, ball = vtk.vtkActor(), vtk.vtkActor()
        actor.SetMapper(mapper)
        for change in changes:
            change(mapper, actor)
        ball.SetMapper(vtk.vtkPolyDataMapper())
        ball.GetMapper().SetInputData(elevation), ball.GetMapper().ScalarVisibilityOff(), ball.SetScale(0.9)
        picture(file, *([actor, ball] if solid else [actor]))
    return draw


def translucent(mapper, actor):
    actor.ForceTranslucentOn()


# What ParaView's preset "Sphere" and F3D give the mapper.
ROUND = """//VTK::Color::Impl
float dist = dot(offsetVCVSOutput.xy,offsetVCVSOutput.xy);
if (dist > 1.0) {
  discard;
} else {
  float scale = (1.0 - dist);
  ambientColor *= scale;
  diffuseColor *= scale;
}
"""


def cut(actor):
    plane = vtk.vtkPlane()
    plane.SetNormal(0.5, 0.2, 1)
    actor.GetMapper().AddClippingPlane(plane)


def glyphs(change=lambda actor: None):
    def draw(file):
        mapper = vtk.vtkGlyph3DMapper()
        cone = vtk.vtkConeSource()
        mapper.SetInputData(sphere(10)), mapper.SetSourceConnection(cone.GetOutputPort())
        mapper.SetScaleFactor(0.1), mapper.OrientOff()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        change(actor)
        picture(file, actor)
    return draw


PULLING = "vtkOpenGLLowMemoryPolyDataMapper"
SCENES = {
    "surface": shown("vtkPolyDataMapper"),
    "surface, scalars": shown("vtkPolyDataMapper", scalars=True),
    "pulled: smooth": shown(PULLING),
    "pulled: flat": shown(PULLING, data=flat),
    "pulled: flat shading": shown(PULLING, change=prop("SetInterpolationToFlat")),
    "pulled: scalars": shown(PULLING, scalars=True),
    "pulled: scalars of cells": shown(PULLING, cells=True),
    "pulled: edges": shown(PULLING, data=flat, change=prop("EdgeVisibilityOn")),
    "pulled: wireframe": shown(PULLING, data=flat, change=prop("SetRepresentationToWireframe")),
    "pulled: wireframe, scalars": shown(PULLING, scalars=True, change=prop("SetRepresentationToWireframe")),
    "pulled: wireframe, scalars of cells": shown(PULLING, cells=True, change=both(prop("SetRepresentationToWireframe"), props(LineWidth=2))),
    "pulled: wireframe of quads": shown(PULLING, data=quads, change=both(prop("SetRepresentationToWireframe"), props(LineWidth=3))),
    "pulled: wireframe, opacity": shown(PULLING, change=both(prop("SetRepresentationToWireframe"), props(Opacity=0.5))),
    "pulled: wireframe, opacity, peeled": shown(PULLING, change=both(prop("SetRepresentationToWireframe"), props(Opacity=0.5)), view=peeling),
    "pulled: points": shown(PULLING, data=flat, change=prop("SetRepresentationToPoints")),
    "pulled: points as spheres": shown(PULLING, data=flat, change=spheres),
    "pulled: points as spheres, scalars": shown(PULLING, scalars=True, change=spheres),
    "pulled: points as spheres, scalars of cells": shown(PULLING, cells=True, change=spheres),
    "pulled: points as spheres, opacity": shown(PULLING, data=flat, change=both(spheres, props(Opacity=0.5))),
    "pulled: points as spheres, opacity, peeled": shown(PULLING, data=flat, change=both(spheres, props(Opacity=0.5)), view=peeling),
    "pulled: points as spheres, 4 samples": shown(PULLING, data=flat, change=spheres, samples=4),
    "pulled: points as spheres, scalars, 8 samples": shown(PULLING, scalars=True, change=spheres, samples=8),
    "points as spheres, 4 samples": shown("vtkPolyDataMapper", data=flat, change=spheres, samples=4),
    "pulled: lines": shown(PULLING, data=helix, scalars=True, change=prop("SetLineWidth", 3)),
    "pulled: lines as tubes": shown(PULLING, data=helix, change=tubes),
    "pulled: lines as tubes, scalars": shown(PULLING, data=helix, scalars=True, change=tubes),
    "pulled: lines as tubes, scalars of cells": shown(PULLING, data=helix, cells=True, change=tubes),
    "pulled: lines as tubes, opacity": shown(PULLING, data=helix, change=both(tubes, props(Opacity=0.5))),
    "pulled: lines as tubes, opacity, peeled": shown(PULLING, data=helix, change=both(tubes, props(Opacity=0.5)), view=peeling),
    "pulled: opacity": shown(PULLING, change=prop("SetOpacity", 0.5)),
    "pulled: physically based": shown(PULLING, change=prop("SetInterpolationToPBR")),
    "pulled: opacity, peeled": shown(PULLING, change=prop("SetOpacity", 0.5), view=peeling),
    "pulled: clear coat": shown(PULLING, change=both(prop("SetInterpolationToPBR"), props(CoatStrength=0.8, CoatRoughness=0.2, Roughness=0.6))),
    "pulled: anisotropic, without tangents": shown(PULLING, change=both(prop("SetInterpolationToPBR"), props(Anisotropy=0.8, Roughness=0.4, Metallic=0.7))),
    "glyphs": glyphs(),
    "glyphs, cut": glyphs(cut),
    "glyphs, physically based": glyphs(prop("SetInterpolationToPBR")),
    "glyphs with edges": glyphs(prop("EdgeVisibilityOn")),
    "glyphs with edges, unlit": glyphs(lambda a: (a.GetProperty().EdgeVisibilityOn(), a.GetProperty().LightingOff())),
    "glyphs with edges, physically based": glyphs(lambda a: (a.GetProperty().EdgeVisibilityOn(), a.GetProperty().SetInterpolationToPBR())),
    "physically based": shown("vtkPolyDataMapper", change=prop("SetInterpolationToPBR")),
    "physically based, scalars": shown("vtkPolyDataMapper", scalars=True, change=prop("SetInterpolationToPBR")),
    "clear coat": shown("vtkPolyDataMapper", change=both(prop("SetInterpolationToPBR"), props(CoatStrength=0.8, CoatRoughness=0.2, Roughness=0.6))),
    "anisotropic, without tangents": shown("vtkPolyDataMapper", change=both(prop("SetInterpolationToPBR"), props(Anisotropy=0.8, Roughness=0.4, Metallic=0.7))),
    "points as spheres, opacity, peeled": shown("vtkPolyDataMapper", data=flat, change=both(spheres, props(Opacity=0.5)), view=peeling),
    "lines as tubes, opacity, peeled": shown("vtkPolyDataMapper", data=helix, change=both(tubes, props(Opacity=0.5)), view=peeling),
    "spheres of points": shown("vtkSphereMapper" if hasattr(vtk, "vtkSphereMapper") else "vtkOpenGLSphereMapper", change=lambda a: a.GetMapper().SetRadius(0.05)),
    "gaussians": gaussians(),
    "gaussians about a surface": gaussians(solid=True),
    "gaussians, one colour": gaussians(lambda mapper, actor: mapper.ScalarVisibilityOff(), solid=True),
    "gaussians, emissive": gaussians(lambda mapper, actor: mapper.EmissiveOn(), solid=True),
    "gaussians, translucent": gaussians(translucent, solid=True),
    "gaussians, translucent and emissive": gaussians(translucent, lambda mapper, actor: mapper.EmissiveOn(), solid=True),
    "gaussians as spheres": gaussians(look=ROUND, solid=True),
    "gaussians as spheres, translucent": gaussians(lambda mapper, actor: actor.GetProperty().SetOpacity(0.5), look=ROUND, solid=True),
    "flat shading": shown("vtkPolyDataMapper", change=prop("SetInterpolationToFlat")),
    "edges": shown("vtkPolyDataMapper", data=flat, change=prop("EdgeVisibilityOn")),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
