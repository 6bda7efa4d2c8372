"""Lights: number, kinds, coordinate systems."""
import shapes
from registry import state


def ball(stage):
    stage.show(stage.simple.Superquadric(ThetaResolution=40, PhiResolution=40), Specular=0.5, SpecularPower=20)
    stage.look()


@state("pvbatch")
def head_light_only(stage):
    ball(stage)
    stage.view.UseLight = 0
    stage.simple.AddLight(view=stage.view)
    stage.orbit()


@state("pvbatch")
def no_lights(stage):
    ball(stage)
    stage.view.UseLight = 0
    stage.orbit()


@state("pvbatch")
def light_kit_changed(stage):
    """Intensity and warmth change between frames."""
    ball(stage)
    stage.shoot()
    stage.view.KeyLightIntensity = 1.1
    stage.view.KeyLightWarmth, stage.view.FillLightElevation = 0.9, 40
    stage.shoot()


def placed(stage, **properties):
    light = stage.simple.AddLight(view=stage.view)
    for name, value in properties.items():
        setattr(light, name, value)


@state("pvbatch")
def positional_light(stage):
    ball(stage)
    stage.view.UseLight = 0
    placed(stage, Coords="Scene", Type="Positional", Position=[0, 1.2, 1], FocalPoint=[0, 0, 0], DiffuseColor=[1, 0.9, 0.6])
    stage.orbit(3)


@state("pvbatch")
def spot_light(stage):
    ball(stage)
    stage.view.UseLight = 0
    placed(stage, Coords="Scene", Type="Positional", Position=[0, 0.3, 1.5], FocalPoint=[0, 0, 0], ConeAngle=20)
    stage.orbit(3)


@state("pvbatch")
def many_lights(stage):
    ball(stage)
    placed(stage, Coords="Scene", Type="Directional", Position=[1, 0, 0], FocalPoint=[0, 0, 0], DiffuseColor=[1, 0, 0])
    placed(stage, Coords="Camera", Type="Positional", Position=[-1, 0, 1], DiffuseColor=[0, 1, 0], Intensity=0.5)
    placed(stage, Coords="Ambient", Intensity=0.2)
    stage.orbit(3)


@state("vtk")
def attenuated_lights(stage):
    vtk = stage.vtk
    stage.show(shapes.grid(vtk, 40)).GetProperty().SetSpecular(0.6)
    stage.renderer.AutomaticLightCreationOff()
    for i in range(3):
        light = vtk.vtkLight()
        light.SetPositional(True)
        light.SetLightTypeToSceneLight()
        light.SetPosition(i - 1, 0, 0.8)
        light.SetFocalPoint(i - 1, 0.2, 0)
        light.SetConeAngle((180, 35, 50)[i])
        light.SetExponent((1, 4, 1)[i])
        light.SetAttenuationValues(0.3, 0.8, 0.5)
        light.SetDiffuseColor(i == 0, 0.5, i == 2)
        light.SetSpecularColor(1, 1, 1)
        stage.renderer.AddLight(light)
    stage.look()
    stage.orbit()


@state("vtk")
def light_added_between_frames(stage):
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    stage.look()
    stage.shoot()
    light = vtk.vtkLight()
    light.SetPosition(3, 4, 1)
    light.SetColor(0.2, 0.4, 1)
    stage.renderer.AddLight(light)
    stage.shoot()
    light.SwitchOff()
    stage.shoot()


@state("vtk")
def lighting_off(stage):
    actor = stage.show(shapes.sphere(stage.vtk, 32))
    actor.GetProperty().LightingOff()
    stage.show(shapes.sphere(stage.vtk, 32, 0.4), color=(0.3, 0.6, 0.9), at=(0.4, 0.3, 0.3))
    stage.look()
    stage.orbit()


@state("vtk")
def one_sided_lighting(stage):
    sphere = shapes.sphere(stage.vtk, 32)
    sphere.SetEndTheta(220)
    stage.show(sphere)
    stage.renderer.TwoSidedLightingOff()
    stage.look(elevation=-50)
    stage.orbit()


@state("vtk")
def ambient_light(stage):
    stage.show(shapes.sphere(stage.vtk, 32)).GetProperty().SetAmbient(0.5)
    stage.renderer.SetAmbient(0.4, 0.5, 0.6)
    stage.look()
    stage.orbit()
