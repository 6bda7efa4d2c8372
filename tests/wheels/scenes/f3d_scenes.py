"""Pictures by F3D's Python module, of models that this file writes."""
import math
import pathlib
import sys
import tempfile

import f3d

import gltf_model
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
        gltf_model.image(folder / "image.png", gltf_model.chequers)
    return file


def vtk_points(folder):
    points, _, _ = torus(30, 12)
    file = folder / "model.vtk"
    file.write_text(f"# vtk DataFile Version 3.0\npoints\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n" + "\n".join("%g %g %g" % p for p in points)
                    + f"\nVERTICES {len(points)} {2 * len(points)}\n" + "\n".join(f"1 {i}" for i in range(len(points)))
                    + f"\nPOINT_DATA {len(points)}\nSCALARS height float 1\nLOOKUP_TABLE default\n" + "\n".join(f"{p[2]:g}" for p in points) + "\n")
    return file


def vtk_surface(folder, kind, count, values):
    points, _, faces = torus()
    file = folder / "model.vtk"
    file.write_text(f"# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET POLYDATA\nPOINTS {len(points)} float\n" + "\n".join("%g %g %g" % p for p in points)
                    + f"\nPOLYGONS {len(faces)} {5 * len(faces)}\n" + "\n".join("4 %d %d %d %d" % f for f in faces)
                    + f"\n{kind} {count}\nSCALARS height float 1\nLOOKUP_TABLE default\n" + "\n".join(f"{v:g}" for v in values) + "\n")
    return file


def vtk_scalars(folder):
    points, _, _ = torus()
    return vtk_surface(folder, "POINT_DATA", len(points), [p[2] for p in points])


def vtk_cells(folder):
    _, _, faces = torus()
    return vtk_surface(folder, "CELL_DATA", len(faces), range(len(faces)))


def gltf(look=None, **how):
    return lambda folder: gltf_model.write(folder, look, **how)


def shown(model=obj, pictures=None, **options):
    """A scene of one model. `options`: F3D's, with _ in place of dots and dashes; `pictures`: those that name files, with a function for gltf_model.image()."""
    def draw(file):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files = {option: gltf_model.image(folder / f"{option}.png", color) for option, color in (pictures or {}).items()}
            engine = f3d.Engine.create(True)
            names = {option.replace(".", "_").replace("-", "_"): option for option in f3d.Options.get_all_names()}
            for option, value in (options | files).items():
                engine.options[names[option]] = value
            engine.window.size = SIZE
            engine.scene.add(str(model(folder)))
            engine.window.render_to_image().save(file)
    return draw


def sky(x, y):
    return min(255, 4 * y), 120 + x, 255 - 4 * y


SCALARS = {"model_coloring": "scivis", "model_scivis_array_name": "height"}
HEIGHT, CELLS = SCALARS | {"model_scivis_field": "points"}, SCALARS | {"model_scivis_field": "cells"}
SCENES = {
    "surface": shown(),
    "coloured": shown(model_color_rgb=[0.9, 0.6, 0.3]),
    "metal": shown(model_material_metallic=1.0, model_material_roughness=0.3),
    "textured": shown(lambda folder: obj(folder, True)),
    "opacity": shown(model_color_opacity=0.5),
    "edges": shown(render_show_edges=True),
    "grid": shown(render_grid_enable=True),
    "tone mapping": shown(render_effect_tone_mapping=True),
    "scalars": shown(vtk_scalars, **HEIGHT),
    "scalars and edges": shown(vtk_scalars, render_show_edges=True, **HEIGHT),
    "scalars of cells": shown(vtk_cells, **CELLS),
    "scalars of cells and edges": shown(vtk_cells, render_show_edges=True, **CELLS),
    "translucent scalars": shown(vtk_scalars, model_color_opacity=0.5, **HEIGHT),
    "unlit": shown(model_unlit=True),
    "unlit scalars": shown(vtk_scalars, model_unlit=True, **HEIGHT),
    "unlit scalars of cells": shown(vtk_cells, model_unlit=True, **CELLS),
    "unlit and edges": shown(model_unlit=True, render_show_edges=True),
    "unlit and textured": shown(lambda folder: obj(folder, True), model_unlit=True),
    "opacity, peeled": shown(model_color_opacity=0.5, render_effect_blending_mode="ddp"),
    "opacity, sorted": shown(model_color_opacity=0.5, render_effect_blending_mode="sort"),
    "opacity and edges": shown(model_color_opacity=0.5, render_show_edges=True),
    "opacity and edges, peeled": shown(model_color_opacity=0.5, render_show_edges=True, render_effect_blending_mode="ddp"),
    "mirror": shown(gltf(), model_material_metallic=1.0, model_material_roughness=0.03),
    "textures": shown(pictures={"model_color_texture": gltf_model.chequers, "model_material_texture": gltf_model.material,
                                "model_emissive_texture": gltf_model.glow, "model_normal_texture": gltf_model.bumps}),
    "glTF": shown(gltf({"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.5, 0.3, 1], "metallicFactor": 0.2, "roughnessFactor": 0.4}})),
    "glTF, colours": shown(gltf(colors=True)),
    "glTF, textures": shown(gltf(gltf_model.TEXTURED, textures=gltf_model.TEXTURES)),
    "glTF, textures and colours": shown(gltf(gltf_model.TEXTURED, colors=True, textures=gltf_model.TEXTURES)),
    "glTF, both sides": shown(gltf({"doubleSided": True} | gltf_model.TEXTURED, textures=gltf_model.TEXTURES)),
    "glTF, edges": shown(gltf(gltf_model.TEXTURED, textures=gltf_model.TEXTURES), render_show_edges=True),
    "glTF, unlit": shown(gltf(gltf_model.UNLIT, textures=gltf_model.TEXTURES[:1])),
    "glTF, translucent": shown(gltf({"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.5, 0.3, 0.5]}})),
    "light of an image": shown(gltf(), {"render_hdri_file": sky}, render_hdri_ambient=True),
    "light of an image on metal": shown(gltf(), {"render_hdri_file": sky}, render_hdri_ambient=True, model_material_metallic=1.0, model_material_roughness=0.2),
    "points": shown(vtk_points),
    "point sprites": shown(vtk_points, model_point_sprites_type="sphere"),
    "point sprites, scalars": shown(vtk_points, model_point_sprites_type="sphere", **HEIGHT),
    "point sprites, gaussian": shown(vtk_points, model_point_sprites_type="gaussian"),
    "point sprites, gaussian, scalars": shown(vtk_points, model_point_sprites_type="gaussian", **HEIGHT),
    "point sprites, circle": shown(vtk_points, model_point_sprites_type="circle"),
    "normal glyphs": shown(gltf(), model_normal_glyphs_enable=True),
    "a picture of a material": shown(gltf(), {"model_matcap_texture": sky}),
    "light of images": shown(render_hdri_ambient=True),
    "ambient occlusion": shown(render_effect_ambient_occlusion=True),
    "antialiased by FXAA": shown(render_effect_antialiasing_mode="fxaa"),
    "antialiased by SSAA": shown(render_effect_antialiasing_mode="ssaa"),
    "orthographic": shown(scene_camera_orthographic=True),
    "text": shown(ui_filename=True),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
