"""Translucent surfaces that VTK blends in the order of drawing: where a render pass in place of the renderer's own draws them
(vtkTranslucentPass without a peeling pass), and where an actor says that it is opaque."""
import impostors
import shapes
from registry import state


def blend(stage, change=None, ordered=False):
    """Two translucent balls around a cube. `change`: what each ball's actor gets."""
    vtk = stage.vtk
    stage.show(vtk.vtkCubeSource(), color=(0.9, 0.8, 0.1))
    for radius, color in ((0.9, (1, 0.2, 0.2)), (1.1, (0.2, 0.9, 0.3))):
        source = shapes.sphere(vtk, 24, radius)
        if ordered:
            sorter = vtk.vtkDepthSortPolyData()
            sorter.SetInputConnection(source.GetOutputPort())
            sorter.SetCamera(stage.renderer.GetActiveCamera())
            sorter.SetDirectionToBackToFront()
            source = sorter
        actor = stage.show(source, color=color)
        actor.GetProperty().SetOpacity(0.4)
        if change:
            change(actor)
    use_passes(stage)
    stage.look()
    stage.orbit()


def use_passes(stage):
    vtk = stage.vtk
    sequence, passes, camera = vtk.vtkSequencePass(), vtk.vtkRenderPassCollection(), vtk.vtkCameraPass()
    for made in (vtk.vtkLightsPass(), vtk.vtkOpaquePass(), vtk.vtkTranslucentPass()):
        passes.AddItem(made)
    sequence.SetPasses(passes)
    camera.SetDelegatePass(sequence)
    stage.renderer.SetPass(camera)


@state("vtk", outside=False)
def blended(stage):
    blend(stage)


@state("vtk", outside=False)
def blended_back_to_front(stage):
    blend(stage, ordered=True)


@state("vtk", outside=False)
def blended_unlit(stage):
    blend(stage, lambda actor: actor.GetProperty().LightingOff())


@state("vtk", outside=False)
def blended_physical(stage):
    blend(stage, lambda actor: actor.GetProperty().SetInterpolationToPBR())


@state("vtk", outside=False)
def blended_culled(stage):
    blend(stage, lambda actor: actor.GetProperty().BackfaceCullingOn())


@state("vtk", outside=False)
def blended_spheres(stage):
    stage.show(impostors.spheres(stage, 0.25)).GetProperty().SetOpacity(0.5)
    blend(stage)


@state("vtk", outside=False)
def blended_colors(stage):
    """A colour map with an alpha."""
    vtk, data = stage.vtk, shapes.grid(stage.vtk)
    data.GetPointData().SetActiveScalars("bump")
    table = vtk.vtkLookupTable()
    table.SetAlphaRange(0.1, 0.9)
    table.SetTableRange(-1, 1)
    table.Build()
    actor = stage.show(data)
    actor.GetMapper().SetLookupTable(table)
    actor.GetMapper().UseLookupTableScalarRangeOn()
    blend(stage)


@state("vtk", outside=False)
def blended_edges(stage):
    """Left to the real OpenGL."""
    blend(stage, lambda actor: actor.GetProperty().EdgeVisibilityOn())
