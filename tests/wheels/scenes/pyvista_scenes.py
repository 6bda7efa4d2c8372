"""Pictures by PyVista, with its defaults where nothing else is said."""
import sys

import numpy as np
import pyvista as pv

import scene_list

pv.OFF_SCREEN = True
SIZE = (500, 400)


def sphere(resolution=60):
    mesh = pv.Sphere(theta_resolution=resolution, phi_resolution=resolution)
    mesh["height"] = mesh.points[:, 2]
    mesh["rgb"] = (255 * (mesh.points + 0.5)).astype(np.uint8)
    return mesh


def waves():
    x, y = np.meshgrid(np.linspace(-3, 3, 80), np.linspace(-3, 3, 80))
    grid = pv.StructuredGrid(x, y, 0.5 * np.sin(2 * x) * np.cos(y))
    grid["height"] = grid.points[:, 2]
    return grid


def image():
    rng = np.random.default_rng(1)
    return pv.Texture((255 * rng.random((16, 16, 3))).astype(np.uint8).repeat(4, 0).repeat(4, 1))


def shown(*meshes, before=None, **options):
    """A scene of meshes. `before`: changes the plotter before the camera is placed."""
    def draw(file):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE)
        for mesh in meshes:
            plotter.add_mesh(mesh() if callable(mesh) else mesh, **options)
        if before:
            before(plotter)
        plotter.screenshot(file)
    return draw


def by(function):
    """A scene that fills a plotter itself."""
    def draw(file):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE)
        function(plotter)
        plotter.screenshot(file)
    return draw


def cells(mesh):
    return mesh.point_data_to_cell_data()


def arrows():
    mesh = pv.Sphere(theta_resolution=10, phi_resolution=10)
    mesh["normals"] = mesh.points
    return mesh.glyph(orient="normals", scale=False, factor=0.2)


def lines():
    t = np.linspace(0, 6 * np.pi, 200)
    return pv.Spline(np.c_[np.cos(t), np.sin(t), 0.1 * t], 400)


def peeled(plotter):
    plotter.enable_depth_peeling(10)


def splats_of_radii(plotter):
    points = pv.PolyData(np.random.default_rng(1).random((300, 3)))
    points["radius"] = np.linspace(0.01, 0.06, 300)
    actor = plotter.add_mesh(points, style="points_gaussian", render_points_as_spheres=True, color="tan")
    actor.mapper.scale_array = "radius"


def multisampled(samples):
    return lambda plotter: plotter.enable_anti_aliasing("msaa", multi_samples=samples)


def two_views(file):
    plotter = pv.Plotter(off_screen=True, window_size=SIZE, shape=(1, 2))
    plotter.add_mesh(sphere(), color="tan")
    plotter.subplot(0, 1)
    plotter.add_mesh(waves(), scalars="height")
    plotter.screenshot(file)


def blocks():
    return pv.MultiBlock([pv.Cube(center=(i, 0, 0), x_length=0.8) for i in range(3)] + [pv.Sphere(center=(1, 1.2, 0))])


def volume(plotter):
    grid = pv.ImageData(dimensions=(40, 40, 40))
    x, y, z = (np.asarray(grid.points[:, i]) - 19.5 for i in range(3))
    grid["values"] = np.exp(-(x ** 2 + y ** 2 + z ** 2) / 100)
    plotter.add_volume(grid, cmap="viridis")


def physical(mesh=sphere, **options):
    """A scene of a physically based surface."""
    return shown(mesh, **{"pbr": True, "metallic": 0.5, "roughness": 0.4, "color": None if "scalars" in options else "tan"} | options)


def physical_blocks(plotter):
    both = pv.MultiBlock([sphere(20), sphere(20).translate((1, 0, 0))])
    plotter.add_composite(both, scalars="height", pbr=True, metallic=0.5, roughness=0.4)


def lit_by(*lights):
    def draw(plotter):
        plotter.add_mesh(sphere(), color="tan", pbr=True, metallic=0.5, roughness=0.4)
        plotter.remove_all_lights()
        for light in lights:
            plotter.add_light(pv.Light(**light))
    return by(draw)


def environment(plotter):
    colors = np.linspace(0, 255, 32).astype(np.uint8)
    plotter.set_environment_texture(pv.Texture(np.dstack([np.tile(colors, (16, 1))] * 3)), is_srgb=False)
    plotter.add_mesh(sphere(), color="gold", pbr=True, metallic=0.8, roughness=0.3)


SCENES = {
    "smooth": shown(lambda: sphere().compute_normals(), color="tan", smooth_shading=True),
    "flat": shown(sphere, color="tan"),
    "scalars": shown(sphere, scalars="height"),
    "scalars of cells": shown(lambda: cells(sphere()), scalars="height"),
    "smooth scalars": shown(waves, scalars="height", smooth_shading=True),
    "colours of points": shown(sphere, scalars="rgb", rgb=True),
    "colours of cells": shown(lambda: cells(sphere()), scalars="rgb", rgb=True),
    "unlit": shown(sphere, color="tan", lighting=False),
    "unlit scalars": shown(sphere, scalars="height", lighting=False),
    "unlit colours of cells": shown(lambda: cells(sphere()), scalars="height", lighting=False),
    "edges": shown(lambda: sphere(20), color="tan", show_edges=True),
    "edges and scalars": shown(lambda: sphere(20), scalars="height", show_edges=True, line_width=2),
    "edges, unlit": shown(lambda: sphere(20), color="tan", show_edges=True, lighting=False),
    "wireframe": shown(lambda: sphere(20), color="tan", style="wireframe"),
    "points": shown(sphere, color="tan", style="points", point_size=4),
    "points as spheres": shown(sphere, color="tan", style="points", point_size=8, render_points_as_spheres=True),
    "points as spheres, 4 samples": shown(sphere, color="tan", style="points", point_size=12, render_points_as_spheres=True, before=multisampled(4)),
    "points as spheres, 8 samples": shown(sphere, color="tan", style="points", point_size=12, render_points_as_spheres=True, before=multisampled(8)),
    "points as spheres, scalars": shown(sphere, scalars="height", style="points", point_size=7, render_points_as_spheres=True, before=multisampled(4)),
    "points as spheres, unlit": shown(sphere, color="tan", style="points", point_size=5, render_points_as_spheres=True, lighting=False),
    "points as spheres, opacity": shown(sphere, color="tan", style="points", point_size=12, render_points_as_spheres=True, opacity=0.5),
    "vertices as spheres": shown(lambda: sphere(20), color="tan", show_vertices=True, vertex_color="red", point_size=12, render_points_as_spheres=True),
    "point splats": shown(sphere, style="points_gaussian", point_size=8, scalars="height"),
    "point splats, plain": shown(lambda: sphere(20), color="tan", style="points_gaussian", point_size=20),
    "point splats, emissive": shown(lambda: sphere(20), color="tan", style="points_gaussian", point_size=20, emissive=True),
    "point splats, opacity": shown(lambda: sphere(20), scalars="height", style="points_gaussian", point_size=20, opacity=0.5),
    "point splats, peeled": shown(lambda: sphere(20), scalars="height", style="points_gaussian", point_size=20, before=peeled),
    "point splats as spheres": shown(lambda: sphere(20), scalars="height", style="points_gaussian", point_size=20, render_points_as_spheres=True),
    "point splats of radii": by(splats_of_radii),
    "lines": shown(lines, color="red", line_width=3),
    "lines as tubes": shown(lines, color="red", line_width=8, render_lines_as_tubes=True),
    "lines as tubes, opacity": shown(lines, color="red", line_width=8, render_lines_as_tubes=True, opacity=0.5),
    "tubes": shown(lambda: lines().tube(0.05), color="red"),
    "arrows": shown(arrows, color="tan"),
    "opacity": shown(sphere, color="tan", opacity=0.5),
    "opacity, peeled": shown(sphere, color="tan", opacity=0.5, before=peeled),
    "opacity with edges": shown(lambda: sphere(20), color="tan", opacity=0.5, show_edges=True),
    "opacity with edges, peeled": shown(lambda: sphere(20), color="tan", opacity=0.5, show_edges=True, before=peeled),
    "opacity with edges and scalars": shown(lambda: sphere(20), scalars="height", opacity=0.5, show_edges=True),
    "opacity by scalars": shown(sphere, scalars="height", opacity="linear"),
    "texture": shown(lambda: sphere().texture_map_to_plane(), texture=image()),
    "physically based": shown(sphere, color="gold", pbr=True, metallic=0.8, roughness=0.3),
    "physically based scalars": shown(sphere, scalars="height", pbr=True, metallic=0.3, roughness=0.5),
    "physically based, environment": by(environment),
    "physically based, smooth metal": physical(metallic=1.0, roughness=0.03),
    "physically based, back faces": physical(lambda: sphere().clip("x"), backface_params={"color": "blue"}),
    "physically based, opacity": physical(opacity=0.5),
    "physically based, opacity, peeled": physical(opacity=0.5, before=peeled),
    "physically based, edges": physical(lambda: sphere(20), show_edges=True),
    "physically based, edges and scalars": physical(lambda: sphere(20), scalars="height", show_edges=True),
    "physically based, scalars of cells": physical(lambda: cells(sphere()), scalars="height"),
    "physically based, translucent scalars": physical(scalars="height", opacity=0.5),
    "physically based, colours of points": physical(scalars="rgb", rgb=True),
    "physically based, texture": physical(lambda: sphere().texture_map_to_plane(), texture=image()),
    "physically based, blocks": by(physical_blocks),
    "physically based, head light": lit_by({"light_type": "headlight"}),
    "physically based, lamps": lit_by({"position": (2, 2, 2), "positional": True, "cone_angle": 30}, {"light_type": "headlight", "intensity": 0.3}),
    "back faces": shown(lambda: sphere().clip("x"), color="tan", backface_params={"color": "blue"}),
    "silhouette": shown(sphere, color="tan", silhouette=True),
    "clip plane": by(lambda p: p.add_mesh_clip_plane(sphere(), color="tan")),
    "contours": shown(lambda: waves().contour(12), line_width=3),
    "blocks": by(lambda p: p.add_mesh(blocks(), color="tan")),
    "coloured blocks": by(lambda p: p.add_composite(blocks(), color="tan")),
    "glyphs by the mapper": by(lambda p: p.add_arrows(sphere(10).points, sphere(10).points, 0.2)),
    "labels": by(lambda p: (p.add_mesh(sphere()), p.add_point_labels(sphere(5).points[:6], [f"point {i}" for i in range(6)]))),
    "bounds and axes": by(lambda p: (p.add_mesh(waves()), p.show_bounds(), p.add_axes())),
    "shadows": by(lambda p: (p.add_mesh(sphere()), p.enable_shadows())),
    "ambient occlusion of VTK": by(lambda p: (p.add_mesh(waves()), p.enable_ssao())),
    "eye-dome lighting": by(lambda p: (p.add_mesh(waves()), p.enable_eye_dome_lighting())),
    "antialiased by FXAA": by(lambda p: (p.add_mesh(sphere()), p.enable_anti_aliasing("fxaa"))),
    "antialiased by SSAA": by(lambda p: (p.add_mesh(sphere()), p.enable_anti_aliasing("ssaa"))),
    "multisampled": by(lambda p: (p.add_mesh(sphere()), p.enable_anti_aliasing("msaa", multi_samples=4))),
    "parallel projection": by(lambda p: (p.add_mesh(sphere()), p.enable_parallel_projection())),
    "two views": two_views,
    "volume": by(volume),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
