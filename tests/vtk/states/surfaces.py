"""Surfaces of one colour: interpolation, sides, culling, textures, physically based shading."""
import shapes
from registry import state


@state("pvbatch")
def solid(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def flat(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=16, PhiResolution=12), Interpolation="Flat")
    stage.look()
    stage.orbit()


@state("pvbatch")
def no_normals(stage):
    contour = stage.simple.Contour(stage.simple.Wavelet(WholeExtent=[-6, 6] * 3), ContourBy=["POINTS", "RTData"],
                                   Isosurfaces=[130, 200], ComputeNormals=0, ComputeScalars=0)
    stage.show(contour, color_by=("POINTS", ""))
    stage.look()
    stage.orbit()


@state("pvbatch")
def specular(stage):
    stage.show(stage.simple.Superquadric(ThetaResolution=40, PhiResolution=40), Specular=0.8, SpecularPower=30,
               Ambient=0.1, Diffuse=0.8, DiffuseColor=[0.7, 0.3, 0.2], SpecularColor=[0.5, 1, 0.5])
    stage.look()
    stage.orbit()


@state("pvbatch")
def ambient_only(stage):
    stage.show(stage.simple.Cone(Resolution=24), Ambient=1, Diffuse=0, AmbientColor=[0.2, 0.8, 0.4])
    stage.look()
    stage.orbit()


@state("pvbatch")
def open_both_sides(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32, EndTheta=220, EndPhi=150))
    stage.look(azimuth=40, elevation=-50)
    stage.orbit(3, 60)


@state("pvbatch")
def backface_color(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32, EndTheta=220), BackfaceRepresentation="Surface",
               BackfaceAmbientColor=[0.9, 0.1, 0.1], BackfaceDiffuseColor=[0.9, 0.1, 0.1])
    stage.look(azimuth=40, elevation=-50)
    stage.orbit(3, 60)


@state("pvbatch")
def cull_back(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32, EndTheta=220), BackfaceRepresentation="Cull Backface")
    stage.look(azimuth=40, elevation=-50)
    stage.orbit()


@state("pvbatch")
def cull_front(stage):
    stage.show(stage.simple.Sphere(ThetaResolution=32, PhiResolution=32), BackfaceRepresentation="Cull Frontface")
    stage.look()
    stage.orbit()


@state("pvbatch")
def texture(stage):
    simple = stage.simple
    sphere = simple.TextureMaptoSphere(simple.Sphere(ThetaResolution=32, PhiResolution=32), PreventSeam=0)
    from vtkmodules.vtkIOImage import vtkPNGReader  # cannot be imported where the states are only listed
    file = str(shapes.checkers(stage.folder / "checkers.png"))
    image, reader = simple.CreateTexture(file), vtkPNGReader()
    stage.show(sphere, Texture=image)
    reader.SetFileName(file)
    image.GetClientSideObject().SetInputConnection(reader.GetOutputPort())  # pvbatch 5.13 does not read it by itself
    stage.look()
    stage.orbit()


@state("vtk")
def texture_with_holes(stage):
    vtk = stage.vtk
    plane, image = vtk.vtkPlaneSource(), vtk.vtkTexture()
    image.SetInputData(shapes.dotted_image(vtk))
    stage.show(plane).SetTexture(image)
    stage.show(vtk.vtkSphereSource(), at=(0, 0, -0.6))
    stage.look()
    stage.orbit()


@state("vtk")
def texture_smooth_repeated(stage):
    vtk = stage.vtk
    plane, image = vtk.vtkPlaneSource(), vtk.vtkTexture()
    canvas = vtk.vtkImageCanvasSource2D()
    canvas.SetExtent(0, 15, 0, 15, 0, 0)
    canvas.SetNumberOfScalarComponents(3)
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetDrawColor(220, 200, 40)
    canvas.FillBox(0, 15, 0, 15)
    canvas.SetDrawColor(30, 60, 200)
    canvas.FillTriangle(0, 0, 12, 3, 4, 14)
    image.SetInputConnection(canvas.GetOutputPort())
    image.InterpolateOn()
    image.RepeatOn()
    scale = vtk.vtkTransformTextureCoords()
    scale.SetInputConnection(plane.GetOutputPort())
    scale.SetScale(3, 3, 1)
    stage.show(scale).SetTexture(image)
    stage.look(azimuth=50)
    stage.orbit()


@state("pvbatch")
def physically_based(stage):
    simple = stage.simple
    for i, (metallic, roughness) in enumerate([(0, 0.2), (0, 0.7), (1, 0.2), (1, 0.6)]):
        stage.show(simple.Sphere(Center=[1.2 * i, 0, 0], ThetaResolution=32, PhiResolution=32), Interpolation="PBR",
                   Metallic=metallic, Roughness=roughness, DiffuseColor=[0.9, 0.6, 0.2])
    stage.look()
    stage.orbit()


@state("pvbatch")
def multiblock(stage):
    simple = stage.simple
    simple.GroupDatasets(Input=[simple.Cone(Resolution=12), simple.Sphere(Center=[1, 0, 0], ThetaResolution=20, PhiResolution=20),
                                simple.Box(Center=[0, 1, 0], XLength=0.5), simple.Sphere(Center=[1, 1, 0])])
    stage.show(simple.GetActiveSource(), color_by=("FIELD", "vtkBlockColors"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def several_materials(stage):
    simple = stage.simple
    for i in range(6):
        stage.show(simple.Sphere(Center=[i % 3, i // 3, 0.2 * i], ThetaResolution=20, PhiResolution=20),
                   DiffuseColor=[0.15 * i, 1 - 0.15 * i, 0.5], Specular=0.2 * i, Position=[0, 0.1 * i, 0],
                   Orientation=[10 * i, 0, 0], Scale=[1, 1 + 0.2 * i, 1])
    stage.look()
    stage.orbit()


@state("vtk")
def strips_and_polygons(stage):
    vtk = stage.vtk
    stripper, sphere = vtk.vtkStripper(), shapes.sphere(vtk, 24)
    stripper.SetInputConnection(sphere.GetOutputPort())
    stage.show(stripper)
    stage.show(shapes.star(vtk), color=(0.4, 0.8, 0.5), at=(1.2, 0, 0))
    stage.show(vtk.vtkDiskSource(), color=(0.4, 0.4, 0.9), at=(0, 1.2, 0))
    stage.look()
    stage.orbit()


@state("vtk")
def thousand_small_actors(stage):
    vtk = stage.vtk
    mapper = stage.mapper(vtk.vtkCubeSource())
    for i in range(1000):
        actor = stage.show(mapper, color=(i % 10 / 9, i // 10 % 10 / 9, 0.5), at=(1.5 * (i % 10), 1.5 * (i // 10 % 10), 1.5 * (i // 100)))
        actor.RotateZ(i)
    stage.look()
    stage.orbit()


@state("vtk")
def textures_in_front(stage):
    """An open ball with a texture on front faces only."""
    vtk = stage.vtk
    stage.kept = vtk.vtkSphereSource()
    stage.kept.SetThetaResolution(32), stage.kept.SetPhiResolution(32), stage.kept.SetEndTheta(220)
    stage.places = vtk.vtkTextureMapToSphere()
    stage.places.SetInputConnection(stage.kept.GetOutputPort())
    stage.places.Update()
    canvas = vtk.vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar(), canvas.SetNumberOfScalarComponents(3), canvas.SetExtent(0, 15, 0, 15, 0, 0)
    for x in range(0, 16, 4):
        for y in range(0, 16, 4):
            canvas.SetDrawColor(40 + 14 * x, 250 - 12 * y, 255 if (x + y) % 8 else 60)
            canvas.FillBox(x, x + 3, y, y + 3)
    canvas.Update()
    texture = vtk.vtkTexture()
    texture.SetInputData(canvas.GetOutput())
    actor = stage.show(stage.places.GetOutput())
    actor.SetTexture(texture)
    actor.GetProperty().ShowTexturesOnBackfaceOff()
    stage.look()
    stage.orbit(4)
