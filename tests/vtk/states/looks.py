"""Cameras and lights that several states share."""


def orbit_in_parallel(stage):
    stage.renderer.GetActiveCamera().ParallelProjectionOn()
    stage.look()
    stage.orbit(3)


def from_among(stage, place, clipping):
    """The viewer stands among the impostors and turns."""
    stage.look()
    camera = stage.renderer.GetActiveCamera()
    camera.SetPosition(*place)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetClippingRange(*clipping)
    for degrees in (0, 40, 160):
        camera.Azimuth(degrees)
        stage.shoot()


def light_by_lamps(stage):
    """A positional light without and one with a cone, in place of VTK's headlight."""
    stage.renderer.AutomaticLightCreationOff()
    for place, cone, color in (((2, 1, 2), 180, (1, 0.8, 0.6)), ((-1, 2, 2), 40, (0.4, 0.7, 1))):
        light = stage.vtk.vtkLight()
        light.SetPosition(*place)
        light.SetFocalPoint(0, 0, 0)
        light.SetPositional(True)
        light.SetConeAngle(cone)
        light.SetColor(*color)
        light.SetLightTypeToSceneLight()
        stage.renderer.AddLight(light)


def shoot_and_pick(stage):
    """An image, a selection by two points and an area, and another image."""
    stage.look()
    stage.shoot()
    stage.keep_selected((200, 150), (230, 120), (10, 10))
    stage.shoot()


def peel(stage):
    stage.renderer.SetUseDepthPeeling(True)
    stage.renderer.SetMaximumNumberOfPeels(16)
    stage.window.SetAlphaBitPlanes(True)
