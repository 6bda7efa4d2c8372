"""Compares meshes of vispy that GLuRay traces with those that the real OpenGL draws: equal to 2 of 255 but for silhouettes. Also those that it leaves to the real OpenGL.

Ends with 77 where vispy is not installed. Needs an X server of its own (tests/doors/with_display.py).
"""
import sys

import comparison

MESHES = comparison.Kind(__doc__, "mesh_states", 12, "program with a value that its family does not cover")  # 12: a box

if __name__ == "__main__":
    sys.exit(comparison.main(MESHES))
