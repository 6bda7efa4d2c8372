"""Impostors: sticks that shaders cut out of billboards, and molecules of spheres and sticks."""
import looks
import numpy as np
import shapes
from registry import state


def sticks(stage, radius=0.08):
    vtk, data = stage.vtk, shapes.cloud(stage.vtk, 5, 0.8)
    n = data.GetNumberOfPoints()
    ways = [(np.sin(i), np.cos(2.3 * i), np.sin(0.7 * i + 1)) for i in range(n)]
    ways[0] = (0, 0, 1)
    data.GetPointData().AddArray(shapes.array(ways, "way", np.float32))
    data.GetPointData().AddArray(shapes.array([(0.3 + 0.1 * (i % 4), radius, radius) for i in range(n)], "size", np.float32))
    data.GetPointData().AddArray(shapes.array(range(n), "number", np.uint8))
    mapper = vtk.vtkOpenGLStickMapper()
    mapper.SetInputData(data)
    mapper.SetOrientationArray("way")
    mapper.SetScaleArray("size")
    mapper.SetSelectionIdArray("number")
    mapper.SetScalarRange(-1, 1)
    return mapper


@state("vtk")
def sticks_colored(stage):
    stage.show(sticks(stage))
    stage.look()
    stage.orbit(3)


@state("vtk")
def sticks_parallel(stage):
    stage.show(sticks(stage))
    looks.orbit_in_parallel(stage)


@state("vtk")
def sticks_near(stage):
    stage.show(sticks(stage, 0.2))
    looks.from_among(stage, place=(0.4, 0.5, 1.2), clipping=(0.1, 8))


@state("vtk")
def sticks_turned(stage):
    actor = stage.show(sticks(stage))
    actor.RotateWXYZ(70, 1, 2, 3)
    actor.GetProperty().SetSpecular(0.5)
    stage.look()
    stage.orbit(3)


def molecule(stage, settings):
    vtk = stage.vtk
    made, mapper = vtk.vtkMolecule(), vtk.vtkMoleculeMapper()
    atoms = [made.AppendAtom(6 + i % 3, 1.3 * np.cos(i), 1.3 * np.sin(i), 0.35 * i) for i in range(20)]
    for a, b in zip(atoms, atoms[1:]):
        made.AppendBond(a, b, 1 + a.GetId() % 3)
    mapper.SetInputData(made)
    getattr(mapper, f"Use{settings}Settings")()
    return stage.show(mapper)


@state("vtk", outside=False, reason="translucent surfaces leave no depth")
def molecule_peeled(stage):
    looks.peel(stage)
    molecule(stage, "BallAndStick").GetProperty().SetOpacity(0.4)
    stage.show(shapes.sphere(stage.vtk, 48, 1.2), color=(0.3, 0.5, 0.9))
    stage.look()
    stage.orbit(3)


@state("vtk")
def molecule_ball_and_stick(stage):
    molecule(stage, "BallAndStick")
    stage.look()
    stage.orbit(3)


@state("vtk")
def molecule_liquorice(stage):
    molecule(stage, "LiquoriceStick")
    stage.look(zoom=1.5)
    stage.orbit(3)


@state("vtk")
def molecule_filling_space(stage):
    molecule(stage, "VDWSpheres")
    looks.orbit_in_parallel(stage)
