"""glTF files of a torus, with textures beside them."""
import base64
import json
import math
import struct

from PIL import Image

AROUND, ACROSS = 60, 30
RING, TUBE = 1.0, 0.35
FLOAT, UNSIGNED, VERTICES, INDICES = 5126, 5125, 34962, 34963


def image(file, color):
    """A picture of 64 x 64 pixels; color(x, y): three bytes."""
    picture = Image.new("RGB", (64, 64))
    picture.putdata([color(x, y) for y in range(64) for x in range(64)])
    picture.save(file)
    return str(file)


def chequers(x, y):
    return (255, 200, 40) if (x // 8 + y // 8) % 2 else (40, 90, 200)


def material(x, y):
    """Occlusion, roughness and metallic share."""
    return 200 + x % 8, 80 + 2 * y, 4 * y


def glow(x, _):
    return (0, 0, 80) if x % 16 < 4 else (0, 0, 0)


def bumps(x, y):
    return 128 + int(30 * math.sin(x / 5)), 128 + int(30 * math.cos(y / 5)), 240


TEXTURES = (chequers, material, glow, bumps)
TEXTURED = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
            "occlusionTexture": {"index": 1}, "emissiveTexture": {"index": 2}, "emissiveFactor": [1, 1, 1],
            "normalTexture": {"index": 3}}
UNLIT = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}, "extensions": {"KHR_materials_unlit": {}}}


def corners():
    """Positions, normals, tangents, texture coordinates and colours of the torus' corners."""
    for i in range(AROUND + 1):
        for j in range(ACROSS + 1):
            u, v = 2 * math.pi * i / AROUND, 2 * math.pi * j / ACROSS
            normal = math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v)
            place = RING * math.cos(u) + TUBE * normal[0], RING * math.sin(u) + TUBE * normal[1], TUBE * normal[2]
            yield place, normal, (-math.sin(u), math.cos(u), 0.0, 1.0), (i / AROUND, j / ACROSS), [abs(c) / (RING + TUBE) for c in place]


def triangles():
    for i in range(AROUND):
        for j in range(ACROSS):
            a = i * (ACROSS + 1) + j
            yield a, a + ACROSS + 1, a + ACROSS + 2
            yield a, a + ACROSS + 2, a + 1


class Model:
    def __init__(self):
        self.data, self.views, self.accessors = b"", [], []

    def add(self, rows, kind, target, component=FLOAT):
        """An accessor of rows of numbers; its index."""
        letter = "f" if component == FLOAT else "I"
        packed = b"".join(struct.pack(f"<{len(row)}{letter}", *row) for row in rows)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(packed), "target": target})
        self.data += packed
        count = sum(map(len, rows)) if kind == "SCALAR" else len(rows)
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "type": kind, "count": count})
        return len(self.accessors) - 1


def write(folder, look=None, colors=False, tangents=True, textures=()):
    """Writes FOLDER/model.gltf with a material `look`; `textures`: functions for image()."""
    place, normal, tangent, texture, color = map(list, zip(*corners()))
    model = Model()
    attributes = {"POSITION": model.add(place, "VEC3", VERTICES), "NORMAL": model.add(normal, "VEC3", VERTICES),
                  "TEXCOORD_0": model.add(texture, "VEC2", VERTICES)}
    model.accessors[0] |= {"min": [min(p[i] for p in place) for i in range(3)], "max": [max(p[i] for p in place) for i in range(3)]}
    if colors:
        attributes["COLOR_0"] = model.add(color, "VEC3", VERTICES)
    if tangents:
        attributes["TANGENT"] = model.add(tangent, "VEC4", VERTICES)
    indices = model.add(list(triangles()), "SCALAR", INDICES, UNSIGNED)
    for made in textures:
        image(folder / f"{made.__name__}.png", made)
    scene = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}], "materials": [look or {}],
             "accessors": model.accessors, "bufferViews": model.views,
             "buffers": [{"byteLength": len(model.data), "uri": "data:application/octet-stream;base64," + base64.b64encode(model.data).decode()}]}
    if textures:
        scene |= {"images": [{"uri": f"{made.__name__}.png"} for made in textures], "textures": [{"source": i} for i in range(len(textures))]}
    if look and "extensions" in look:
        scene["extensionsUsed"] = list(look["extensions"])
    file = folder / "model.gltf"
    file.write_text(json.dumps(scene))
    return file
