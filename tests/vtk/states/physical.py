"""Physically based materials with textures and normal maps, and light from images."""
import math

from registry import state


def image(vtk, color, width=64, height=64):
    """A vtkImageData whose pixel at (s, t), both 0 to 1, is color(s, t), three numbers from 0 to 1."""
    data = vtk.vtkImageData()
    data.SetDimensions(width, height, 1)
    data.AllocateScalars(vtk.VTK_UNSIGNED_CHAR, 3)
    for y in range(height):
        for x in range(width):
            for c, value in enumerate(color(x / width, y / height)):
                data.SetScalarComponentFromDouble(x, y, 0, c, round(255 * min(max(value, 0), 1)))
    return data


def texture(vtk, color, srgb=False, levels=False, **size):
    made = vtk.vtkTexture()
    made.SetInputData(image(vtk, color, **size))
    made.InterpolateOn()
    made.RepeatOn()
    made.SetUseSRGBColorSpace(srgb)
    made.SetMipmap(levels)
    return made


def waves(frequency, at):
    return 0.5 + 0.5 * math.sin(frequency * at)


def ball(stage, textures, levels=False):
    """A ball with texture coordinates and tangents, and a smaller one beside it, which hides a part of its sky; `textures`: some of base, orm,
    emission and normal."""
    vtk = stage.vtk
    sphere = vtk.vtkTexturedSphereSource()
    sphere.SetThetaResolution(40)
    sphere.SetPhiResolution(40)
    tangents = vtk.vtkPolyDataTangents()
    tangents.SetInputConnection(sphere.GetOutputPort())
    actor = stage.show(tangents, color=(0.9, 0.8, 0.7))
    look = actor.GetProperty()
    look.SetInterpolationToPBR()
    look.SetMetallic(0.6)
    look.SetRoughness(0.7)
    if "base" in textures:
        look.SetBaseColorTexture(texture(vtk, lambda s, t: (waves(20, s), waves(15, t), 0.5), True, levels))
    if "orm" in textures:
        look.SetORMTexture(texture(vtk, lambda s, t: (waves(10, s), 0.3 + 0.6 * t, s), False, levels))
    if "emission" in textures:
        look.SetEmissiveTexture(texture(vtk, lambda s, t: (0.3 * (waves(30, s) > 0.7), 0.1, 0), True, levels))
        look.SetEmissiveFactor(1, 0.8, 0.6)
    if "normal" in textures:
        bumps = lambda s, t: (0.5 + 0.15 * math.sin(25 * s), 0.5 + 0.15 * math.cos(25 * t), 0.95)  # noqa: E731
        look.SetNormalTexture(texture(vtk, bumps, False, levels))
        look.SetNormalScale(0.8)
    smaller = vtk.vtkActor()
    smaller.ShallowCopy(actor)
    smaller.SetScale(0.5)
    smaller.SetPosition(0.45, 0.3, 0.45)
    stage.renderer.AddActor(smaller)
    return actor


def light_by_image(stage, harmonics):
    """A sky with a sun. VTK computes its images on the GPU: few samples, small images."""
    vtk = stage.vtk

    def sky(s, t):
        sun = math.exp(-60 * ((s - 0.3) ** 2 + (t - 0.6) ** 2))
        return 0.2 + 0.8 * sun, t, 0.6

    environment = texture(vtk, sky, True, True, width=128, height=64)
    stage.renderer.UseImageBasedLightingOn()
    stage.renderer.SetEnvironmentTexture(environment)
    stage.renderer.SetUseSphericalHarmonics(harmonics)
    stage.renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(16)
    stage.renderer.GetEnvMapIrradiance().SetIrradianceStep(0.2)
    stage.renderer.GetEnvMapLookupTable().SetLUTSamples(64)


def shoot(stage):
    stage.look()
    stage.orbit()


@state("vtk")
def pbr_base_color(stage):
    ball(stage, ("base",))
    shoot(stage)


@state("vtk")
def pbr_textures(stage):
    ball(stage, ("base", "orm", "emission"))
    shoot(stage)


@state("vtk")
def pbr_normal_map(stage):
    ball(stage, ("normal",))
    shoot(stage)


@state("vtk")
def pbr_image_light(stage):
    ball(stage, ())
    light_by_image(stage, True)
    shoot(stage)


@state("vtk")
def pbr_irradiance(stage):
    ball(stage, ())
    light_by_image(stage, False)
    shoot(stage)


@state("vtk")
def pbr_everything(stage):
    ball(stage, ("base", "orm", "emission", "normal"))
    light_by_image(stage, True)
    shoot(stage)


@state("vtk")
def pbr_coat(stage):
    """Left to the real OpenGL."""
    look = ball(stage, ("base",)).GetProperty()
    look.SetCoatStrength(0.6)
    shoot(stage)
