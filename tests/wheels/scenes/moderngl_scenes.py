"""Pictures by moderngl, in a context without a window: programs of shaders that no family describes."""
import math
import sys

import moderngl
import numpy as np
from PIL import Image

import scene_list

SIZE = 500, 400
VERTEX = """#version 330
uniform mat4 camera;
in vec3 position, normal;
out vec3 direction;
void main() { direction = normal; gl_Position = camera * vec4(position, 1); }"""
FRAGMENT = """#version 330
in vec3 direction;
out vec4 color;
void main() { color = vec4(vec3(0.9, 0.6, 0.3) * (0.2 + 0.8 * abs(normalize(direction).z)), 1); }"""


def ball(rings, radius=1.0):
    """Positions and normals, and triangles, of a sphere."""
    across, around = rings, 2 * rings
    theta, phi = np.meshgrid(np.linspace(0.001, math.pi - 0.001, across + 1), np.linspace(0, 2 * math.pi, around + 1), indexing="ij")
    normal = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1).reshape(-1, 3)
    first = (np.arange(across)[:, None] * (around + 1) + np.arange(around)).ravel()
    triangles = np.concatenate([np.stack([first, first + around + 1, first + 1], 1), np.stack([first + 1, first + around + 1, first + around + 2], 1)])
    return np.hstack([radius * normal, normal]).astype("f4"), triangles.astype("i4")


def camera(turn):
    c, s = math.cos(turn), math.sin(turn)
    return np.array([[0.7 * c, 0, 0.3 * s, 0], [0, 0.85, 0, 0], [-0.7 * s, 0, 0.3 * c, 0], [0, 0, 0, 1]], "f4")


def drawn(rings, frames):
    def draw(file):
        context = moderngl.create_standalone_context(backend="egl")
        program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
        vertices, triangles = ball(rings)
        inner, _ = ball(rings, 0.8)
        arrays = [context.vertex_array(program, [(context.buffer(v.tobytes()), "3f 3f", "position", "normal")], context.buffer(triangles.tobytes()))
                  for v in (vertices, inner)]
        target = context.simple_framebuffer(SIZE)
        target.use()
        context.enable(moderngl.DEPTH_TEST)
        for frame in range(frames):
            target.clear(0.2, 0.3, 0.4, 1)
            program["camera"].write(camera(0.02 * frame).T.tobytes())
            for array in arrays:
                array.render()
            pixels = target.read(components=3)
        Image.frombytes("RGB", SIZE, pixels).save(file)
    return draw


SCENES = {"a small mesh": drawn(30, 2), "a large mesh, turning": drawn(250, 20)}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
