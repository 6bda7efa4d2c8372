"""Volumes of vispy's scene graph, each as one picture.

volume_states.py GROUP FILE [STATE ...]  draws the states of a group, "traced" or "untraced", into a file of numpy
"""
import inspect

import numpy as np
from drawing import main
from vispy import scene
from vispy.color import Colormap
from vispy.visuals.volume import VolumeVisual


def blob(kind=np.float32, shape=(20, 26, 32)):
    """A ball of two densities with waves, from 0 to 1 or to the largest number of bytes and words."""
    z, y, x = (np.linspace(-1, 1, n) for n in shape)
    r2 = x[None, None, :] ** 2 + y[None, :, None] ** 2 + z[:, None, None] ** 2
    values = np.exp(-3 * r2) * (0.75 + 0.25 * np.sin(9 * x[None, None, :] + 5 * y[None, :, None] * z[:, None, None]))
    return values.astype(kind) if kind == np.float32 else (values * np.iinfo(kind).max).astype(kind)


FAINT = Colormap([(0, 0, 0, 0), (0.9, 0.2, 0.1, 0.03), (0.3, 0.9, 0.9, 0.2), (1, 1, 1, 0.6)])
STEPS = Colormap(["r", "g", "b", "y"], interpolation="zero")


def volume(data=None, parallel=False, inside=False, moved=False, blending=None, behind="", **keys):
    def draw(canvas, view):
        made = scene.visuals.Volume(blob() if data is None else data, parent=view.scene, **keys)
        if moved:
            made.transform = scene.transforms.STTransform(scale=(1, 1.4, 2), translate=(3, 2, 1))
        if blending:
            made.set_gl_state(blending)
        if behind:
            made.order = 1
            box = scene.visuals.Box(18, 18, 18, color=(0.2, 0.7, 0.3, 1), parent=view.scene)
            if behind != "offset":
                box.mesh.set_gl_state(polygon_offset_fill=False, depth_test=True, cull_face=False)
            box.transform = scene.transforms.STTransform(translate=(30, 20, 12))
        view.camera = scene.TurntableCamera(fov=0 if parallel else 50, azimuth=35, elevation=25, distance=8 if inside else 70, center=(15, 12, 9))
        if parallel:
            view.camera.scale_factor = 45
    return draw


def turned(canvas, view):
    volume(method="mip")(canvas, view)
    view.camera.azimuth = 120


PLANES = [[[16, 12, 9], [1, 0.3, 0]], [[16, 12, 9], [0, 1, 0.5]]]

# Those of every version.
STATES = {"mip": volume(method="mip"), "additive": volume(method="additive", cmap=FAINT), "translucent": volume(method="translucent", cmap=FAINT),
          "mip, fire": volume(method="mip", cmap="fire"), "mip, ice": volume(method="mip", cmap="ice"), "mip, hot": volume(method="mip", cmap="hot"),
          "additive, viridis": volume(method="additive", cmap="viridis"), "mip, viridis": volume(method="mip", cmap="viridis"), "parallel": volume(method="mip", parallel=True), "inside": volume(method="mip", inside=True),
          "moved": volume(method="mip", moved=True), "long steps": volume(method="mip", relative_step_size=2.3), "short steps": volume(method="translucent", cmap=FAINT, relative_step_size=0.3),
          "behind a box": volume(method="translucent", cmap=FAINT, behind="box"), "additive blending": volume(method="mip", blending="additive"),
          "opaque": volume(method="mip", blending="opaque"), "turned": turned, "translucent, opaque map": volume(method="translucent", cmap="winter")}
# Those of 0.14 and later.
NEWER = {"iso": volume(method="iso", threshold=0.4), "iso, parallel": volume(method="iso", threshold=0.3, parallel=True, cmap="viridis"),
         "minip": volume(data=1 - blob(), method="minip"), "average": volume(method="average", cmap="fire"),
         "attenuated": volume(method="attenuated_mip", attenuation=0.6), "nearest": volume(method="mip", interpolation="nearest"),
         "nearest iso": volume(method="iso", threshold=0.4, interpolation="nearest"), "steps": volume(method="mip", cmap=STEPS),
         "gamma": volume(method="mip", gamma=0.6), "limits": volume(method="translucent", cmap=FAINT, clim=(0.2, 0.7)),
         "bytes": volume(data=blob(np.uint8), method="mip", texture_format="auto"), "words": volume(data=blob(np.uint16), method="additive", cmap=FAINT, texture_format="auto"),
         "floats": volume(method="mip", texture_format="auto", clim=(0.1, 0.8)), "floats, iso": volume(method="iso", threshold=0.4, texture_format="auto"),
         "clipped": volume(method="mip", clipping_planes=PLANES), "clipped, moved": volume(method="average", clipping_planes=PLANES, moved=True, clipping_planes_coord_system="visual"),
         "behind a box with an offset": volume(method="mip", behind="offset"), "iso around a box": volume(method="iso", threshold=0.2, behind="offset"), "cutoffs": volume(method="mip", mip_cutoff=0.4), "words, minip": volume(data=np.iinfo(np.uint16).max - blob(np.uint16), method="minip", texture_format="auto")}
# Left to the real OpenGL.
UNTRACED = {"plane": volume(method="mip", raycasting_mode="plane", plane_position=(10, 13, 16), plane_normal=(1, 1, 0), plane_thickness=4),
            "cubic": volume(method="mip", interpolation="cubic")}



def groups():
    """The states that are traced, and those that are not, of this version."""
    newer = "clipping_planes" in inspect.signature(VolumeVisual.__init__).parameters
    return {"traced": STATES | (NEWER if newer else {}), "untraced": UNTRACED if newer else {}}


if __name__ == "__main__":
    main(groups())
