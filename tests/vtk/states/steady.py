"""Frames between which only the camera moves: no mesh and no acceleration structure is built."""
import shapes
from registry import state


@state("pvbatch")
def steady_solid(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=64, PhiResolution=64))
    stage.look()
    stage.steady_orbit()


@state("pvbatch")
def steady_point_scalars(stage):
    stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    stage.look()
    stage.steady_orbit()


@state("pvbatch")
def steady_cell_scalars(stage):
    stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("CELLS", "number"))
    stage.look()
    stage.steady_orbit()


@state("pvbatch", sends=30000)
def steady_with_overlays(stage):
    """Axes and text, which VTK rebuilds for each view."""
    display = stage.show(stage.data(shapes.grid(shapes.vtk_modules())), color_by=("POINTS", "bump"))
    display.SetScalarBarVisibility(stage.view, True)
    stage.view.OrientationAxesVisibility = 1
    stage.view.AxesGrid.Visibility = 1
    stage.look()
    stage.steady_orbit()


@state("pvbatch")
def steady_blocks(stage):
    simple = stage.simple
    simple.GroupDatasets(Input=[simple.Cone(Resolution=12), simple.Sphere(Center=[1, 0, 0], ThetaResolution=20, PhiResolution=20),
                                simple.Box(Center=[0, 1, 0])])
    stage.show(simple.GetActiveSource(), color_by=("FIELD", "vtkBlockColors"))
    stage.look()
    stage.steady_orbit()


@state("pvbatch", outside=False, reason="translucent surfaces leave no depth")
def steady_beside_translucent(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32), Opacity=0.5)
    stage.show(stage.simple.Cone(Resolution=20))
    stage.look()
    stage.steady_orbit()


@state("pvbatch")
def steady_from_level_of_detail(stage):
    """The user drags and rests in turn: both meshes (reduced and full) stay known."""
    stage.show(stage.simple.Sphere(ThetaResolution=120, PhiResolution=120))
    stage.view.LODThreshold = 0
    stage.look()
    still = [False]

    def render():
        still[0] = not still[0]
        (stage.view.SMProxy.StillRender if still[0] else stage.view.SMProxy.InteractiveRender)()

    stage.counted(render, lambda: stage.view.GetActiveCamera().Azimuth(11), frames=6)
    stage.shoot()


@state("vtk")
def steady_many_actors(stage):
    mapper = stage.mapper(stage.vtk.vtkCubeSource())
    for i in range(64):
        stage.show(mapper, color=(i % 4 / 3, i // 4 % 4 / 3, 0.5), at=(1.5 * (i % 4), 1.5 * (i // 4 % 4), 1.5 * (i // 16)))
    stage.look()
    stage.steady_orbit()


@state("vtk")
def steady_moving_actor(stage):
    """The actor moves, not the camera: only its matrix changes."""
    actor = stage.show(shapes.sphere(stage.vtk, 48))
    stage.show(stage.vtk.vtkConeSource(), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.counted(stage.window.Render, lambda: actor.AddPosition(0.05, 0, 0.02))
    stage.shoot()


@state("vtk")
def steady_changing_color(stage):
    actor = stage.show(shapes.sphere(stage.vtk, 48))
    stage.look()

    def paint():
        red, green, blue = actor.GetProperty().GetColor()
        actor.GetProperty().SetColor(green, blue, red)

    stage.counted(stage.window.Render, paint)
    stage.shoot()
