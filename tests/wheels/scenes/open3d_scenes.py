"""Pictures by Open3D's visualizer, in a window of its own."""
import sys

import numpy as np
import open3d as o3d

import scene_list


def colored(mesh):
    mesh.compute_vertex_normals()
    points = np.asarray(mesh.vertices)
    low, high = points.min(0), points.max(0)
    mesh.vertex_colors = o3d.utility.Vector3dVector((points - low) / (high - low))
    return mesh


def drawn(make, change=lambda options: None):
    def draw(file):
        visualizer = o3d.visualization.Visualizer()
        visualizer.create_window(width=500, height=400)
        for geometry in make():
            visualizer.add_geometry(geometry)
        visualizer.get_render_option().background_color = np.array([0.2, 0.3, 0.4])
        change(visualizer.get_render_option())
        visualizer.get_view_control().rotate(150, 80)
        for _ in range(3):
            visualizer.poll_events()
            visualizer.update_renderer()
        visualizer.capture_screen_image(file, do_render=True)
        visualizer.destroy_window()
    return draw


def knot():
    return [colored(o3d.geometry.TriangleMesh.create_torus(1, 0.35, 120, 60))]


def plain():
    mesh = o3d.geometry.TriangleMesh.create_sphere(1, 60)
    mesh.compute_vertex_normals()
    mesh.paint_uniform_color([0.9, 0.6, 0.3])
    return [mesh, o3d.geometry.TriangleMesh.create_coordinate_frame(1.5)]


def cloud():
    mesh = colored(o3d.geometry.TriangleMesh.create_torus(1, 0.35, 200, 100))
    made = o3d.geometry.PointCloud(mesh.vertices)
    made.colors, made.normals = mesh.vertex_colors, mesh.vertex_normals
    return [made]


def bare():
    mesh = o3d.geometry.TriangleMesh.create_torus(1, 0.35, 120, 60)
    mesh.paint_uniform_color([0.9, 0.6, 0.3])
    return [mesh]


def normals(options):
    options.mesh_color_option = o3d.visualization.MeshColorOption.Normal


def unlit(options):
    options.light_on = False


def wireframe(options):
    options.mesh_show_wireframe = True


SCENES = {"mesh, colours": drawn(knot), "mesh, flat shading": drawn(plain, lambda o: setattr(o, "mesh_shade_option", o3d.visualization.MeshShadeOption.Color)),
          "meshes": drawn(plain), "mesh with edges": drawn(knot, wireframe), "points": drawn(cloud),
          "without normals": drawn(bare), "colours of normals": drawn(knot, normals), "unlit": drawn(knot, unlit)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
