"""What a program draws: its objects keep their numbers, a pixel tells which of them it shows, and materials follow them:
objects_test.py GLURAY CLIENT, with a display."""
import base64
import unittest

from linked import Linked

LEFT = "4 -0.5 0 0.3 0 0 cc0000"
RIGHT = "6 0.5 0 0.3 0.5 0 00cc00"
BEHIND = "2 0.5 0 0.45 -1 0 0000cc"
ALL = ";".join([LEFT, RIGHT, BEHIND])
PATHS = ("--set", "integrator=path", "--set", "refine.idle=off", "--set", "environment=constant")


class Objects(Linked):
    def draw(self, line=ALL):
        print(line, file=self.client.stdin, flush=True)
        return self.client.stdout.readline().strip()

    def frame(self):
        return self.draw(self.shown)

    def settled(self):
        self.frame()

    def shown_by(self, *options, **variables):
        """The hub of a program that has drawn."""
        self.shown = ALL
        return self.linked(*options, **variables)

    def value(self, hub, name, **arguments):
        return hub.ask("call", name=name, arguments=arguments)["value"]

    def objects(self, hub, line):
        self.draw(line)
        return self.value(hub, "objects")["objects"]

    def numbers(self, hub, line):
        """By colour."""
        return {o["color"]: o["object"] for o in self.objects(hub, line)}

    def test_objects_say_what_they_are(self):
        hub = self.shown_by()
        answer = self.value(hub, "objects")
        self.assertEqual(answer["total"], 3)
        red, green, blue = answer["objects"]
        self.assertEqual([o["object"] for o in answer["objects"]], [1, 2, 3])
        self.assertEqual((red["color"], green["color"], blue["color"]), ("#cc0000", "#00cc00", "#0000cc"))
        self.assertEqual((red["triangles"], green["triangles"], blue["triangles"]), (32, 72, 8))
        self.assertEqual((red["shape"], red["view"], red["lit"], red["translucent"], red["material"], red["hidden"]),
                         ("triangles", 1, True, False, "program", []))
        for got, wanted in zip(green["lower"] + green["upper"], (0.2, -0.3, 0.47, 0.8, 0.3, 0.53)):
            self.assertAlmostEqual(got, wanted, 5)
        self.assertIs(self.value(hub, "objects", known=answer["version"]).get("same"), True)
        pages = [self.value(hub, "objects", after=after, count=1)["objects"] for after in (0, 1, 3)]
        self.assertEqual([[o["object"] for o in page] for page in pages], [[1], [2], []])

    def test_they_keep_their_numbers(self):
        hub = self.shown_by()
        first = self.numbers(hub, ALL)
        version = self.value(hub, "objects")["version"]
        self.assertEqual(self.numbers(hub, ALL.replace("cc0000", "dd0000"))["#dd0000"], first["#cc0000"])
        self.assertNotEqual(self.value(hub, "objects")["version"], version)
        self.assertEqual(self.numbers(hub, ";".join([LEFT, BEHIND])), {c: n for c, n in first.items() if c != "#00cc00"})
        self.assertEqual(self.numbers(hub, ALL), first)
        later = ALL.replace("4 -0.5 0 0.3 0 0", "4 -0.5 0 0.3 0 0.2").replace("6 0.5 0 0.3 0.5 0", "7 0.5 0 0.3 0.5 0.1")
        self.assertEqual(self.numbers(hub, later), first)
        more = self.numbers(hub, later + ";5 0 0.8 0.1 0 0 ffffff")
        self.assertEqual(more.pop("#ffffff"), 4)
        self.assertEqual(more, first)

    def test_a_pixel_tells_what_it_shows(self):
        hub = self.shown_by()
        numbers = self.numbers(hub, ALL)
        found = self.value(hub, "pick", x=50, y=100)
        self.assertEqual((found["object"], found["view"]), (numbers["#cc0000"], 1))
        for got, wanted in zip(found["position"] + found["normal"], (-0.495, -0.005, 0.0005, -0.099504, 0, 0.995037)):
            self.assertAlmostEqual(got, wanted, 4)
        self.assertAlmostEqual(found["distance"], 3.9995, 4)
        self.assertEqual(found["share"], [50.5 / 200, 99.5 / 200])
        self.assertEqual(self.value(hub, "pick", x=150, y=100)["object"], numbers["#00cc00"])
        self.assertEqual(self.value(hub, "pick", x=150, y=60)["object"], numbers["#0000cc"])
        self.assertEqual(self.value(hub, "pick", x=75, y=50, width=100, height=100)["object"], numbers["#00cc00"])
        self.assertIsNone(self.value(hub, "pick", x=100, y=10)["object"])
        for wrong in ({}, {"x": 5}, {"x": -1, "y": 0}, {"x": 5, "y": 201}, {"x": "5", "y": 5}, {"x": 5, "y": 5, "width": 0}):
            self.assertIn("use a number from", hub.ask("call", name="pick", arguments=wrong)["why"])

    def test_lights_and_cameras(self):
        hub = self.shown_by()
        (light,) = self.value(hub, "lights")["lights"]
        self.assertEqual((light["name"], light["from"], light["kind"], light["color"]), ("program 1", "program", "directional", "#ffffff"))
        self.assertEqual(light["direction"], [0, 0, 1])
        (camera,) = self.value(hub, "cameras")["cameras"]
        self.assertEqual((camera["projection"], camera["viewport"], camera["triangles"]), ("parallel", [0, 0, 200, 200], 112))
        self.assertAlmostEqual(camera["height"], 2, 5)
        self.assertAlmostEqual(camera["position"][2], 4, 5)
        self.set(hub, values={"lights": "three-point", "lights.azimuth": 10, "lights.elevation": 20})
        key = self.value(hub, "lights")["lights"][0]
        self.assertEqual((key["name"], key["from"]), ("key", "rig"))
        self.assertAlmostEqual(key["azimuth"], 10, 3)
        self.assertAlmostEqual(key["elevation"], 20, 3)
        at = self.value(hub, "highlight", x=50, y=100)
        self.assertAlmostEqual(at["azimuth"], -11.4212, 3)  # twice the angle of the surface
        self.assertAlmostEqual(at["elevation"], 0, 3)

    def pixel(self, hub, x, y):
        id = hub.start("call", name="shot", arguments={})
        hub.ask("get", names=["ao"])
        self.frame()
        shot = hub.result(id)["value"]
        piece = hub.ask("call", name="pixels", arguments={"shot": shot["shot"], "row": y})["value"]
        row = base64.b64decode(piece["pixels"])
        return tuple(row[3 * x:3 * x + 3])

    def test_materials_follow_their_objects(self):
        hub = self.shown_by(*PATHS)
        red = self.numbers(hub, ALL)["#cc0000"]
        before = self.pixel(hub, 50, 100), self.pixel(hub, 150, 100)
        answer = self.set(hub, values={"material.objects": [f"{red} emissive emission=5"]})
        self.assertEqual(answer["values"]["material.objects"], [f"{red} emissive emission=5"])
        self.assertEqual({o["object"]: o["material"] for o in self.value(hub, "objects")["objects"]},
                         {1: "program", 2: "program", 3: "program"} | {red: "emissive"})
        glows = self.pixel(hub, 50, 100)
        self.assertGreater(glows[0], before[0][0])
        self.assertEqual(glows[0], 255)
        self.shown = ALL.replace("cc0000", "00cccc").replace("4 -0.5 0 0.3 0 0", "5 -0.5 0 0.3 0 0.2")
        recolored = self.pixel(hub, 50, 100)
        self.assertEqual((recolored[0], recolored[1]), (0, 255))
        self.set(hub, values={"material.objects": []})
        self.shown = ALL
        for got, wanted in zip(self.pixel(hub, 50, 100) + self.pixel(hub, 150, 100), before[0] + before[1]):
            self.assertAlmostEqual(got, wanted, delta=3)  # both are averages of few paths

    def test_objects_can_be_hidden(self):
        hub = self.shown_by()
        numbers = self.numbers(hub, ALL)
        self.assertLess(self.pixel(hub, 150, 100)[2], 50)
        self.set(hub, values={"material.objects": [f"{numbers['#00cc00']} hidden-from=all"]})
        self.assertGreater(self.pixel(hub, 150, 100)[2], 100)  # what is behind
        self.assertEqual(self.value(hub, "pick", x=150, y=100)["object"], numbers["#0000cc"])
        hidden = [o for o in self.value(hub, "objects")["objects"] if o["hidden"]]
        self.assertEqual([(o["object"], o["hidden"]) for o in hidden],
                         [(numbers["#00cc00"], ["camera", "shadow", "occlusion", "reflection"])])

    def test_wrong_entries_are_refused(self):
        hub = self.shown_by()
        why = hub.ask("set", values={"material.objects": ["1 glas"]})["why"]
        self.assertIn("object 1: 'glas'", why)
        self.assertEqual(hub.ask("get", names=["material.objects"])["values"]["material.objects"]["value"], [])

    def test_a_program_that_the_real_opengl_draws_says_so(self):
        hub = self.shown_by("--engine", "never")
        self.assertEqual(hub.ask("call", name="objects", arguments={})["why"], "engine = never: the real OpenGL draws everything")

    def test_windows_of_egl_are_known_and_woken(self):
        hub = self.shown_by(CLIENT_EGL="1")
        self.assertEqual(self.value(hub, "objects")["total"], 3)
        hub.ask("observe", what=["state"], every=1)
        self.assertEqual(hub.event("state")["state"]["windows"], [{"width": 200, "height": 200}])
        shot = self.value(hub, "shot")  # the program draws nothing
        self.assertEqual((shot["width"], shot["height"]), (200, 200))
        self.assertEqual(self.value(hub, "pick", x=150, y=100)["object"], 2)

    def test_small_scenes_are_traced_while_somebody_asks(self):
        hub = self.shown_by("--engine", "auto", GLURAY_ENGINE="auto")
        for _ in range(30):
            self.frame()
        self.assertEqual(self.value(hub, "objects")["total"], 3)


if __name__ == "__main__":
    unittest.main(argv=["objects_test.py", "-v"])
