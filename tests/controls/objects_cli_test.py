"""Commands for what programs draw, with a hub that only pretends: objects_cli_test.py GLURAY."""
import json
import sys
import time
import unittest

from cli_case import CliCase
from fake_scene import CAMERA, LIGHT, an_object
from memory_hub import FakeProgram, seek_hub

SEVERAL = "several programs run; choose one with -p"


class Objects(CliCase):
    def one(self):
        hub = self.hub()
        return hub, hub.add("paraview", 4242)

    def test_objects(self):
        _, first, second = self.two()
        second.scene.objects = []
        lines = self.output("objects", "-p", "1").splitlines()
        self.assertEqual(lines, ["number  view  shape      triangles  color     material  hidden from",
                                 "     1     1  triangles     81 920  #cc4400   program   -",
                                 "     3     1  spheres           12  vertices  glass     camera+shadow",
                                 "     7     2  triangles     81 920  texture   program   -"])
        both = self.output("objects").splitlines()
        self.assertEqual((both[0], both[-2:]), ("paraview (4242):", ["vmd (77):", "no objects: nothing that it draws is traced"]))
        found = json.loads(self.output("objects", "--json"))
        self.assertEqual(found, [{"program": 1, "name": "paraview", "pid": 4242, "objects": first.scene.objects},
                                 {"program": 2, "name": "vmd", "pid": 77, "objects": []}])

    def test_long_lists_come_in_pages(self):
        _, program = self.one()
        program.scene.objects = [an_object(n) for n in range(2, 5002, 2)]
        self.assertEqual([one["object"] for one in json.loads(self.output("objects", "--json"))[0]["objects"]], list(range(2, 5002, 2)))
        self.assertEqual([arguments for _, arguments in program.calls], [{"after": after, "count": 1000} for after in (0, 2000, 4000)])
        program.scene.most = 700
        self.assertEqual(len(json.loads(self.output("objects", "--json"))[0]["objects"]), 2500)

    def test_wrong_objects(self):
        _, program = self.one()
        page = {"version": 1, "total": 1}
        for value, why in ((3, "'total' is missing"), ({}, "'total' is missing"), (page, "'objects' is missing"), (page | {"objects": 3}, "'objects' is no list"),
                           (page | {"objects": [3]}, "an entry is no object"), (page | {"objects": [{}]}, "'object' is missing"),
                           (page | {"objects": [an_object(0)]}, "'object' is no number of an object"), (page | {"objects": [an_object("x")]}, "'object' is no whole number"),
                           (page | {"objects": [an_object(2), an_object(1)]}, "objects are not in order"), (page | {"objects": [an_object(1 << 60)]}, "'object' is no"),
                           (page | {"objects": [an_object(1, shape=3)]}, "'shape' is no text"), (page | {"objects": [an_object(1, hidden="x")]}, "'hidden' is no list"),
                           (page | {"objects": [an_object(1, hidden=[7])]}, "'hidden' is no list of texts"), (page | {"objects": [an_object(1, triangles=-1)]}, "'triangles' is no"),
                           (page | {"objects": [an_object(1, vertexColors=None)]}, "'vertexColors' is neither true nor false")):
            program.scene.instead["objects"] = {"value": value}
            self.assertIn("paraview (4242): its answer cannot be read: " + why, self.failure("objects"))
        program.scene.instead["objects"] = {"why": "no frame was drawn\nfor 8 seconds"}
        self.assertEqual(self.failure("objects"), "paraview (4242): no frame was drawn\\nfor 8 seconds")

    def test_some_programs_fail(self):
        _, first, _ = self.two()
        first.scene.instead["objects"] = {"why": "busy"}
        done = self.run_gluray("objects", "--json")
        self.assertEqual((done.returncode, done.stderr), (1, "gluray: paraview (4242): busy\n"))
        self.assertEqual([list(one)[-1] for one in json.loads(done.stdout)], ["why", "program"])

    def test_pick(self):
        _, program = self.one()
        self.assertEqual(self.output("pick", "2", "1.5"), "paraview (4242): object 3 in view 1 at 0.5 0.25 -1e-07, normal 0 0 1, distance 5.25\n")
        self.assertEqual(self.output("pick", "50%", "0%"), self.output("pick", "2", "0"))
        self.assertEqual(self.output("pick", "0", "2"), "paraview (4242): nothing is there\n")
        self.assertEqual([arguments for _, arguments in program.calls],
                         [{"x": 2, "y": 1.5}, {"x": 50, "y": 0, "width": 100, "height": 100}, {"x": 2, "y": 0}, {"x": 0, "y": 2}])
        self.assertEqual(json.loads(self.output("pick", "--json", "2", "1")),
                         {"program": 1, "name": "paraview", "pid": 4242, "frame": 1042, "object": 3, "view": 1, "share": [0.25, 1],
                          "position": [0.5, 0.25, -1e-7], "normal": [0, 0, 1], "distance": 5.25})

    def test_commands_are_a_hub(self):
        program = FakeProgram(1, "paraview", 4242, self.ROWS)
        program.draws = 1
        self.addCleanup(seek_hub(program, self.folder / "run"))
        program.scene.objects = [an_object(n) for n in range(1, 2501)]
        self.assertEqual(len(json.loads(self.output("objects", "--json"))[0]["objects"]), 2500)
        self.assertIn("object 3 in view 1", self.output("pick", "2", "1"))
        self.output("material", "2000-2003", "--hide")
        self.assertEqual(program.live["material.objects"], [f"{n} hidden-from=all" for n in range(2000, 2004)])
        self.output("light", "at", "2", "1")
        self.output("film", "a.png", "--frames", "3", "--set", "spp=1..3")
        self.assertEqual(len(program.steps), 3)

    def test_wrong_points(self):
        hub, _, _ = self.two()
        for words in (("2",), ("2", "x"), ("101%", "5%"), ("5%", "5"), ("nan", "3"), ("1e9", "3"), ("", "3"), ("2", "3", "4"), (), ("-5", "3"), ("%", "3%")):
            for command in (("pick",), ("light", "at"), ("camera", "focus")):
                if words or command == ("pick",):
                    self.failure(*command, *words, code=2)
        self.assertEqual(hub.requests, [])
        for command in (("pick",), ("light", "at"), ("camera", "focus"), ("material",)):
            self.assertEqual(self.failure(*command, *(("2", "3") if command != ("material",) else ())), SEVERAL)

    def test_wrong_picks(self):
        _, program = self.one()
        good = {"object": 3, "view": 1, "share": [0, 1], "position": [0, 0, 0], "normal": [0, 0, 1], "distance": 5}
        for value in (7, {}, good | {"object": "x"}, good | {"position": [1, 2]}, good | {"position": [1, 2, "3"]}, good | {"normal": 3}, good | {"distance": []}, good | {"view": 1.5},
                      good | {"share": None}, good | {"share": [1]}, {name: good[name] for name in good if name != "share"}):
            program.scene.instead["pick"] = {"value": value}
            self.assertIn("paraview (4242): its answer cannot be read: ", self.failure("pick", "2", "3"))
        for share in (None, [1], "x", [1, None]):
            program.scene.instead["pick"] = {"value": good | {"share": share}}
            self.assertIn("paraview (4242): its answer cannot be read: 'share' is no", self.failure("camera", "focus", "2", "3"))
        self.assertEqual(program.steps, [])
        program.scene.instead["pick"] = {"why": "x is outside of the image"}
        self.assertEqual(self.failure("pick", "9", "3"), "paraview (4242): x is outside of the image")


class Lights(CliCase):
    one = Objects.one

    def test_lights(self):
        _, program = self.one()
        self.assertEqual(self.output("light").splitlines(), ["name     from     kind         azimuth  elevation  position  color    strength  size",
                                                             "key      rig      directional       30         45  -         #ffffff         1     5",
                                                             "light 0  program  point              -          -  1 2.5 -3  #ffeedd         -     -"])
        self.assertEqual(json.loads(self.output("light", "--json"))[0]["lights"], program.scene.lights)
        program.scene.lights = []
        self.assertEqual(self.output("light"), "no lights\n")
        for value in ({}, {"lights": 3}, {"lights": [LIGHT | {"azimuth": "x"}]}, {"lights": [LIGHT | {"position": [1]}]}, {"lights": [{}]}):
            program.scene.instead["lights"] = {"value": value}
            self.assertIn("paraview (4242): its answer cannot be read: ", self.failure("light"))

    def test_settings_have_short_names(self):
        _, first, second = self.two()
        self.assertEqual(self.output("light", "-p", "1", "azimuth=-30", "rig=sun"), "paraview (4242): lights = sun, lights.azimuth = -30 from frame 1042\n")
        self.assertEqual(first.live, {"lights.azimuth": -30, "lights": "sun"})
        self.output("light", "lights.elevation=10", "lights=sky", "strength=1.25")
        self.assertEqual(second.live, {"lights.elevation": 10, "lights": "sky", "lights.strength": 1.25})
        for words, line in ((["azimut=3"], "the group lights has no 'azimut'; did you mean 'azimuth'?"), (["lights.azimut=3"], "did you mean 'azimuth'?"),
                            (["shadows=on"], "the group lights has no 'shadows'; it has rig, attached, up, insets, azimuth"), (["azimuth"], "azimuth: use NAME=VALUE"),
                            (["azimuth=400"], "lights.azimuth = 400: use a number"), (["rig=moon"], "lights = moon: use program"), (["=3"], "has no ''")):
            self.assertIn(line, self.failure("light", *words, code=2))

    def test_light_at(self):
        _, program = self.one()
        self.assertEqual(self.output("light", "at", "2", "1"), "paraview (4242): lights = headlight+key, lights.azimuth = 20.5, lights.elevation = -10.25 from frame 1042\n"
                                                               "The program's own lights have no key light: lights = headlight+key is set, too.\n")
        self.assertEqual((program.live, len(program.steps)), ({"lights.azimuth": 20.5, "lights.elevation": -10.25, "lights": "headlight+key"}, 1))
        program.live = {"lights": "sky"}
        self.assertIn("lights = sky has no key light: lights = headlight+key is set, too.\n", self.output("light", "at", "2", "1"))
        self.assertEqual(program.live["lights"], "headlight+key")
        program.live = {"lights": "three-point"}
        self.assertEqual(self.output("light", "at", "50%", "50%"), "paraview (4242): lights.azimuth = 20.5, lights.elevation = -10.25 from frame 1042\n")
        self.assertEqual(program.live["lights"], "three-point")
        self.assertEqual(program.calls[-1], ("highlight", {"x": 50, "y": 50, "width": 100, "height": 100}))
        self.assertEqual(self.failure("light", "at", "0", "1"), "paraview (4242): nothing is there")
        self.assertEqual(len(program.steps), 3)
        program.scene.instead["highlight"] = {"value": {"object": 3, "azimuth": "x", "elevation": 1}}
        self.assertIn("'azimuth' is no number", self.failure("light", "at", "2", "1"))

    def test_cameras(self):
        _, program = self.one()
        self.assertEqual(self.output("camera").splitlines(), [
            "view  projection   opening     position  direction  near  far  viewport  triangles",
            "1     perspective  30 degrees  0 0 5     0 0 -1      0.1  100  1 0 4 2      81 920",
            "2     parallel     2.5 high    0 0 5     0 0 -1      0.1  100  0 2 1 1          12"])
        self.assertEqual(json.loads(self.output("camera", "--json"))[0]["cameras"], program.scene.cameras)
        program.scene.instead["cameras"] = {"value": {"cameras": [CAMERA | {"viewport": 7}]}}
        self.assertIn("'viewport' is no list of 4 numbers", self.failure("camera"))

    def test_camera_settings(self):
        _, program = self.one()
        self.assertEqual(self.output("camera", "aperture=0.1", "f-number=2.8"), "paraview (4242): camera.aperture = 0.1, camera.f-number = 2.8 from frame 1042\n")
        self.assertIn("did you mean 'aperture'?", self.failure("camera", "apertur=0.1", code=2))
        self.assertIn("the group camera has no 'camera'", self.failure("camera", "camera=0.1", code=2))
        self.assertIn("camera.aperture = -1", self.failure("camera", "aperture=-1", code=2))

    def test_focus(self):
        _, program = self.one()
        done = self.run_gluray("camera", "focus", "2", "2")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (0, 1))
        self.assertIn("gluray: the lens is closed", done.stderr)
        self.assertEqual(program.live, {"camera.focus": 0, "camera.focus-x": 0.25, "camera.focus-y": 0.5})
        self.assertEqual(program.calls, [("pick", {"x": 2, "y": 2})])
        program.live |= {"camera.f-number": 2.8}
        self.output("camera", "focus", "100%", "0%")
        self.assertEqual((program.live["camera.focus-x"], program.live["camera.focus-y"], len(program.steps)), (1, 1, 2))
        self.assertEqual(self.failure("camera", "focus", "0", "2"), "paraview (4242): nothing is there")
        self.assertEqual(program.calls[1], ("pick", {"x": 100, "y": 0, "width": 100, "height": 100}))


class Materials(CliCase):
    one = Objects.one

    def objects(self, program):
        return program.live.get("material.objects", [])

    def seen(self, *words):
        self.assertEqual(self.run_gluray("material", *words).returncode, 0, words)

    def test_material(self):
        _, program = self.one()
        program.live["integrator"] = "path"
        self.assertEqual(self.output("material", "3", "glass", "roughness=0.1"), "paraview (4242): material.objects = 3 glass roughness=0.1 from frame 1042\n")
        self.output("material", "1-3", "coat=0.5")
        self.assertEqual(self.objects(program), ["3 glass roughness=0.1 coat=0.5", "1 coat=0.5"])
        self.output("material", "3", "metal", "metal=Au", "--hide-from", "camera+shadow")
        self.output("material", "7", "1", "--hide")
        self.assertEqual(self.objects(program), ["3 metal metal=Au hidden-from=camera+shadow", "1 coat=0.5 hidden-from=all", "7 hidden-from=all"])
        self.assertEqual(self.output("material"), "1 coat=0.5 hidden-from=all\n3 metal metal=Au hidden-from=camera+shadow\n7 hidden-from=all\n")
        self.assertEqual(self.output("material", "3"), "3 metal metal=Au hidden-from=camera+shadow\n")
        self.assertEqual(self.output("material", "4"), "paraview (4242): no such object has an entry\n")
        self.assertEqual(json.loads(self.output("material", "1", "7", "--json")),
                         {"program": 1, "name": "paraview", "pid": 4242, "materials": {"1": "coat=0.5 hidden-from=all", "7": "hidden-from=all"}})
        self.output("material", "3", "7", "--show")
        self.assertEqual(self.objects(program), ["3 metal metal=Au", "1 coat=0.5 hidden-from=all"])
        self.output("material", "1-5", "--reset")
        self.assertEqual(self.objects(program), [])
        self.assertEqual(self.output("material"), "paraview (4242): no object has an entry\n")
        self.assertEqual(self.output("material", "all", "--reset"), "paraview (4242): nothing changes\n")
        self.output("material", "all", "matte", "--json")
        self.assertEqual(self.objects(program), ["1 matte", "3 matte", "7 matte"])
        self.output("undo")
        self.assertEqual(self.objects(program), [])

    def test_many_objects(self):
        _, program = self.one()
        program.scene.objects = [an_object(n) for n in range(1, 100001)]
        begin = time.monotonic()
        self.assertEqual(self.failure("material", "all", "glass"),
                         "paraview (4242): material.objects takes 16 KiB: 1590 of these 100000 objects fit")
        self.assertLess(time.monotonic() - begin, 30)
        self.assertEqual(program.steps, [])
        self.seen("1-1590", "glass")
        self.assertEqual(len(self.objects(program)), 1590)
        self.assertIn("0 of these 1 objects fit", self.failure("material", "1591", "glass"))
        self.seen("all", "--reset")
        self.assertEqual(self.objects(program), [])

    def test_files_that_hide_are_overruled(self):
        _, program = self.one()
        program.live["material.file"] = "/rules.toml"
        self.output("material", "3", "--show")
        self.assertEqual(self.objects(program), ["3 hidden-from=none"])

    def test_unseen_materials_are_told(self):
        _, program = self.one()
        done = self.run_gluray("material", "3", "glass")
        self.assertEqual((done.returncode, done.stderr), (0, "gluray: materials are seen with integrator = path or whitted; it is local\n"))
        self.output("material", "3", "matte", "--json")
        self.output("material", "3", "roughness=0.2")
        self.output("material", "3", "--hide")
        program.live["integrator"] = "whitted"
        self.output("material", "3", "mirror")

    def test_wrong_words(self):
        hub, _ = self.one()
        for words, line in ((("glass",), "no object given"), (("3", "gold"), "use program, matte"), (("3", "roughness=2"), "roughness=2: use a number from 0 to 1"),
                            (("3", "roughnes=1"), "did you mean 'roughness'?"), (("0", "glass"), "objects are numbers from 1"), (("5-3", "glass"), "objects are numbers from 1"),
                            (("--hide",), "no object given"), (("3", "--hide", "--show"), "--"), (("3", "--hide-from", "eye"), "hidden-from=eye: use all, none"),
                            (("3", "glass", "--reset"), "--reset takes objects alone"), (("3", "glass", "4"), "use program, matte"), (("3", "glass,7"), "use one word a value"),
                            (("3", "--reset", "--hide"), "--"), (("3", "file=x"), "objects have no 'file'")):
            self.assertIn(line, self.failure("material", *words, code=2))
        self.assertEqual(hub.requests, [])

    def test_unknown_objects(self):
        _, program = self.one()
        self.assertEqual(self.failure("material", "3", "5", "glass"), "paraview (4242): it draws no object 5; gluray objects shows them")
        self.assertEqual(self.failure("material", "10-20", "glass"), "paraview (4242): it draws no such objects; gluray objects shows them")
        self.assertEqual(self.objects(program), [])
        program.live["material.objects"] = 7
        self.assertIn("does not say what material.objects is", self.failure("material"))
        program.live["material.objects"] = ["5 glass", 3]
        self.assertIn("does not say what material.objects is", self.failure("material", "3", "glass"))
        program.live["material.objects"] = ["5 glass"]
        self.output("material", "5", "--reset")  # which is gone
        self.assertEqual(self.objects(program), [])
        program.refuses["material.objects"] = "not now"
        self.assertEqual(self.failure("material", "3", "roughness=1"), "paraview (4242): not now")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
