"""Pictures by gmsh's window: fixed function."""
import sys

import gmsh

import scene_list


def drawn(options=(), view=False):
    def draw(file):
        gmsh.initialize(["gmsh", "-nopopup"], readConfigFiles=False)
        gmsh.option.setNumber("General.Terminal", 0)
        for name, value in (("General.GraphicsWidth", 500), ("General.GraphicsHeight", 400), ("Mesh.MeshSizeMax", 0.12), ("General.RotationX", 300), ("General.RotationZ", 30),
                            ("General.Trackball", 0), *options):
            gmsh.option.setNumber(name, value)
        gmsh.model.occ.addTorus(0, 0, 0, 1, 0.35)
        gmsh.model.occ.synchronize()
        gmsh.model.mesh.generate(2)
        if view:
            tags, points, _ = gmsh.model.mesh.getNodes()
            made = gmsh.view.add("height")
            gmsh.view.addModelData(made, 0, "", "NodeData", tags, [[points[3 * i]] for i in range(len(tags))])
        gmsh.fltk.initialize()
        gmsh.graphics.draw()
        gmsh.write(file)
        gmsh.fltk.finalize()
        gmsh.finalize()
    return draw


FACES = (("Mesh.SurfaceFaces", 1), ("Mesh.SurfaceEdges", 0), ("Mesh.ColorCarousel", 2), ("Geometry.Points", 0), ("Geometry.Curves", 0))
SCENES = {"edges": drawn(), "faces": drawn(FACES), "faces, smooth": drawn((*FACES, ("Mesh.SmoothNormals", 1))), "view": drawn((("Mesh.SurfaceEdges", 0),), True)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
