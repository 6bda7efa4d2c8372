"""A mesh of 500,000 triangles that turns, drawn by libraries of PyPI; each function opens a window or a framebuffer and returns what draws a frame."""
import os

import numpy as np

SIZE = (800, 600)
COLOR = (0.9, 0.6, 0.3)


def torus(n=707, m=354):
    """Points, normals and triangles, 2 n m of them, of a wavy torus that hides a part of itself."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, n, endpoint=False), np.linspace(0, 2 * np.pi, m, endpoint=False), indexing="ij")
    r = 0.4 + 0.03 * np.sin(20 * u) * np.sin(10 * v)
    points = np.stack([(1 + r * np.cos(v)) * np.cos(u), (1 + r * np.cos(v)) * np.sin(u), r * np.sin(v)], -1).reshape(-1, 3)
    normals = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(m), indexing="ij")
    a, b, c, d = (((i + k) % n * m + (j + l) % m).ravel() for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
    triangles = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)])
    return points.astype("f4"), normals.astype("f4"), triangles.astype("u4")


def turned(degrees):
    angle = np.radians(degrees)
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return matrix


def open3d():
    import open3d as o3d
    points, _, triangles = torus()
    mesh = o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(points), o3d.utility.Vector3iVector(triangles))
    mesh.compute_vertex_normals()
    mesh.paint_uniform_color(COLOR)
    window = o3d.visualization.Visualizer()
    window.create_window(width=SIZE[0], height=SIZE[1])
    window.add_geometry(mesh)
    window.get_view_control().rotate(0, 300)

    def frame(_):
        window.get_view_control().rotate(10, 0)
        window.poll_events()
        window.update_renderer()
    return frame


def vispy():
    from vispy import scene
    points, _, triangles = torus()
    canvas = scene.SceneCanvas(keys=None, size=SIZE, show=True, app="pyqt6")
    view = canvas.central_widget.add_view()
    view.camera = scene.TurntableCamera(fov=40, distance=4, elevation=40)
    scene.visuals.Mesh(points, triangles, color=(*COLOR, 1), shading="smooth", parent=view.scene)

    def frame(_):
        view.camera.azimuth += 2
        canvas.native.repaint()
        canvas.app.process_events()
    return frame


def pyqtgraph():
    import pyqtgraph as pg
    import pyqtgraph.opengl as gl
    points, _, triangles = torus()
    app = pg.mkQApp()
    window = gl.GLViewWidget()
    window.resize(*SIZE)
    window.setCameraPosition(distance=4, elevation=40)
    window.addItem(gl.GLMeshItem(vertexes=points, faces=triangles, color=(*COLOR, 1), shader="shaded", smooth=True))
    window.show()
    while not window.windowHandle().isExposed():
        app.processEvents()

    def frame(_):
        window.orbit(2, 0)
        window.grabFramebuffer()
    return frame


def polyscope():
    import polyscope as ps
    ps.set_window_size(*SIZE)
    ps.set_use_prefs_file(False)
    ps.set_ground_plane_mode("none")
    ps.set_max_fps(-1)
    ps.set_always_redraw(True)
    ps.init()
    points, _, triangles = torus()
    mesh = ps.register_surface_mesh("torus", points, triangles, smooth_shade=True, color=COLOR)
    ps.look_at((2, -2.5, 2.2), (0, 0, 0))

    def frame(number):
        mesh.set_transform(turned(2 * number))
        ps.frame_tick()
    return frame


def pyrender():
    os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    np.infty = np.inf  # pyrender 0.1.45 still uses what NumPy 2 has removed
    import pyrender as pr
    points, normals, triangles = torus()
    scene = pr.Scene(ambient_light=(0.2, 0.2, 0.2))
    material = pr.MetallicRoughnessMaterial(metallicFactor=0.3, roughnessFactor=0.5, baseColorFactor=(*COLOR, 1))
    node = scene.add(pr.Mesh([pr.Primitive(positions=points, normals=normals, indices=triangles, material=material)]))
    pose = np.eye(4)
    pose[1:3, 1:3] = [[0.8, -0.6], [0.6, 0.8]]
    pose[:3, 3] = 4 * pose[:3, 2]
    scene.add(pr.PerspectiveCamera(yfov=0.7), pose=pose)
    scene.add(pr.DirectionalLight(intensity=3), pose=pose)
    renderer = pr.OffscreenRenderer(*SIZE)

    def frame(number):
        scene.set_pose(node, turned(2 * number))
        renderer.render(scene)
    return frame


def moderngl():
    import moderngl as mgl
    context = mgl.create_context(standalone=True, backend="egl")
    program = context.program(
        vertex_shader="""#version 330
uniform mat4 mvp, turn;
in vec3 position, normal;
out vec3 n;
void main() { n = mat3(turn) * normal; gl_Position = mvp * turn * vec4(position, 1.0); }""",
        fragment_shader="""#version 330
uniform vec3 color;
in vec3 n;
out vec4 shown;
void main() { shown = vec4(color * (0.2 + 0.8 * abs(normalize(n).z)), 1.0); }""")
    points, normals, triangles = torus()
    array = context.vertex_array(program, [(context.buffer(points), "3f", "position"), (context.buffer(normals), "3f", "normal")],
                                 context.buffer(triangles))
    target = context.simple_framebuffer(SIZE)
    target.use()
    context.enable(mgl.DEPTH_TEST)
    tilt = np.eye(4)
    tilt[1:3, 1:3] = [[0.6, 0.8], [-0.8, 0.6]]
    tilt[2, 3] = -4
    lens = np.array([[2, 0, 0, 0], [0, 2.7, 0, 0], [0, 0, -1.2, -2.2], [0, 0, -1, 0]])
    program["mvp"].write((lens @ tilt).T.astype("f4").tobytes())
    program["color"].value = COLOR

    def frame(number):
        target.clear(0.2, 0.3, 0.4)
        program["turn"].write(turned(2 * number).T.astype("f4").tobytes())
        array.render()
        context.finish()
    return frame


LIBRARIES = {f.__name__: f for f in (open3d, vispy, polyscope, pyrender, pyqtgraph, moderngl)}
