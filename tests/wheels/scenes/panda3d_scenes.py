"""Pictures by Panda3D, without a window."""
import math
import sys

from direct.showbase.ShowBase import ShowBase
from panda3d.core import (AmbientLight, DirectionalLight, Filename, Fog, Geom, GeomNode, GeomTriangles, GeomVertexData, GeomVertexFormat, GeomVertexWriter,
                          PNMImage, PointLight, TexGenAttrib, Texture, TextureStage, loadPrcFileData)

import scene_list

loadPrcFileData("", "load-display pandagl\nwin-size 500 400\naudio-library-name null")


def torus(colored=False, n=120, m=60):
    data = GeomVertexData("torus", GeomVertexFormat.getV3n3c4() if colored else GeomVertexFormat.getV3n3(), Geom.UHStatic)
    position, normal = GeomVertexWriter(data, "vertex"), GeomVertexWriter(data, "normal")
    color = GeomVertexWriter(data, "color") if colored else None
    triangles = GeomTriangles(Geom.UHStatic)
    for i in range(n):
        for j in range(m):
            u, v = 2 * math.pi * i / n, 2 * math.pi * j / m
            position.addData3((1 + 0.4 * math.cos(v)) * math.cos(u), (1 + 0.4 * math.cos(v)) * math.sin(u), 0.4 * math.sin(v))
            normal.addData3(math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
            if color:
                color.addData4(i / n, j / m, 0.5, 1)
            a, b, c, d = ((i + k) % n * m + (j + l) % m for k, l in ((0, 0), (1, 0), (1, 1), (0, 1)))
            triangles.addVertices(a, b, c)
            triangles.addVertices(a, c, d)
    geometry = Geom(data)
    geometry.addPrimitive(triangles)
    node = GeomNode("torus")
    node.addGeom(geometry)
    return node


def lit(base):
    sun, sky = DirectionalLight("sun"), AmbientLight("sky")
    sun.setColor((0.8, 0.8, 0.7, 1))
    sky.setColor((0.3, 0.3, 0.3, 1))
    for light, angles in ((sun, (-30, -60, 0)), (sky, (0, 0, 0))):
        place = base.render.attachNewNode(light)
        place.setHpr(*angles)
        base.render.setLight(place)


def lamp(base, _):
    light = PointLight("lamp")
    light.setColor((1, 0.5, 0.5, 1))
    place = base.render.attachNewNode(light)
    place.setPos(0, -2, 2)
    base.render.setLight(place)


def fog(base, _):
    haze = Fog("haze")
    haze.setColor(0.5, 0.6, 0.7)
    haze.setLinearRange(2, 6)
    base.render.setFog(haze)


def translucent(_, node):
    node.setTransparency(True)
    node.setAlphaScale(0.5)


def mirrored(_, node):
    image = PNMImage(64, 64)
    for x in range(64):
        for y in range(64):
            image.setXel(x, y, (x // 8 + y // 8) % 2, 0.5, 0.5)
    texture = Texture()
    texture.load(image)
    node.setTexture(texture)
    node.setTexGen(TextureStage.getDefault(), TexGenAttrib.MEyeSphereMap)


def shown(change=lambda base, node: None, colored=False, lights=True):
    """`change` gets the engine and the torus."""
    def draw(file):
        base = ShowBase(windowType="offscreen")
        node = base.render.attachNewNode(torus(colored))
        if lights:
            lit(base)
        change(base, node)
        base.camera.setPos(0, -4, 2)
        base.camera.lookAt(0, 0, 0)
        for _ in range(3):
            base.graphicsEngine.renderFrame()
        base.win.saveScreenshot(Filename(file))
        base.destroy()
    return draw


SCENES = {
    "mesh": shown(),
    "vertex colours": shown(colored=True),
    "unlit": shown(lights=False),
    "light at a point": shown(lamp),
    "fog": shown(fog),
    "opacity": shown(translucent),
    "spherical map": shown(mirrored),
    "generated shaders": shown(lambda base, _: base.render.setShaderAuto()),
}

if __name__ == "__main__":
    sys.exit(scene_list.main(SCENES, __doc__))
