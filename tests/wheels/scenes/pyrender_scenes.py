"""Pictures by pyrender, without a window."""
import os
import sys

os.environ.setdefault("PYOPENGL_PLATFORM", "egl")

import numpy as np  # noqa: E402

np.infty = np.inf  # pyrender 0.1.45 still uses what NumPy 2 has removed

import pyrender  # noqa: E402
import trimesh  # noqa: E402
from PIL import Image  # noqa: E402

import scene_list  # noqa: E402


def drawn(mesh, flags=pyrender.RenderFlags.NONE, light=pyrender.DirectionalLight, **more):
    def draw(file):
        scene = pyrender.Scene(bg_color=(0.2, 0.3, 0.4, 1), ambient_light=(0.2, 0.2, 0.2))
        scene.add(mesh(**more))
        pose = np.eye(4)
        pose[:3, 3] = 0, 0, 3.2
        scene.add(pyrender.PerspectiveCamera(yfov=0.8), pose=pose)
        aside = trimesh.transformations.rotation_matrix(0.8, (1, -1, 0))
        aside[:3, 3] = 3 * aside[:3, 2]
        scene.add(light(color=(1, 1, 1), intensity=3), pose=aside)
        renderer = pyrender.OffscreenRenderer(500, 400)
        Image.fromarray(renderer.render(scene, flags=flags)[0]).save(file)
        renderer.delete()
    return draw


def placed(*places):
    poses = np.tile(np.diag([0.3, 0.4, 0.5, 1.0]), (len(places), 1, 1))
    poses[:, :3, 3] = places
    return poses


def ball(smooth=True, colors=False, poses=None):
    mesh = trimesh.creation.icosphere(subdivisions=4)
    if colors:
        mesh.visual.vertex_colors = np.c_[127 + 127 * mesh.vertices, np.full(len(mesh.vertices), 255)].astype(np.uint8)
    material = None if colors else pyrender.MetallicRoughnessMaterial(metallicFactor=0.3, roughnessFactor=0.5, baseColorFactor=(0.9, 0.6, 0.3, 1))
    return pyrender.Mesh.from_trimesh(mesh, material=material, smooth=smooth, poses=poses)


SCENES = {"mesh, smooth": drawn(ball), "mesh, flat": drawn(ball, smooth=False), "mesh, vertex colours": drawn(ball, colors=True),
          "unlit": drawn(ball, pyrender.RenderFlags.FLAT), "unlit, vertex colours": drawn(ball, pyrender.RenderFlags.FLAT, colors=True),
          "instances": drawn(ball, poses=placed((-0.6, 0, 0), (0.6, 0.2, 0), (0, -0.6, 0.5))),
          "both sides": drawn(ball, pyrender.RenderFlags.SKIP_CULL_FACES), "light at a point": drawn(ball, light=pyrender.PointLight)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
