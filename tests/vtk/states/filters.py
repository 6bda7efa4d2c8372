"""Typical data: contours, slices, clipped and threshold grids, unstructured cells, threads of data through filters."""
import shapes
from registry import state


def wavelet(stage, size=8):
    return stage.simple.Wavelet(WholeExtent=[-size, size] * 3)


@state("pvbatch")
def contour(stage):
    stage.show(stage.simple.Contour(wavelet(stage), ContourBy=["POINTS", "RTData"], Isosurfaces=[120, 170, 220]))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def slice(stage):
    made = stage.simple.Slice(wavelet(stage))
    made.SliceType.Normal = [0.4, 0.3, 1]
    stage.show(made, color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def clip(stage):
    made = stage.simple.Clip(wavelet(stage))
    made.ClipType.Normal = [0.7, 0.3, 0.4]
    stage.show(made, color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit(3)


@state("pvbatch")
def threshold(stage):
    made = stage.simple.Threshold(wavelet(stage), Scalars=["POINTS", "RTData"], LowerThreshold=120, UpperThreshold=180)
    stage.show(made, color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def image_slice(stage):
    stage.show(wavelet(stage), Representation="Slice", color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def image_surface(stage):
    stage.show(wavelet(stage), Representation="Surface", color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def warped(stage):
    plane = stage.simple.Elevation(stage.simple.Plane(XResolution=20, YResolution=20))
    made = stage.simple.WarpByScalar(stage.simple.Calculator(plane, ResultArrayName="up", Function="0.2*sin(9*coordsX)*cos(7*coordsY)"),
                                     Scalars=["POINTS", "up"])
    stage.show(made, color_by=("POINTS", "up"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def tetrahedra_shrunk(stage):
    stage.show(stage.simple.Shrink(stage.simple.Tetrahedralize(wavelet(stage, 3))), color_by=("POINTS", "RTData"))
    stage.look()
    stage.orbit()


@state("pvbatch")
def hexahedra(stage):
    stage.show(stage.simple.UnstructuredCellTypes(CellType="Hex", BlocksDimensions=[3, 3, 3]))
    stage.look()
    stage.orbit()


@state("pvbatch")
def curved_cells(stage):
    stage.show(stage.simple.UnstructuredCellTypes(CellType="Quadratic Hex", BlocksDimensions=[2, 2, 2]),
               NonlinearSubdivisionLevel=2)
    stage.look()
    stage.orbit()


@state("pvbatch")
def hyper_tree_grid(stage):
    stage.show(stage.simple.HyperTreeGridRandom())
    stage.look()
    stage.orbit()


@state("pvbatch", outside=False)
def blocks_with_own_opacity(stage):
    simple = stage.simple
    group = simple.GroupDatasets(Input=[simple.Sphere(ThetaResolution=24, PhiResolution=24), simple.Cone(Center=[1, 0, 0], Resolution=20)],
                                 BlockNames=["ball", "cone"])
    display = stage.show(group, color_by=("POINTS", ""))
    display.BlockOpacities = ["/Root/cone", "0.4"]
    display.BlockColors = ["/Root/cone", "1.0", "0.2", "0.2"]
    stage.look()
    stage.orbit()


@state("pvbatch")
def many_triangles(stage):
    """0.1 million triangles: more than one for each pixel."""
    stage.show(stage.simple.Sphere(ThetaResolution=256, PhiResolution=256))
    stage.look()
    stage.orbit(3)


@state("vtk")
def polygons_of_many_corners(stage):
    vtk = stage.vtk
    for corners in (3, 5, 9, 20):
        stage.show(shapes.star(vtk, corners), color=(0.05 * corners, 0.8, 0.4), at=(0.1 * corners, 0, 0.05 * corners))
    stage.look()
    stage.orbit()
