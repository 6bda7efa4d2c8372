"""Draws a group of vispy's states into a file of numpy. For volume_states.py and mesh_states.py."""
import sys

import numpy as np
from vispy import app, scene

SIZE = (240, 200)
KEPT = []  # canvases: vispy would delete what belongs to them while another one is drawn


def picture(draw):
    canvas = scene.SceneCanvas(keys=None, size=SIZE, show=True, bgcolor=(0.2, 0.3, 0.4, 1))
    draw(canvas, canvas.central_widget.add_view())
    canvas.app.process_events()
    image = canvas.render()
    canvas.close()
    KEPT.append(canvas)
    return image


def main(groups):
    """`groups`: the states by group and name. Options: the group, the file (none: prints the names), states (all)."""
    try:
        app.use_app("pyqt6")
    except (ValueError, RuntimeError):  # version 0.6 knows no Qt 6
        app.use_app("pyqt5")
    group, file, names = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None, sys.argv[3:]
    chosen = groups[group]
    if not file:
        return print("\n".join(chosen))
    np.savez(file, **{name: picture(chosen[name]) for name in (names or chosen)})
