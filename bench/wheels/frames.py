"""Frames of a mesh of 500,000 triangles that turns, by one library of PyPI.

Prints a line of JSON: the median time of a frame after WARM others, and the triangles.
"""
import json
import os
import pathlib
import statistics
import sys
import time

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("library", help="a library that turning_meshes.py names")
    parser.add_argument("warm", type=int)
    parser.add_argument("frames", type=int)
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
import turning_meshes  # noqa: E402


def main():
    if OPTIONS.library not in turning_meshes.LIBRARIES:
        sys.exit(f"frames.py: unknown library {OPTIONS.library!r}; use one of {', '.join(turning_meshes.LIBRARIES)}")
    frame = turning_meshes.LIBRARIES[OPTIONS.library]()
    seconds = []
    for number in range(OPTIONS.warm + OPTIONS.frames):
        begin = time.perf_counter()
        frame(number)
        seconds.append(time.perf_counter() - begin)
    triangles = len(turning_meshes.torus()[2])
    print(json.dumps({"triangles": triangles, "first_image_s": seconds[0], "frame_s": statistics.median(seconds[OPTIONS.warm:])}), flush=True)
    os._exit(0)  # some libraries fail when they end


if __name__ == "__main__":
    main()
