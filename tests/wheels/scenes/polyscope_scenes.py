"""Pictures by polyscope, in its window or without one."""
import sys

import numpy as np
import polyscope as ps

import scene_list


def grid(n=80):
    u, v = np.meshgrid(np.linspace(-1.5, 1.5, n + 1), np.linspace(-1.5, 1.5, n + 1))
    points = np.stack([u, v, 0.3 * np.sin(4 * u) * np.cos(3 * v)], -1).reshape(-1, 3)
    first = np.arange(n * (n + 1)).reshape(n, n + 1)[:, :n].ravel()
    triangles = np.concatenate([np.stack([first, first + 1, first + n + 2], 1), np.stack([first, first + n + 2, first + n + 1], 1)])
    return points, triangles


def shown(fill):
    def draw(file):
        ps.set_program_name("scenes")
        ps.set_window_size(500, 400)
        ps.set_ground_plane_mode("none")
        ps.set_use_prefs_file(False)
        ps.init()
        fill()
        ps.look_at((2.5, -2.5, 2), (0, 0, 0))
        ps.screenshot(file, transparent_bg=False)
    return draw


def mesh(smooth=True, edges=0.0, colors=None, transparency=1.0, material="clay", back="different"):
    def fill():
        points, triangles = grid()
        made = ps.register_surface_mesh("surface", points, triangles, smooth_shade=smooth, edge_width=edges, transparency=transparency, material=material,
                                        back_face_policy=back)
        if colors == "points":
            made.add_color_quantity("places", 0.5 + points / 3, enabled=True)
        if colors == "values":
            made.add_scalar_quantity("height", points[:, 2], enabled=True)
    return fill


def cloud():
    points, _ = grid(40)
    ps.register_point_cloud("points", points, radius=0.01)


def curves():
    points, _ = grid(12)
    ps.register_curve_network("lines", points, "line", radius=0.008)


SCENES = {"mesh, smooth": shown(mesh()), "mesh, flat": shown(mesh(False)), "mesh, scalars": shown(mesh(colors="values")), "mesh, colours": shown(mesh(colors="points")), "mesh, wax": shown(mesh(material="wax", colors="points")),
          "mesh, flat material": shown(mesh(material="flat")), "mesh, equal sides": shown(mesh(back="identical")), "mesh with edges": shown(mesh(edges=1.0)),
          "mesh, translucent": shown(mesh(transparency=0.6)), "spheres of points": shown(cloud), "tubes of curves": shown(curves)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
