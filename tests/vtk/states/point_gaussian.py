"""Point Gaussian: points as discs or ellipses, in the mapper's own look and in those of ParaView's presets."""
import looks
import shapes
from registry import state


def gaussians(stage, emissive=False):
    mapper = stage.vtk.vtkPointGaussianMapper()
    mapper.SetInputData(shapes.cloud(stage.vtk))
    mapper.SetScaleArray("radius")
    mapper.SetScalarRange(-1, 1)
    mapper.SetEmissive(emissive)
    return mapper


def gaussians_about_sphere(stage, mapper, change=lambda actor: None):
    change(stage.show(mapper))
    stage.show(shapes.sphere(stage.vtk, 32, 0.4), color=(0.3, 0.6, 0.9))
    stage.look()
    stage.orbit(3)


@state("vtk")
def gaussians_of_mapper(stage):
    """The mapper's own look: opacities fall off as a gaussian, blended in the order of drawing, with depth writes."""
    gaussians_about_sphere(stage, gaussians(stage))


@state("vtk", outside=False, reason="they add up and leave no depth")
def gaussians_emissive(stage):
    gaussians_about_sphere(stage, gaussians(stage, emissive=True))


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def gaussians_summed(stage):
    gaussians_about_sphere(stage, gaussians(stage), lambda actor: actor.GetProperty().SetOpacity(0.6))


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def gaussians_peeled(stage):
    looks.peel(stage)
    gaussians_about_sphere(stage, gaussians(stage), lambda actor: actor.GetProperty().SetOpacity(0.6))


@state("vtk")
def gaussians_multisampled(stage):
    """Blended in a multisampled framebuffer: the real OpenGL draws them."""
    stage.window.SetMultiSamples(4)
    gaussians_about_sphere(stage, gaussians(stage))


@state("vtk")
def round_shades_of_mapper(stage):
    """vtkPointGaussianMapper with the shader of ParaView's preset "Sphere"."""
    mapper = gaussians(stage)
    mapper.SetSplatShaderCode("""//VTK::Color::Impl
float dist = dot(offsetVCVSOutput.xy,offsetVCVSOutput.xy);
if (dist > 1.0) {
  discard;
} else {
  float scale = (1.0 - dist);
  ambientColor *= scale;
  diffuseColor *= scale;
}
""")
    stage.show(mapper)
    stage.show(shapes.sphere(stage.vtk, 32, 0.4), color=(0.3, 0.6, 0.9))
    stage.look()
    stage.orbit(3)


def points_of(stage, preset, **properties):
    stage.show(stage.simple.Sphere(ThetaResolution=20, PhiResolution=20), Representation="Point Gaussian", GaussianRadius=0.05,
               ShaderPreset=preset, **properties)
    stage.look()


@state("pvbatch")
def round_shades_colored(stage):
    stage.show(stage.simple.Wavelet(WholeExtent=[-3, 3] * 3), Representation="Point Gaussian", GaussianRadius=0.4,
               ShaderPreset="Sphere", color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def round_shades_parallel(stage):
    points_of(stage, "Sphere")
    stage.view.CameraParallelProjection = 1
    stage.look()
    stage.orbit(3)


@state("pvbatch", outside=False, reason="where discs cross, roundings decide")
def round_shades_near(stage):
    points_of(stage, "Sphere", DiffuseColor=[0.3, 0.7, 0.4])
    camera = stage.view.GetActiveCamera()
    camera.SetPosition(0.1, 0.2, 0.7)
    camera.SetFocalPoint(0, 0, 0)
    stage.view.GetRenderer().ResetCameraClippingRange()
    stage.orbit(3)


@state("pvbatch")
def round_shades_steady(stage):
    points_of(stage, "Sphere")
    stage.steady_orbit()


@state("pvbatch")
def gaussians_of_other_presets(stage):
    """"Gaussian Blur" is the mapper's own look. The others are impostors of unknown shape."""
    for preset in ("Gaussian Blur", "Black-edged circle", "Triangle", "Square Outline"):
        points_of(stage, preset)
        stage.shoot()
        stage.simple.Delete(stage.simple.GetActiveSource())
