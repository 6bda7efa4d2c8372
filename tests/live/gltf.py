"""A glTF model with textures of every kind that its core has, for viewers."""
import base64
import json
import struct
import zlib

import models
import numpy as np


def png(pixels):
    """`pixels`: height x width x 3 numbers from 0 to 1."""
    rows = np.clip(255 * pixels + 0.5, 0, 255).astype(np.uint8)
    lines = b"".join(b"\0" + row.tobytes() for row in rows)

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    head = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def embedded(kind, body):
    return f"data:{kind};base64,{base64.b64encode(body).decode()}"


def textures(side=64):
    """Images of base colour, of occlusion, roughness and metallic share, of normals, and of emission."""
    t, s = np.mgrid[0:side, 0:side] / side * 2 * np.pi
    layers = [(0.6 + 0.4 * np.sin(s), 0.6 + 0.3 * np.cos(2 * t), 0.4), (0.7 + 0.3 * np.cos(t), 0.6 + 0.3 * np.sin(s), 0.5 + 0.5 * np.sin(t)),
              (0.5 + 0.1 * np.sin(2 * s), 0.5 + 0.1 * np.cos(2 * t), 0.97), (0.3 * (np.sin(s) > 0.7), 0.1, 0)]
    return [png(np.stack(np.broadcast_arrays(*layer), -1)) for layer in layers]


def write(path, around=200, across=24):
    """A knot as a file that needs no others. Seams of its texture are inside triangles."""
    positions, normals, triangles = models.knot(around, across)
    u, v = np.meshgrid(np.arange(around) / around * 24, np.arange(across) / across * 4, indexing="ij")
    places = np.stack([u.ravel(), v.ravel()], 1)
    tangents = np.cross(np.array([0.1, 0.2, 1.0]), normals)
    tangents = np.concatenate([tangents / np.linalg.norm(tangents, axis=1, keepdims=True), np.ones((len(normals), 1))], 1)
    arrays = [positions.astype("<f4"), normals.astype("<f4"), places.astype("<f4"), tangents.astype("<f4"), triangles.astype("<u4")]
    views, accessors, data = [], [], b""
    for array, kind in zip(arrays, ("VEC3", "VEC3", "VEC2", "VEC4", "SCALAR")):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
        accessors.append({"bufferView": len(accessors), "componentType": 5125 if kind == "SCALAR" else 5126,
                          "count": array.size if kind == "SCALAR" else len(array), "type": kind})
        data += array.tobytes()
    accessors[0] |= {"min": positions.min(0).tolist(), "max": positions.max(0).tolist()}
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
                "occlusionTexture": {"index": 1}, "normalTexture": {"index": 2, "scale": 0.7},
                "emissiveTexture": {"index": 3}, "emissiveFactor": [1, 0.8, 0.5]}
    names = ("POSITION", "NORMAL", "TEXCOORD_0", "TANGENT")
    images = textures()
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {name: i for i, name in enumerate(names)}, "indices": 4, "material": 0}]}],
        "materials": [material], "accessors": accessors, "bufferViews": views,
        "buffers": [{"uri": embedded("application/octet-stream", data), "byteLength": len(data)}],
        "images": [{"uri": embedded("image/png", image)} for image in images],
        "textures": [{"source": i, "sampler": 0} for i in range(len(images))],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}]}))
    return path
