"""What a program of memory_hub.py draws: answers to objects, pick, highlight, lights, cameras."""


def an_object(number, **more):
    return {"object": number, "view": 1, "shape": "triangles", "triangles": 81920, "color": "#cc4400", "vertexColors": False, "lit": True,
            "translucent": False, "material": "program", "hidden": [], "lower": [0, 0, 0], "upper": [1, 1, 1], **more}


LIGHT = {"name": "key", "from": "rig", "kind": "directional", "direction": [0, 0, 1], "position": None, "azimuth": 30, "elevation": 45,
         "color": "#ffffff", "strength": 1, "size": 5}
LAMP = {"name": "light 0", "from": "program", "kind": "point", "direction": None, "position": [1, 2.5, -3], "azimuth": None, "elevation": None,
        "color": "#ffeedd", "strength": None, "size": None}
CAMERA = {"view": 1, "projection": "perspective", "angle": 30, "height": None, "position": [0, 0, 5], "direction": [0, 0, -1], "up": [0, 1, 0],
          "near": 0.1, "far": 100, "viewport": [1, 0, 4, 2], "triangles": 81920}
MAP = {**CAMERA, "view": 2, "projection": "parallel", "angle": None, "height": 2.5, "viewport": [0, 2, 1, 1], "triangles": 12}


class FakeScene:
    """Its image has 5 x 3 pixels. The left column shows nothing, the others show object 3."""

    def __init__(self):
        self.objects = [an_object(1), an_object(3, color=None, vertexColors=True, shape="spheres", triangles=12, material="glass", hidden=["camera", "shadow"]),
                        an_object(7, view=2, color=None)]
        self.lights, self.cameras = [LIGHT, LAMP], [CAMERA, MAP]
        self.most = 1000  # objects in an answer
        self.instead = {}  # by name of a call: its whole result

    def call(self, name, arguments, frame):
        """The program's result; None: it is no such call."""
        if name in self.instead:
            return self.instead[name]
        known = {"objects": self._objects, "pick": self._pick, "highlight": self._highlight,
                 "lights": lambda _: {"lights": self.lights}, "cameras": lambda _: {"cameras": self.cameras}}
        return {"value": {"frame": frame} | known[name](arguments)} if name in known else None

    def _objects(self, arguments):
        wanted = [one for one in self.objects if one["object"] > arguments.get("after", 0)]
        return {"version": 5, "total": len(self.objects), "objects": wanted[:min(self.most, arguments.get("count", 1000))]}

    def _pick(self, arguments):
        x, y = arguments["x"] * 5 / arguments.get("width", 5), arguments["y"] * 3 / arguments.get("height", 3)
        if x < 1:
            return {"object": None, "view": None, "share": None, "position": None, "normal": None, "distance": None}
        return {"object": 3, "view": 1, "share": [(x - 1) / 4, (3 - y) / 2], "position": [0.5, 0.25, -1e-7], "normal": [0, 0, 1], "distance": 5.25}

    def _highlight(self, arguments):
        found = self._pick(arguments)["object"]
        return {"object": found, "azimuth": found and 20.5, "elevation": found and -10.25}
