"""Pictures by F3D's Python module, of models that this file writes."""
import math
import pathlib
import sys
import tempfile

import f3d
from PIL import Image

import scene_list

SIZE = 500, 400


def torus(around=60, across=30):
    """Points, texture coordinates and quads of a torus, whose seams are closed."""
    points, texture, faces = [], [], []
    for i in range(around + 1):
        for j in range(across + 1):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            points.append(((1 + 0.35 * math.cos(v)) * math.cos(u), (1 + 0.35 * math.cos(v)) * math.sin(u), 0.35 * math.sin(v)))
            texture.append((i / around, j / across))
    for i in range(around):
        for j in range(across):
            a = i * (across + 1) + j
            faces.append((a, a + across + 1, a + across + 2, a + 1))
    return points, texture, faces


def obj(folder, textured=False):
    points, texture, faces = torus()
    lines = ["mtllib model.mtl", "usemtl one"] if textured else []
    lines += [f"v {x} {y} {z}" for x, y, z in points] + [f"vt {u} {v}" for u, v in texture]
    lines += ["f " + " ".join(f"{k + 1}/{k + 1}" for k in face) for face in faces]
    file = folder / "model.obj"
    file.write_text("\n".join(lines) + "\n")
    if textured:
        (folder / "model.mtl").write_text("newmtl one\nKd 1 1 1\nmap_Kd image.png\n")
        image = Image.new("RGB", (64, 64))
        image.putdata([(255, 200, 40) if (x // 8 + y // 8) % 2 else (40, 90, 200) for y in range(64) for x in range(64)])
        image.save(folder / "image.png")
    return file


def vtk_points(folder):
    points, _, _ = torus(30, 12)
    file = folder / "model.vtk"
    file.write_text(f"# vtk DataFile Version 3.0\npoints\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n" + "\n".join("%g %g %g" % p for p in points)
                    + f"\nVERTICES {len(points)} {2 * len(points)}\n" + "\n".join(f"1 {i}" for i in range(len(points)))
                    + f"\nPOINT_DATA {len(points)}\nSCALARS height float 1\nLOOKUP_TABLE default\n" + "\n".join(f"{p[2]:g}" for p in points) + "\n")
    return file


def vtk_scalars(folder):
    points, _, faces = torus()
    file = folder / "model.vtk"
    file.write_text(f"# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n" + "\n".join("%g %g %g" % p for p in points)
                    + f"\nPOLYGONS {len(faces)} {5 * len(faces)}\n" + "\n".join("4 %d %d %d %d" % f for f in faces)
                    + f"\nPOINT_DATA {len(points)}\nSCALARS height float 1\nLOOKUP_TABLE default\n" + "\n".join(f"{p[2]:g}" for p in points) + "\n")
    return file


def shown(model=obj, **options):
    """A scene of one model. `options`: F3D's, with _ in place of dots and dashes."""
    def draw(file):
        with tempfile.TemporaryDirectory() as folder:
            engine = f3d.Engine.create(True)
            names = {name.replace(".", "_").replace("-", "_"): name for name in f3d.Options.get_all_names()}
            for name, value in options.items():
                engine.options[names[name]] = value
            engine.window.size = SIZE
            engine.scene.add(str(model(pathlib.Path(folder))))
            engine.window.render_to_image().save(file)
    return draw


SCENES = {
    "surface": shown(),
    "coloured": shown(model_color_rgb=[0.9, 0.6, 0.3]),
    "metal": shown(model_material_metallic=1.0, model_material_roughness=0.3),
    "textured": shown(lambda folder: obj(folder, True)),
    "opacity": shown(model_color_opacity=0.5),
    "edges": shown(render_show_edges=True),
    "grid": shown(render_grid_enable=True),
    "tone mapping": shown(render_effect_tone_mapping=True),
    "scalars": shown(vtk_scalars, model_scivis_array_name="height"),
    "unlit": shown(model_unlit=True),
    "points": shown(vtk_points),
    "point sprites": shown(vtk_points, model_point_sprites_type="sphere"),
    "normal glyphs": shown(model_normal_glyphs_enable=True),
    "light of images": shown(render_hdri_ambient=True),
    "ambient occlusion": shown(render_effect_ambient_occlusion=True),
    "antialiased by FXAA": shown(render_effect_antialiasing_mode="fxaa"),
    "antialiased by SSAA": shown(render_effect_antialiasing_mode="ssaa"),
    "orthographic": shown(scene_camera_orthographic=True),
    "text": shown(ui_filename=True),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
