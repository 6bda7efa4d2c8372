"""Volumes lit by other lights than VTK's own one at the viewer. volumes.py says how they are compared."""
from volume_shapes import field, gradient_opacity, image_of, show, volumes


def lit(stage, two_sided=True, weighted=False):
    """A lit volume that is looked at from two sides."""
    stage.renderer.SetTwoSidedLighting(two_sided)
    volume = show(stage, image_of(stage.vtk, field()), shade=True)
    look = volume.GetProperty()
    look.SetAmbient(0.2)
    look.SetDiffuse(0.7)
    look.SetSpecular(0.5)
    look.SetSpecularPower(12)
    if weighted:
        gradient_opacity(stage, volume)
    stage.look()
    stage.orbit()


def add_light(stage, position, color=(1, 1, 1), scene=True, **positional):
    light = stage.vtk.vtkLight()
    if scene:
        light.SetLightTypeToSceneLight()
    else:
        light.SetLightTypeToCameraLight()
    light.SetPosition(*position)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(*color)
    if positional:
        light.PositionalOn()
        light.SetConeAngle(positional.get("cone", 180))
        light.SetExponent(positional.get("exponent", 1))
        light.SetAttenuationValues(*positional.get("attenuation", (1, 0, 0)))
    stage.renderer.AddLight(light)
    return light


@volumes
def volume_lit_from_the_side(stage):
    add_light(stage, (3, 2, 1))
    lit(stage)


@volumes
def volume_lit_by_two_colors(stage):
    add_light(stage, (3, 2, 1), (1, 0.8, 0.5))
    add_light(stage, (-2, 1, 2), (0.2, 0.4, 1), scene=False)
    lit(stage, weighted=True)


@volumes
def volume_lit_on_one_side(stage):
    add_light(stage, (3, 2, 1))
    lit(stage, two_sided=False)


@volumes
def volume_lit_by_a_lamp(stage):
    add_light(stage, (1.5, 1, 1.5), attenuation=(0.2, 0.1, 0.3))
    lit(stage)


@volumes
def volume_lit_by_a_spot_and_the_sun(stage):
    add_light(stage, (2, 2, 2), (1, 0.5, 0.4), cone=25, exponent=3)
    add_light(stage, (-1, -2, 3), (0.3, 0.6, 0.5))
    lit(stage)


@volumes
def volume_lit_by_a_kit(stage):
    kit = stage.vtk.vtkLightKit()
    kit.AddLightsToRenderer(stage.renderer)
    lit(stage)


@volumes
def volume_light_moves(stage):
    light = add_light(stage, (3, 2, 1))
    lit(stage)
    light.SetPosition(-3, 1, 2)
    stage.shoot()
    light.SetSwitch(False)
    add_light(stage, (0, 4, 0), (0.9, 0.9, 0.3))
    stage.shoot()
