"""A ring and two isosurfaces drawn by Mayavi's mlab into a window, without any toolkit's controls around it."""
import time

import numpy as np
from traits.etsconfig.api import ETSConfig

ETSConfig.toolkit = "null"
from mayavi import mlab  # noqa: E402

mlab.options.offscreen = True
figure = mlab.figure(size=(600, 600), bgcolor=(0.1, 0.15, 0.25))
window = figure.scene.render_window
window.off_screen_rendering = False  # shows the window that it has anyway
window.position = (20, 20)

u, v = np.mgrid[0:2 * np.pi:200j, 0:2 * np.pi:40j]
r = 1 + 0.3 * np.cos(v)
mlab.mesh(r * np.cos(u), r * np.sin(u), 0.3 * np.sin(v), scalars=np.sin(3 * u))
x, y, z = np.mgrid[-1:1:40j, -1:1:40j, -1:1:40j]
mlab.contour3d(x, y, z, x * x + 2 * y * y + z * z, contours=[0.3, 0.5])
mlab.colorbar(title="height")
mlab.view(40, 60, 5)
figure.scene.render()
time.sleep(1000)
