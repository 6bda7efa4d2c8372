"""Exports sample scenes as glTF, OBJ and PLY, reads the files with VTK, and compares them with each other and with what GLuRay
shows of the scenes.

    read_back.py --samples PROGRAM --out FOLDER

PROGRAM is gluray-export-samples. Compared are numbers of points and triangles, positions, bounds and colours, and a picture that
VTK draws of the glTF file with its own camera. FOLDER/NAME-vtk.png is that picture; FOLDER/NAME.png GLuRay's. Needs an X server
(tests/doors/with_display.py). Exit code 77: VTK is not installed.
"""
import json
import pathlib
import struct
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("--samples", required=True, metavar="PROGRAM")
    parser.add_argument("--out", required=True, type=pathlib.Path, metavar="FOLDER")
    return parser.parse_args()


GIVEN = arguments() if __name__ == "__main__" else None  # before what may be missing is imported

try:
    import numpy as np
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkObject
    from vtkmodules.vtkIOGeometry import vtkOBJReader
    from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
    from vtkmodules.vtkIOImport import vtkGLTFImporter
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

TYPES = {5126: np.float32, 5125: np.uint32, 5123: np.uint16}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
NEAR = 2e-6    # of positions, by the size of the scene
ROUNDING = 1   # of 255, of colours
# Of the picture: pixels that differ by more than CLOSE of 255. Silhouettes of balls that are triangles, edges of triangles, and
# mixtures of colours, which VTK makes of linear light, differ.
CLOSE, SHARE = 12, 0.002


def encoded(linear):
    """Displayed values of linear light, IEC 61966-2-1."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.power(linear, 1 / 2.4) - 0.055)


class Glb:
    """A file, read without VTK: world positions, displayed colours and triangles of all nodes, one after the other."""

    def __init__(self, path):
        data = path.read_bytes()
        (length,) = struct.unpack_from("<I", data, 12)
        self.gltf, self.binary = json.loads(data[20:20 + length]), data[28 + length:]
        self.parts, self.textured = [], False
        for node in self.gltf["nodes"]:
            if "mesh" in node:
                self.parts.append(self.part(node))

    def array(self, index):
        accessor = self.gltf["accessors"][index]
        view, parts, kind = self.gltf["bufferViews"][accessor["bufferView"]], PARTS[accessor["type"]], TYPES[accessor["componentType"]]
        values = np.frombuffer(self.binary, kind, accessor["count"] * parts, view["byteOffset"]).reshape(-1, parts)
        return values / np.iinfo(kind).max if accessor.get("normalized") else values

    def part(self, node):
        (primitive,) = self.gltf["meshes"][node["mesh"]]["primitives"]
        matrix = np.array(node.get("matrix", np.eye(4).ravel())).reshape(4, 4)
        points = self.array(primitive["attributes"]["POSITION"]) @ matrix[:3, :3] + matrix[3, :3]
        pbr = self.gltf["materials"][primitive["material"]]["pbrMetallicRoughness"]
        colors = np.tile(np.array(pbr["baseColorFactor"]), (len(points), 1))
        self.textured |= "baseColorTexture" in pbr
        if "COLOR_0" in primitive["attributes"]:
            colors = colors * self.array(primitive["attributes"]["COLOR_0"])
        colors = np.column_stack([encoded(colors[:, :3]), colors[:, 3]])
        corners = self.array(primitive["indices"]).ravel() if "indices" in primitive else np.arange(len(points))
        triangles = corners.reshape(-1, 3)
        if np.linalg.det(matrix[:3, :3]) < 0:
            triangles = triangles[:, [0, 2, 1]]
        return points, colors, triangles

    def all(self):
        firsts = np.cumsum([0] + [len(points) for points, _, _ in self.parts])
        return (np.concatenate([p for p, _, _ in self.parts]), np.concatenate([c for _, c, _ in self.parts]),
                np.concatenate([t.astype(np.int64) + first for (_, _, t), first in zip(self.parts, firsts)]))


def triangles_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def pixels_of(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(float)


def write_png(pixels, path):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3).astype(np.uint8), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


class Scene:
    def __init__(self, folder, name):
        self.folder, self.name, self.faults = folder, name, []
        self.glb = Glb(folder / (name + ".glb"))
        self.points, self.colors, self.triangles = self.glb.all()
        self.size = np.ptp(self.points, axis=0).max()

    def expect(self, holds, what):
        if not holds:
            self.faults.append(what)

    def near(self, points, what):
        same = points.shape == self.points.shape
        self.expect(same, f"{what}: {len(points)} points, not {len(self.points)}")
        if same:
            off = np.abs(points - self.points).max() / self.size
            self.expect(off <= NEAR, f"{what}: positions are {off:.2g} of the scene's size off")

    def check_obj(self):
        path = self.folder / (self.name + ".obj")
        data = read(vtkOBJReader(), path)
        self.near(vtk_to_numpy(data.GetPoints().GetData()), "OBJ")
        self.expect(np.array_equal(triangles_of(data), self.triangles), "OBJ: other triangles")
        lines = [line.split()[1:] for line in path.read_text().splitlines() if line.startswith("v ")]
        colored = [index for index, line in enumerate(lines) if len(line) == 6]
        if colored:  # VTK reads positions alone
            off = np.abs(np.array([lines[i][3:] for i in colored], float) - self.colors[colored, :3]).max()
            self.expect(off <= 1e-4, f"OBJ: colours are {off:.2g} off")
        materials = path.with_suffix(".mtl").read_text()
        images = [line.split()[-1] for line in materials.splitlines() if line.startswith("map_Kd")]
        self.expect(all((self.folder / image).exists() for image in images), "OBJ: an image is missing")
        self.expect(bool(images) == self.glb.textured, "OBJ: textures")
        groups = path.read_text().count("\ng ")
        # The balls and tubes of an instance are one group.
        self.expect(0 < groups <= len(self.glb.parts), f"OBJ: {groups} groups of {len(self.glb.parts)} nodes")

    def check_ply(self):
        data = read(vtkPLYReader(), self.folder / (self.name + ".ply"))
        self.near(vtk_to_numpy(data.GetPoints().GetData()), "PLY")
        self.expect(np.array_equal(triangles_of(data), self.triangles), "PLY: other triangles")
        colors = vtk_to_numpy(data.GetPointData().GetArray("RGBA")).astype(float)
        if not self.glb.textured and colors.shape == self.colors.shape:
            off = np.abs(colors - 255 * self.colors).max()
            self.expect(off <= ROUNDING, f"PLY: colours are {off:.3g} of 255 off")
        self.expect(len(colors) == len(self.points), "PLY: colours")

    def check_vtk(self, window, importer):
        """The nodes that VTK makes of the glTF file are those of the file, in any order."""
        actors = window.GetRenderers().GetFirstRenderer().GetActors()
        actors.InitTraversal()
        left = list(range(len(self.glb.parts)))
        for _ in range(actors.GetNumberOfItems()):
            actor = actors.GetNextActor()
            actor.GetMapper().Update()
            data, matrix = actor.GetMapper().GetInput(), actor.GetMatrix()
            turn = np.array([[matrix.GetElement(r, c) for c in range(4)] for r in range(4)])
            points = vtk_to_numpy(data.GetPoints().GetData()) @ turn[:3, :3].T + turn[:3, 3]
            same = [i for i in left if len(self.glb.parts[i][0]) == len(points) and data.GetNumberOfPolys() == len(self.glb.parts[i][2])
                    and np.abs(points - self.glb.parts[i][0]).max() <= NEAR * self.size]
            self.expect(same, "glTF: VTK has a node that the file has not")
            if same:
                left.remove(same[0])
        self.expect(not left, f"glTF: VTK lacks {len(left)} of {len(self.glb.parts)} nodes")
        lower, upper = self.points.min(axis=0), self.points.max(axis=0)
        bounds = np.array(window.GetRenderers().GetFirstRenderer().ComputeVisiblePropBounds()).reshape(3, 2)
        off = max(np.abs(bounds[:, 0] - lower).max(), np.abs(bounds[:, 1] - upper).max()) / self.size
        # VTK bounds a turned actor by its turned box.
        turned = any("matrix" in node for node in self.glb.gltf["nodes"] if "mesh" in node)
        self.expect(turned or off <= NEAR, f"glTF: VTK's bounds are {off:.2g} of the scene's size off")
        self.expect(importer.GetNumberOfCameras() == 1, "glTF: VTK finds no camera")

    def set_camera(self, camera):
        """VTK's importer keeps a camera of its own; this makes it the file's."""
        (node,) = [node for node in self.glb.gltf["nodes"] if "camera" in node]
        matrix = np.array(node["matrix"]).reshape(4, 4)
        described = self.glb.gltf["cameras"][node["camera"]]
        values = described[described["type"]]
        camera.SetPosition(matrix[3, :3])
        camera.SetFocalPoint(matrix[3, :3] - matrix[2, :3])
        camera.SetViewUp(matrix[1, :3])
        camera.SetParallelProjection(described["type"] == "orthographic")
        if camera.GetParallelProjection():
            camera.SetParallelScale(values["ymag"])
        else:
            camera.SetViewAngle(np.degrees(values["yfov"]))
        camera.SetClippingRange(max(values["znear"], 1e-3), values["zfar"])

    def check_picture(self, window):
        """VTK draws the file with its own camera and without lights; its linear light becomes displayed values here."""
        renderer = window.GetRenderers().GetFirstRenderer()
        renderer.SetBackground(0, 0, 0)
        actors = renderer.GetActors()
        actors.InitTraversal()
        for _ in range(actors.GetNumberOfItems()):
            actor = actors.GetNextActor()
            look = actor.GetProperty()
            texture = look.GetTexture("albedoTex")
            if texture:
                look.RemoveAllTextures()
                actor.SetTexture(texture)
            look.SetInterpolationToGouraud()
            look.LightingOff()
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.Update()
        shown = 255 * encoded(pixels_of(grab.GetOutput()) / 255)
        write_png(np.rint(shown), self.folder / (self.name + "-vtk.png"))
        expected = pixels_of(read(vtkPNGReader(), self.folder / (self.name + ".png")))
        self.expect(expected.max() > 0, "picture: GLuRay's is empty")
        share = (np.abs(shown - expected).max(axis=2) > CLOSE).mean()
        covered = (expected.max(axis=2) > 0).mean()
        print(f"{self.name}: {len(self.points)} points, {len(self.triangles)} triangles, {len(self.glb.parts)} nodes; "
              f"{100 * share:.2f} % of the picture differ, {100 * covered:.0f} % are covered")
        self.expect(share <= SHARE, f"picture: {100 * share:.2f} % differ by more than {CLOSE}")
        self.expect(covered > 5 * SHARE, "picture: too little is covered to compare")

    def check(self):
        self.check_obj()
        self.check_ply()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(256, 256)
        importer = vtkGLTFImporter()
        importer.SetFileName(str(self.folder / (self.name + ".glb")))
        importer.SetRenderWindow(window)
        importer.Update()
        self.check_vtk(window, importer)
        self.set_camera(window.GetRenderers().GetFirstRenderer().GetActiveCamera())
        self.check_picture(window)
        return self.faults


def main(given):
    given.out.mkdir(parents=True, exist_ok=True)
    vtkObject.GlobalWarningDisplayOff()
    subprocess.run([given.samples, given.out], check=True, stdout=subprocess.DEVNULL)
    names = sorted(path.stem for path in given.out.glob("*.glb"))
    faults = [f"{name}: {fault}" for name in names for fault in Scene(given.out, name).check()]
    print("\n".join(faults) if faults else f"{len(names)} scenes read back")
    return 1 if faults or not names else 0


if __name__ == "__main__":
    sys.exit(main(GIVEN))
