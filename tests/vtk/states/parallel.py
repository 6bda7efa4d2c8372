"""ParaView in several processes: images composited from those of all processes, or sent by a server."""
from registry import state

EVERYWHERE = ("mpi2", "mpi4", "remote")


def pieces(stage):
    """Surfaces distributed over the processes."""
    simple = stage.simple
    wavelet = simple.Wavelet(WholeExtent=[-8, 8] * 3)
    return simple.Contour(wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[120, 200])


@state(EVERYWHERE, same_depth=False)
def opaque(stage):
    stage.show(pieces(stage), color_by=("POINTS", ""))
    stage.show(stage.simple.Sphere(Center=[0, 9, 0], Radius=3, ThetaResolution=32, PhiResolution=32), DiffuseColor=[0.9, 0.5, 0.2])
    stage.look()
    stage.orbit(3)


@state(EVERYWHERE, same_depth=False)
def by_process(stage):
    stage.show(stage.simple.ProcessIdScalars(pieces(stage)), color_by=("POINTS", "ProcessId"))
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def scalars_and_overlays(stage):
    display = stage.show(stage.simple.Clip(stage.simple.Wavelet(WholeExtent=[-8, 8] * 3)), color_by=("POINTS", "RTData"))
    display.SetScalarBarVisibility(stage.view, True)
    stage.view.OrientationAxesVisibility = 1
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def axes_around(stage):
    stage.show(pieces(stage), color_by=("POINTS", ""))
    stage.view.AxesGrid.Visibility = 1
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def translucent(stage):
    stage.show(pieces(stage), color_by=("POINTS", ""), Opacity=0.5)
    stage.show(stage.simple.Box(XLength=6, YLength=6, ZLength=6), DiffuseColor=[0.9, 0.5, 0.2])
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def turned_translucent(stage):
    display = stage.show(pieces(stage), color_by=("POINTS", ""))
    stage.look()
    for opacity in (1, 0.4, 1):
        display.Opacity = opacity
        stage.shoot()


@state(EVERYWHERE, same_depth=False)
def volume_over_surface(stage):
    simple = stage.simple
    stage.show(simple.Wavelet(WholeExtent=[-8, 8] * 3), Representation="Volume", color_by=("POINTS", "RTData"))
    stage.show(simple.Sphere(Radius=4, ThetaResolution=32, PhiResolution=32))
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def edges_and_lines(stage):
    simple = stage.simple
    stage.show(simple.Sphere(Radius=4, ThetaResolution=24, PhiResolution=24), Representation="Surface With Edges")
    stage.show(simple.Wavelet(WholeExtent=[-5, 5] * 3), Representation="Outline")
    stage.look()
    stage.orbit()


@state(EVERYWHERE, same_depth=False)
def changed_geometry(stage):
    contour = pieces(stage)
    stage.show(contour, color_by=("POINTS", ""))
    stage.look()
    for value in (100, 160, 220):
        contour.Isosurfaces = [value]
        stage.shoot()
