"""Pictures by vedo."""
import sys

import numpy as np
import vedo

import scene_list

vedo.settings.default_backend = "vtk"


def shown(*makers):
    def draw(file):
        plotter = vedo.Plotter(offscreen=True, size=(500, 400))
        plotter.show(*[make() for make in makers], interactive=False)
        plotter.screenshot(file)
        plotter.close()
    return draw


def torus():
    return vedo.Torus(r1=1, r2=0.35, res=80)


SCENES = {
    "mesh": shown(torus),
    "scalars": shown(lambda: torus().cmap("viridis", torus().vertices[:, 2])),
    "scalars of cells": shown(lambda: torus().cmap("jet", torus().cell_centers().points[:, 0], on="cells")),
    "wireframe": shown(lambda: torus().wireframe()),
    "edges": shown(lambda: torus().linewidth(1)),
    "flat": shown(lambda: torus().flat()),
    "glossy": shown(lambda: torus().lighting("glossy").c("red5")),
    "unlit": shown(lambda: torus().lighting("off").c("red5")),
    "opacity": shown(lambda: torus().alpha(0.4)),
    "points": shown(lambda: vedo.Points(np.random.default_rng(1).random((300, 3)), r=8)),
    "spheres": shown(lambda: vedo.Spheres(np.random.default_rng(1).random((100, 3)), r=0.03)),
    "arrows": shown(lambda: vedo.Arrows(np.zeros((20, 3)), np.random.default_rng(1).random((20, 3)))),
    "lines": shown(lambda: vedo.Line(np.random.default_rng(1).random((20, 3)), lw=3)),
    "tubes": shown(lambda: vedo.Tube(np.random.default_rng(1).random((8, 3)), r=0.03)),
    "text": shown(torus, lambda: vedo.Text2D("a torus")),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
