"""Compares volumes of vispy that GLuRay traces with those that the real OpenGL draws: equal to 2 of 255 but for silhouettes. Also those that it leaves to the real OpenGL.

Ends with 77 where vispy is not installed. Needs an X server of its own (tests/doors/with_display.py).
"""
import sys

import comparison

VOLUMES = comparison.Kind(__doc__, "volume_states", 12, "volume with state or values that are not traced")  # 12: the box of a volume

if __name__ == "__main__":
    sys.exit(comparison.main(VOLUMES))
