"""Models for viewers, in the file formats that they read: mostly a knotted tube."""
import pathlib
import struct
import subprocess
import zlib

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


def write_obj(path, material=False, **size):
    """Wavefront OBJ; `material` names a material file, which is written beside it."""
    positions, normals, triangles = knot(**size)
    lines = []
    if material:
        path.with_suffix(".mtl").write_text("newmtl gold\nKa 0.2 0.16 0.05\nKd 0.8 0.6 0.2\nKs 0.6 0.6 0.5\nNs 40\n")
        lines += [f"mtllib {path.stem}.mtl", "usemtl gold"]
    lines += ["v %.6f %.6f %.6f" % tuple(p) for p in positions]
    lines += ["vn %.6f %.6f %.6f" % tuple(n) for n in normals]
    lines += ["f %d//%d %d//%d %d//%d" % (a, a, b, b, c, c) for a, b, c in triangles + 1]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_image(path, side=64):
    """A PNG of soft waves of colour."""
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    wave = lambda turns: (127.5 + 127.5 * np.sin(2 * np.pi * turns / side)).astype("u1")
    rows = np.stack([wave(x + y), wave(2 * y), wave(3 * x - y)], 2).reshape(side, -1)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    data = zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", data) + chunk(b"IEND", b""))
    return path


def write_ctm(path, around=600, across=48):
    """OpenCTM with texture coordinates and the name of an image beside it; written by ctmconv (openctm-tools)."""
    positions, normals, triangles = knot(around, across)
    i, j = np.divmod(np.arange(len(positions)), across)
    lines = ["v %.6f %.6f %.6f" % tuple(p) for p in positions]
    lines += ["vt %.6f %.6f" % (12 * a / around, 2 * b / across) for a, b in zip(i, j)]
    lines += ["vn %.6f %.6f %.6f" % tuple(n) for n in normals]
    lines += ["f " + " ".join(f"{v}/{v}/{v}" for v in t) for t in triangles + 1]
    wavefront = path.with_suffix(".obj")
    wavefront.write_text("\n".join(lines) + "\n")
    image = write_image(path.with_suffix(".png"))
    subprocess.run(["ctmconv", wavefront, path, "--texfile", image.name], check=True, capture_output=True)
    return path


def write_off(path, **size):
    positions, _, triangles = knot(**size)
    lines = ["OFF", f"{len(positions)} {len(triangles)} 0"]
    lines += ["%.6f %.6f %.6f" % tuple(p) for p in positions]
    lines += ["3 %d %d %d" % tuple(t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_ply(path, **size):
    positions, normals, triangles = knot(**size)
    lines = ["ply", "format ascii 1.0", f"element vertex {len(positions)}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines += ["%.6f %.6f %.6f %.6f %.6f %.6f" % (*p, *n) for p, n in zip(positions, normals)]
    lines += ["3 %d %d %d" % tuple(t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")
    return path


def write_mesh(path, **size):
    """The format of INRIA's mesh tools."""
    positions, _, triangles = knot(**size)
    lines = ["MeshVersionFormatted 1", "Dimension 3", "Vertices", str(len(positions))]
    lines += ["%.6f %.6f %.6f 0" % tuple(p) for p in positions]
    lines += ["Triangles", str(len(triangles))]
    lines += ["%d %d %d 1" % tuple(t) for t in triangles + 1]
    path.write_text("\n".join([*lines, "End"]) + "\n")
    return path


def write_stl(path, **size):
    positions, _, triangles = knot(**size)
    lines = ["solid knot"]
    for corners in positions[triangles]:
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        lines += ["facet normal %.6f %.6f %.6f" % tuple(normal / np.linalg.norm(normal)), "outer loop"]
        lines += ["vertex %.6f %.6f %.6f" % tuple(p) for p in corners]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid knot"]) + "\n")
    return path


def write_binary_stl(path, **size):
    positions, _, triangles = knot(**size)
    corners = positions[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facets = np.zeros(len(triangles), [("normal", "<3f4"), ("corners", "<9f4"), ("attribute", "<u2")])
    facets["normal"] = normals / np.linalg.norm(normals, axis=1)[:, None]
    facets["corners"] = 10 * corners.reshape(-1, 9)
    path.write_bytes(bytes(80) + np.uint32(len(triangles)).tobytes() + facets.tobytes())
    return path


def write_slvs(path, **size):
    """A SolveSpace sketch that links a mesh, beside the three planes that all sketches have."""
    mesh = write_binary_stl(path.with_suffix(".stl"), **size)
    turns = [(1, 0, 0, 0), (0.5, 0.5, 0.5, 0.5), (0.5, -0.5, -0.5, -0.5)]  # of the planes

    def group(number, kind, more=""):
        return (f"Group.h.v={number:08x}\nGroup.type={kind}\nGroup.name=g{number}\nGroup.color=ff808080\nGroup.visible=1\n"
                f"Group.scale=1.0\nGroup.remap={{\n}}\n{more}AddGroup\n\n")

    def parameter(plane, number, value):
        return f"Param.h.v.={plane << 16 | number:08x}\nParam.val={value:.20f}\nAddParam\n\n"

    text = "\xb1\xb2\xb3SolveSpaceREVa\n\n\n" + group(1, 5000) + group(2, 5300, f"Group.order=1\nGroup.impFile={mesh}\nGroup.impFileRel={mesh.name}\n")
    for plane, turn in enumerate(turns, 1):
        for number, value in [*((16 + i, 0) for i in range(3)), *((32 + i, turn[i]) for i in range(4))]:
            text += parameter(plane, number, value)
    for plane in range(1, 4):
        text += f"Request.h.v={plane:08x}\nRequest.type=100\nRequest.group.v=00000001\nRequest.construction=0\nAddRequest\n\n"
    path.write_bytes(text.encode("latin-1"))
    return path


def write_mif(path, side=48):
    """An MRtrix image: shells in a ball."""
    x, y, z = np.indices((side,) * 3) - side / 2
    radius = np.sqrt(x * x + y * y + z * z)
    values = np.where(radius < 0.42 * side, 127 + 120 * np.sin(0.7 * radius), 0).astype(np.uint8)
    header = f"mrtrix image\ndim: {side},{side},{side}\nvox: 1,1,1\nlayout: +2,+1,+0\ndatatype: UInt8\nfile: . 256\nEND\n".encode()
    path.write_bytes(header.ljust(256, b"\0") + values.tobytes())
    return path


def write_x3d(path, **size):
    """X3D in its classic encoding, one shape without normals."""
    positions, _, triangles = knot(**size)
    points = ", ".join("%.5f %.5f %.5f" % tuple(p) for p in positions)
    faces = " ".join("%d %d %d -1" % tuple(t) for t in triangles)
    path.write_text(f"""#X3D V3.2 utf8
PROFILE Interchange
Viewpoint {{ position 0 0 10 }}
Transform {{ rotation 1 0 0 0.4 children Shape {{
  appearance Appearance {{ material Material {{ diffuseColor 0.8 0.6 0.2 specularColor 0.5 0.5 0.5 }} }}
  geometry IndexedFaceSet {{ creaseAngle 3 solid FALSE coordIndex [{faces}] coord Coordinate {{ point [{points}] }} }}
}} }}
""")
    return path


def write_scad(path):
    """A solid cut by others (several passes with a stencil), and one beside it."""
    path.write_text("""difference() {
  cube([30, 30, 30], center = true);
  sphere(r = 19, $fn = 48);
  translate([12, 0, 0]) cylinder(h = 60, r = 8, center = true, $fn = 32);
}
translate([0, 0, -20]) cylinder(h = 4, r = 28, $fn = 64);
""")
    return path


def write_edp(path):
    """A FreeFem++ script: Poisson's equation on an ellipse, its solution as a surface."""
    path.write_text("""border rim(t = 0, 2 * pi) { x = cos(t); y = 0.7 * sin(t); label = 1; }
mesh Th = buildmesh(rim(60));
fespace Vh(Th, P1);
Vh u, v;
solve Poisson(u, v) = int2d(Th)(dx(u) * dx(v) + dy(u) * dy(v)) - int2d(Th)(v) + on(1, u = 0);
plot(u, fill = true, dim = 3, value = true, wait = true);
""")
    return path


def write_road_net(path):
    """A grid of streets."""
    subprocess.run(["netgenerate", "--grid", "--grid.number=4", "-o", str(path)], check=True, capture_output=True)
    return path


BUCKY = "/usr/share/doc/drawxtl/examples/bucky.str"


def copy_bucky(path):
    """DRAWxtl's own example of a molecule, copied because it writes files beside its input."""
    path.write_bytes(pathlib.Path(BUCKY).read_bytes())
    return path


def write_xyz(path):
    """Sixty carbon atoms, bonded on a sphere's spiral."""
    k = np.arange(60)
    z, turn = 1 - (2 * k + 1) / 60, k * np.pi * (3 - np.sqrt(5))
    ball = 3.5 * np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], 1)
    path.write_text("60\nball\n" + "".join("C %.5f %.5f %.5f\n" % tuple(p) for p in ball))
    return path


def write_helix_pdb(path, residues=20):
    """An alpha helix of alanine, for viewers of molecules."""
    backbone = {"N": (1.55, -27.5, -0.9), "CA": (2.29, 0, 0), "C": (1.68, 26, 1.1), "O": (2.01, 24, 2.35), "CB": (3.3, -18, 0.2)}
    lines = []
    for i in range(residues):
        for name, (radius, angle, height) in backbone.items():
            turn = np.radians(angle + 100 * i)
            lines.append("ATOM  %5d  %-3s ALA A%4d    %8.3f%8.3f%8.3f  1.00  0.00           %s" % (
                len(lines) + 1, name, i + 1, radius * np.cos(turn), radius * np.sin(turn), height + 1.5 * i, name[0]))
    path.write_text("\n".join([*lines, "END", ""]))
    return path


def write_xsf(path):
    """Rock salt."""
    path.write_text("CRYSTAL\nPRIMVEC\n0 2.82 2.82\n2.82 0 2.82\n2.82 2.82 0\nPRIMCOORD\n2 1\n11 0 0 0\n17 2.82 2.82 2.82\n")
    return path


def write_v_sim(path):
    """Two kinds of atoms on a grid."""
    cells = [(i, j, k) for i in range(4) for j in range(3) for k in range(2)]
    atoms = ["%d %d %d %s" % (2 * i + 1, 2 * j + 1, 3 * k + 1, ("Si", "O")[(i + j + k) % 2]) for i, j, k in cells]
    path.write_text("\n".join(["a grid", "8 0 8", "0 0 8", *atoms]) + "\n")
    return path


def write_evolver(path):
    """A cube whose surface is to shrink, and the commands that make a ball of it."""
    corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    edges = [(1, 2), (2, 3), (3, 4), (4, 1), (5, 6), (6, 7), (7, 8), (8, 5), (1, 5), (2, 6), (3, 7), (4, 8)]
    faces = [(1, 10, -5, -9), (2, 11, -6, -10), (3, 12, -7, -11), (4, 9, -8, -12), (5, 6, 7, 8), (-4, -3, -2, -1)]
    numbered = lambda rows: [" ".join(map(str, (number, *row))) for number, row in enumerate(rows, 1)]
    path.write_text("\n".join(["vertices", *numbered(corners), "edges", *numbered(edges), "faces", *numbered(faces),
                               "bodies", "1 1 2 3 4 5 6 volume 1"]) + "\n")
    commands = path.with_suffix(".commands")
    commands.write_text("r; r; g 5; r; g 10\ns\nq\n")
    return path, commands
