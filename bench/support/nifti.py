"""A NIfTI-1 scan as a MetaImage, which ParaView reads without plugins. Run with an interpreter that has numpy.
"""
import gzip
import pathlib
import struct
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from options import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("scan", type=pathlib.Path, metavar="SCAN.nii[.gz]")
    parser.add_argument("out", type=pathlib.Path, metavar="OUT.mhd")
    parser.add_argument("smooth", nargs="?", type=int, default=2,
                        help="passes of a (1 2 1)/4 filter along each axis, so that surfaces of a scan of small integers have no steps (2)")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import numpy  # noqa: E402

TYPES = {2: "u1", 4: "i2", 8: "i4", 16: "f4", 64: "f8", 256: "i1", 512: "u2"}


def read(path):
    """(values as a [z, y, x] array of floats, spacing x y z in millimetres)."""
    data = path.read_bytes()
    if data[:2] == b"\x1f\x8b":
        data = gzip.decompress(data)
    order = "<" if struct.unpack_from("<i", data)[0] == 348 else ">"
    if struct.unpack_from(order + "i", data)[0] != 348:
        raise ValueError(f"{path} is not a NIfTI-1 file")
    width, height, depth = struct.unpack_from(order + "8h", data, 40)[1:4]
    kind = struct.unpack_from(order + "h", data, 70)[0]
    if kind not in TYPES:
        raise ValueError(f"{path} holds values of type {kind}, which is not read here")
    spacing = struct.unpack_from(order + "8f", data, 76)[1:4]
    start = int(struct.unpack_from(order + "f", data, 108)[0])
    values = numpy.frombuffer(data, order + TYPES[kind], width * height * depth, start)
    return values.reshape(depth, height, width).astype("f4"), spacing


def smoothed(values, passes):
    for _ in range(passes):
        for axis in range(3):
            before, after = numpy.roll(values, 1, axis), numpy.roll(values, -1, axis)
            values = 0.25 * before + 0.5 * values + 0.25 * after
    return values


def main(scan, header, passes):
    values, spacing = read(scan)
    values = smoothed(values, passes)
    raw = header.with_suffix(".raw")
    raw.write_bytes(values.astype("<f4").tobytes())
    depth, height, width = values.shape
    header.write_text(f"ObjectType = Image\nNDims = 3\nDimSize = {width} {height} {depth}\n"
                      f"ElementSpacing = {spacing[0]} {spacing[1]} {spacing[2]}\nElementType = MET_FLOAT\n"
                      f"ElementByteOrderMSB = False\nElementDataFile = {raw.name}\n")


main(OPTIONS.scan, OPTIONS.out, OPTIONS.smooth)
