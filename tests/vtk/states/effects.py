"""Passes over the whole image: anti-aliasing, ambient occlusion, hidden lines, depth of field."""
import shapes
from registry import state


def ball(stage, **properties):
    display = stage.show(stage.simple.Superquadric(ThetaResolution=32, PhiResolution=32), **properties)
    stage.look()
    return display


@state("pvbatch")
def fxaa_off(stage):
    stage.set(UseFXAA=0)
    ball(stage)
    stage.orbit()


@state("pvbatch")
def fxaa_on(stage):
    stage.set(UseFXAA=1)
    ball(stage)
    stage.orbit()


@state("pvbatch", same_depth=False)
def multisampled(stage):
    stage.view.MultiSamples = 4
    ball(stage)
    stage.orbit()


@state("vtk", same_depth=False)
def multisampled_vtk(stage):
    stage.window.SetMultiSamples(4)
    stage.show(shapes.sphere(stage.vtk, 32))
    stage.show(stage.vtk.vtkConeSource(), color=(0.3, 0.5, 0.9)).GetProperty().SetRepresentationToWireframe()
    stage.look()
    stage.orbit()


@state("vtk", same_depth=False)
def multisampled_surfaces(stage):
    """Nothing but traced surfaces: the pixels are made without the multisampled framebuffer."""
    stage.window.SetMultiSamples(4)
    stage.show(shapes.sphere(stage.vtk, 32))
    stage.show(stage.vtk.vtkConeSource(), color=(0.3, 0.5, 0.9), at=(0.6, 0.2, 0.3))
    stage.look()
    stage.orbit()


@state("pvbatch")
def ambient_occlusion(stage):
    simple = stage.simple
    stage.show(simple.Box(XLength=3, ZLength=3, YLength=0.1, Center=[0, -0.5, 0]))
    ball(stage)
    stage.view.UseAmbientOcclusion = 1
    stage.orbit()


@state("pvbatch")
def hidden_lines(stage):
    ball(stage, Representation="Wireframe")
    stage.view.HiddenLineRemoval = 1
    stage.orbit()


@state("pvbatch", outside=False)
def tone_mapped(stage):
    """Into a framebuffer of floats; the pass leaves no depth, so pixels outside all surfaces cannot be found."""
    ball(stage)
    stage.view.UseToneMapping = 1
    stage.orbit()


@state("pvbatch")
def environment(stage):
    ball(stage, Interpolation="PBR", Metallic=0.6, Roughness=0.3)
    stage.view.UseColorPaletteForBackground = 0
    stage.view.BackgroundColorMode = "Texture"
    stage.view.BackgroundTexture = stage.simple.CreateTexture(str(shapes.checkers(stage.folder / "around.png")))
    stage.view.UseEnvironmentLighting = 1
    stage.orbit()


def with_pass(stage, wrap):
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    stage.show(vtk.vtkCubeSource(), color=(0.3, 0.5, 0.9), at=(0.7, 0.3, -0.5))
    basic = vtk.vtkRenderStepsPass()
    stage.renderer.SetPass(wrap(vtk, basic))
    stage.look()
    stage.window.Render()  # some passes show nothing in their first frame
    stage.orbit()


@state("vtk")
def shadow_maps(stage):
    """Two lights with shadow maps."""
    vtk = stage.vtk
    stage.show(shapes.sphere(vtk, 32))
    stage.show(vtk.vtkCubeSource(), color=(0.3, 0.5, 0.9), at=(0, -1, 0)).SetScale(4, 0.2, 4)
    stage.renderer.AutomaticLightCreationOff()
    light = vtk.vtkLight()
    light.SetPositional(True)
    light.SetConeAngle(30)
    light.SetPosition(1, 4, 1)
    light.SetFocalPoint(0, 0, 0)
    stage.renderer.AddLight(light)
    shadows, sequence, passes, camera = vtk.vtkShadowMapPass(), vtk.vtkSequencePass(), vtk.vtkRenderPassCollection(), vtk.vtkCameraPass()
    passes.AddItem(shadows.GetShadowMapBakerPass())
    passes.AddItem(shadows)
    sequence.SetPasses(passes)
    camera.SetDelegatePass(sequence)
    stage.renderer.SetPass(camera)
    stage.look()
    stage.orbit()


def around(name):
    def wrap(vtk, basic):
        outer = getattr(vtk, name)()
        outer.SetDelegatePass(basic)
        return outer
    return wrap


@state("vtk")
def eye_dome_lighting(stage):
    with_pass(stage, around("vtkEDLShading"))


@state("vtk")
def blurred(stage):
    with_pass(stage, around("vtkGaussianBlurPass"))


@state("vtk")
def sobel_edges(stage):
    with_pass(stage, around("vtkSobelGradientMagnitudePass"))


@state("vtk")
def depth_of_field(stage):
    with_pass(stage, around("vtkDepthOfFieldPass"))


@state("vtk")
def fxaa_of_vtk(stage):
    stage.renderer.UseFXAAOn()
    stage.show(shapes.sphere(stage.vtk, 32))
    stage.look()
    stage.orbit()


@state("vtk")
def fxaa_of_two_views(stage):
    """Each view has a pass over its own part of the image."""
    stage.renderer.SetViewport(0, 0, 0.5, 0.7)
    beside = stage.new_renderer((0.5, 0.2, 1, 1))
    for renderer in (stage.renderer, beside):
        renderer.UseFXAAOn()
        stage.show(shapes.sphere(stage.vtk, 32), renderer=renderer)
    stage.look()
    beside.ResetCamera()
    stage.orbit()


@state("vtk")
def custom_shader(stage):
    """The program's own code inside VTK's shader, which no family knows."""
    actor = stage.show(shapes.sphere(stage.vtk, 32))
    actor.GetShaderProperty().AddFragmentShaderReplacement(
        "//VTK::Light::Impl", True, "//VTK::Light::Impl\n  fragOutput0.rgb = fract(vertexVC.xyz * 4.0);\n", False)
    stage.look()
    stage.orbit()


@state("vtk")
def displaced_by_shader(stage):
    """The vertex shader moves the vertices, so buffers do not hold the visible positions."""
    actor = stage.show(shapes.sphere(stage.vtk, 32))
    actor.GetShaderProperty().AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", True,
        "vec4 moved = vertexMC + vec4(0.2 * sin(vertexMC.y * 12.0), 0.0, 0.0, 0.0);\n"
        "  vertexVCVSOutput = MCVCMatrix * moved;\n  gl_Position = MCDCMatrix * moved;\n", False)
    stage.look()
    stage.orbit()


def replaced(stage, place, text, vertex=False, first=False):
    """A sphere whose shader has `text` after `place`; the text needs no new variable.

    `first`: put there before VTK's code, whose place it leaves in front of `text`.
    """
    shader = stage.show(shapes.sphere(stage.vtk, 32)).GetShaderProperty()
    add = shader.AddVertexShaderReplacement if vertex else shader.AddFragmentShaderReplacement
    add(place, first, f"{place}\n  {text}\n", False)
    stage.look()
    stage.orbit()


@state("vtk")
def colors_replaced_by_shader(stage):
    replaced(stage, "//VTK::Color::Impl", "diffuseColor = abs(normalize(vertexVC.xyz));", first=True)


@state("vtk")
def light_replaced_by_shader(stage):
    replaced(stage, "//VTK::Light::Impl", "fragOutput0.rgb = vec3(1.0, 0.0, 0.0);")


@state("vtk")
def half_replaced_by_shader(stage):
    replaced(stage, "//VTK::Light::Impl", "if (gl_FragCoord.x < 150.0) fragOutput0.rgb = fragOutput0.gbr * 0.5;")


@state("vtk")
def stripes_discarded_by_shader(stage):
    replaced(stage, "//VTK::Light::Impl", "if (mod(floor(gl_FragCoord.x / 8.0), 2.0) < 1.0) discard;")


@state("vtk")
def normals_turned_by_shader(stage):
    replaced(stage, "//VTK::Normal::Impl", "normalVCVSOutput = normalVCVSOutput.zxy;", vertex=True)


@state("vtk")
def program_of_lines_for_triangles(stage):
    """A surface and a wireframe with one mapper: in later frames VTK draws the surface with the lines' program."""
    source, clean = stage.vtk.vtkCubeSource(), stage.vtk.vtkPolyData()
    source.Update()
    clean.SetPoints(source.GetOutput().GetPoints())
    clean.SetPolys(source.GetOutput().GetPolys())
    mapper = stage.vtk.vtkPolyDataMapper()
    mapper.SetInputData(clean)
    for wireframe in (False, True):
        actor = stage.vtk.vtkActor()
        actor.SetMapper(mapper)
        if wireframe:
            actor.GetProperty().SetRepresentationToWireframe()
            actor.GetProperty().SetColor(0, 0, 0)
        stage.renderer.AddActor(actor)
    stage.look()
    stage.orbit()
