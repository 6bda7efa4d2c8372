"""A camera path for osgviewer -p: once around a mesh; and the bounds of a mesh."""
import array
import math
import pathlib


def ply_bounds(path):
    """(low, high) corners of the vertices of a PLY written by gluray-bench-mesh: x y z nx ny nz as little-endian floats."""
    data = pathlib.Path(path).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    count = next(int(line.split()[2]) for line in data[:end].split(b"\n") if line.startswith(b"element vertex"))
    floats = array.array("f")
    floats.frombytes(data[end:end + 24 * count])
    axes = [floats[axis::6] for axis in range(3)]
    return [min(a) for a in axes], [max(a) for a in axes]


def quaternion(right, up, back):
    """Unit quaternion (x, y, z, w) of the rotation that takes the axes x, y, z to `right`, `up`, `back`."""
    trace = right[0] + up[1] + back[2]
    w = math.sqrt(max(0.0, 1 + trace)) / 2
    x = math.copysign(math.sqrt(max(0.0, 1 + right[0] - up[1] - back[2])) / 2, up[2] - back[1])
    y = math.copysign(math.sqrt(max(0.0, 1 - right[0] + up[1] - back[2])) / 2, back[0] - right[2])
    z = math.copysign(math.sqrt(max(0.0, 1 - right[0] - up[1] + back[2])) / 2, right[1] - up[0])
    return x, y, z, w


def orbit(low, high, seconds, steps=72):
    """Lines of a path once around the box in `seconds`, z up, from a little above; each line: time, eye, rotation."""
    centre = [(a + b) / 2 for a, b in zip(low, high)]
    distance = 3.2 * math.dist(low, high) / 2
    lift = math.radians(15)
    lines = []
    for step in range(steps + 1):
        turn = 2 * math.pi * step / steps
        back = (math.cos(lift) * math.sin(turn), -math.cos(lift) * math.cos(turn), math.sin(lift))
        right = (math.cos(turn), math.sin(turn), 0.0)
        up = (-math.sin(lift) * math.sin(turn), math.sin(lift) * math.cos(turn), math.cos(lift))
        eye = [c + distance * b for c, b in zip(centre, back)]
        numbers = [seconds * step / steps, *eye, *quaternion(right, up, back)]
        lines.append(" ".join(f"{number:.6f}" for number in numbers))
    return lines
