"""Pictures by MuJoCo's renderer, without a window."""
import os
import sys

os.environ.setdefault("MUJOCO_GL", "egl")

import mujoco  # noqa: E402
from PIL import Image  # noqa: E402

import scene_list  # noqa: E402

WORLD = """
<mujoco>
  <asset>
    <texture name="floor" type="2d" builtin="checker" rgb1=".2 .3 .4" rgb2=".1 .2 .3" width="300" height="300"/>
    <material name="floor" texture="floor" texrepeat="5 5" reflectance="{reflectance}"/>
    <texture type="skybox" builtin="gradient" rgb1=".4 .6 .8" rgb2="0 0 0" width="32" height="512"/>
  </asset>
  <worldbody>
    <light pos="0 0 4" dir="0 0 -1" directional="{directional}" castshadow="{shadow}"/>
    <geom type="plane" size="3 3 .1" material="floor"/>
    <geom type="sphere" size=".4" pos="0 0 .6" rgba="1 .4 .1 1"/>
    <geom type="box" size=".3 .2 .5" pos="1 .3 .5" rgba=".2 .8 .3 {opacity}"/>
    <geom type="capsule" size=".2 .5" pos="-1 0 .8" rgba=".3 .4 .9 1"/>
    <geom type="cylinder" size=".2 .5" pos="0 1 .5" rgba=".9 .9 .2 1"/>
    <geom type="ellipsoid" size=".3 .5 .2" pos="0 -1 .4"/>
  </worldbody>
</mujoco>"""


def shown(reflectance=0, directional="false", shadow="false", opacity=1, segmented=False):
    def draw(file):
        model = mujoco.MjModel.from_xml_string(WORLD.format(reflectance=reflectance, directional=directional, shadow=shadow, opacity=opacity))
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        camera = mujoco.MjvCamera()
        camera.distance, camera.azimuth, camera.elevation, camera.lookat[:] = 4.5, 140, -25, (0, 0, 0.4)
        renderer = mujoco.Renderer(model, 400, 500)
        renderer.update_scene(data, camera)
        if segmented:
            renderer.enable_segmentation_rendering()
            pixels = (20 * renderer.render()[:, :, 0] + 40).astype("u1")
        else:
            pixels = renderer.render()
        Image.fromarray(pixels).convert("RGB").save(file)
    return draw


SCENES = {
    "bodies": shown(),
    "directional light": shown(directional="true"),
    "shadow map": shown(shadow="true"),
    "mirror": shown(reflectance=0.3),
    "opacity": shown(opacity=0.4),
    "segmentation": shown(segmented=True),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
