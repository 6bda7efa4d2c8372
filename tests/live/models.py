"""The model that viewers are given: a knotted tube, in the file formats that they read."""
import numpy as np


def knot(around=600, across=48):
    """Positions, unit normals (both n x 3) and triangles (m x 3) of a tube along a (2, 3) torus knot."""
    t = np.linspace(0, 2 * np.pi, around, endpoint=False)
    curve = np.stack([(2 + np.cos(3 * t)) * np.cos(2 * t), (2 + np.cos(3 * t)) * np.sin(2 * t), np.sin(3 * t)], 1)
    along = np.roll(curve, -1, 0) - np.roll(curve, 1, 0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    outward = np.stack([np.cos(2 * t), np.sin(2 * t), 0 * t], 1)
    side = np.cross(along, outward)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, along)
    a = np.linspace(0, 2 * np.pi, across, endpoint=False)[None, :, None]
    normals = np.cos(a) * side[:, None] + np.sin(a) * up[:, None]
    positions = curve[:, None] + 0.45 * normals
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    corner = lambda di, dj: ((i + di) % around * across + (j + dj) % across).ravel()
    triangles = np.concatenate([np.stack([corner(0, 0), corner(1, 0), corner(1, 1)], 1),
                                np.stack([corner(0, 0), corner(1, 1), corner(0, 1)], 1)])
    return positions.reshape(-1, 3), normals.reshape(-1, 3), triangles


def write_obj(path, material=False):
    """Wavefront OBJ; `material` names a material file, which is written beside it."""
    positions, normals, triangles = knot()
    lines = []
    if material:
        path.with_suffix(".mtl").write_text("newmtl gold\nKa 0.2 0.16 0.05\nKd 0.8 0.6 0.2\nKs 0.6 0.6 0.5\nNs 40\n")
        lines += [f"mtllib {path.stem}.mtl", "usemtl gold"]
    lines += ["v %.6f %.6f %.6f" % tuple(p) for p in positions]
    lines += ["vn %.6f %.6f %.6f" % tuple(n) for n in normals]
    lines += ["f %d//%d %d//%d %d//%d" % (a, a, b, b, c, c) for a, b, c in triangles + 1]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_off(path, **size):
    positions, _, triangles = knot(**size)
    lines = ["OFF", f"{len(positions)} {len(triangles)} 0"]
    lines += ["%.6f %.6f %.6f" % tuple(p) for p in positions]
    lines += ["3 %d %d %d" % tuple(t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_ply(path):
    positions, normals, triangles = knot()
    lines = ["ply", "format ascii 1.0", f"element vertex {len(positions)}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines += ["%.6f %.6f %.6f %.6f %.6f %.6f" % (*p, *n) for p, n in zip(positions, normals)]
    lines += ["3 %d %d %d" % tuple(t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")
    return path
