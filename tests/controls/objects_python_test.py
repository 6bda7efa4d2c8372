"""What programs draw, in Python, with a hub that only pretends: objects_python_test.py GLURAY PYTHON_FOLDER."""
import sys
import threading
import time
import unittest

from fake_scene import an_object
from memory_hub import IMAGE, image_of
from python_case import PythonCase, gluray


class DrawnCase(PythonCase):
    def one(self):
        hub = self.hub()
        program = hub.add("paraview", 4242)
        return program, gluray.programs()[0]

    def unreadable(self, act, name):
        self.assertEqual(self.refusal(act), f"paraview (4242): its answer cannot be read: '{name}' is missing or wrong")


class Drawn(DrawnCase):
    def test_objects(self):
        program, p = self.one()
        self.assertEqual(p.objects(), program.scene.objects)
        program.scene.objects = [an_object(n) for n in range(1, 2501)]
        self.assertEqual([one["object"] for one in p.objects()], list(range(1, 2501)))
        for value, name in (({}, "objects"), ({"objects": [3], "total": 1}, "objects"), ({"objects": [{}], "total": 1}, "object"), ({"objects": []}, "total"),
                            ({"objects": [an_object(2), an_object(2)], "total": 2}, "object"), ({"objects": [], "total": "x"}, "total"), (7, "objects")):
            program.scene.instead["objects"] = {"value": value}
            self.unreadable(p.objects, name)
        program.scene.instead["objects"] = {"why": "busy"}
        self.assertEqual(self.refusal(p.objects), "paraview (4242): busy")

    def test_pick(self):
        program, p = self.one()
        found = p.pick(2, 1)
        self.assertEqual((found["object"], found["view"], found["position"], found["distance"], found["share"]), (3, 1, [0.5, 0.25, -1e-7], 5.25, [0.25, 1]))
        self.assertEqual(p.pick(0.5, 0.5, 1, 1), found | {"share": [0.375, 0.75]})
        self.assertIsNone(p.pick(0, 2))
        self.assertEqual(program.calls, [("pick", {"x": 2, "y": 1}), ("pick", {"x": 0.5, "y": 0.5, "width": 1, "height": 1}), ("pick", {"x": 0, "y": 2})])
        for value, name in (({}, "object"), ({"object": "x"}, "object"), ({"object": 0}, "object"), ({"object": True}, "object"), ({"object": 3}, "position"),
                            ({"object": 3, "position": [1, 2, "3"], "normal": [0, 0, 1]}, "position"),
                            ({"object": 3, "position": [1, 2, 3], "normal": [0, 0, 1]}, "share")):
            program.scene.instead["pick"] = {"value": value}
            self.unreadable(lambda: p.pick(2, 3), name)

    def test_lights_and_cameras(self):
        program, p = self.one()
        self.assertEqual((p.lights(), p.cameras()), (program.scene.lights, program.scene.cameras))
        program.scene.instead = {"lights": {"value": {"lights": [3]}}, "cameras": {"value": {}}}
        self.unreadable(p.lights, "lights")
        self.unreadable(p.cameras, "cameras")

    def test_light_at(self):
        program, p = self.one()
        self.assertEqual(p.light_at(2, 1), 1042)
        self.assertEqual((program.live, len(program.steps)), ({"lights": "headlight+key", "lights.azimuth": 20.5, "lights.elevation": -10.25}, 1))
        program.live = {"lights": "sky"}
        p.light_at(2, 1)
        self.assertEqual(program.live["lights"], "headlight+key")
        program.live = {"lights": "three-point"}
        p.light_at(0.5, 0.5, 1, 1)
        self.assertEqual(program.live["lights"], "three-point")
        self.assertEqual(self.refusal(lambda: p.light_at(0, 1)), "paraview (4242): nothing is there")
        program.scene.instead["highlight"] = {"value": {"object": 3, "azimuth": 1, "elevation": None}}
        self.unreadable(lambda: p.light_at(2, 1), "azimuth")

    def test_focus_at(self):
        program, p = self.one()
        self.assertEqual(p.focus_at(2, 2), 1042)
        self.assertEqual(program.live, {"camera.focus": 0, "camera.focus-x": 0.25, "camera.focus-y": 0.5})
        self.assertEqual(program.calls, [("pick", {"x": 2, "y": 2})])
        p.focus_at(50, 0, 50, 100)
        self.assertEqual((program.live["camera.focus-x"], program.live["camera.focus-y"]), (1, 1))
        self.assertEqual(self.refusal(lambda: p.focus_at(0, 1)), "paraview (4242): nothing is there")
        program.scene.instead["pick"] = {"value": {"object": 3, "position": [1, 2, 3], "normal": [0, 0, 1], "share": None}}
        self.unreadable(lambda: p.focus_at(2, 2), "share")


class Materials(DrawnCase):
    def test_material(self):
        program, p = self.one()
        self.assertEqual(p.materials(), {})
        self.assertEqual(p.material(3, "glass", roughness=0.1), 1042)
        p.material([1, 3], coat=0.5)
        self.assertEqual(program.live["material.objects"], ["3 glass roughness=0.1 coat=0.5", "1 coat=0.5"])
        p.material(3, "metal", metal="Au", hidden_from=["camera", "shadow"])
        p.material("all", hidden_from="all")
        p.material(range(3, 4), hidden_from="reflection")
        self.assertEqual(p.materials(), {1: "coat=0.5 hidden-from=all", 3: "metal metal=Au hidden-from=reflection", 7: "hidden-from=all"})
        p.material([3, 7], hidden_from="none")
        self.assertEqual(p.materials(), {1: "coat=0.5 hidden-from=all", 3: "metal metal=Au"})
        program.live["material.file"] = "/rules.toml"  # which may hide objects
        p.material(3, hidden_from=[])
        self.assertEqual(p.materials()[3], "metal metal=Au hidden-from=none")
        p.material(3, reset=True)
        self.assertEqual(list(p.materials()), [1])
        p.material("all", reset=True)
        self.assertEqual(program.live["material.objects"], [])
        p.undo()
        self.assertEqual(list(p.materials()), [1])

    def test_entries_merge_as_those_of_commands(self):
        """The cases of src/settings/object_rule_test.cpp."""
        entries, words = gluray.drawn.with_object, gluray.drawn.words_of
        several = ["3 glass roughness=0.1", "7 matte", "3 hidden-from=camera", " 3  ior=1.4  roughness=0.3"]
        self.assertEqual((words(several, 3), words(several, 4)), (["glass", "roughness=0.3", "ior=1.4", "hidden-from=camera"], []))
        self.assertEqual(words(["3 glass", "3 matte"], 3), ["matte"])
        self.assertEqual(words(["glass", "", "x 3", "0 matte"], 0), [])
        self.assertEqual(entries(["3 glass hidden-from=camera", "7 matte"], 3, ["roughness=0.1"]), ["3 glass roughness=0.1 hidden-from=camera", "7 matte"])
        self.assertEqual(entries(["3 glass roughness=0.1 ior=1.4 hidden-from=camera"], 3, ["matte"]), ["3 matte hidden-from=camera"])
        self.assertEqual(entries(["3 glass coat=1"], 3, ["metal=Au", "metal"]), ["3 metal metal=Au"])
        places = ["5 mirror", "3 glass", "5 coat=1", "7 matte"]
        self.assertEqual(entries(places, 5, ["roughness=0"]), ["5 mirror coat=1 roughness=0", "3 glass", "7 matte"])
        self.assertEqual(entries(places, 3, ["matte"]), ["5 mirror", "3 matte", "5 coat=1", "7 matte"])
        self.assertEqual(entries(["5 mirror"], 1, ["glass"]), ["5 mirror", "1 glass"])
        self.assertEqual(entries(["3 glass", "7 matte", "3 coat=1"], 3, []), ["7 matte"])
        self.assertEqual(entries(["3 hidden-from=camera", "7 matte"], 3, ["hidden-from="]), ["7 matte"])

    def test_mistakes(self):
        program, p = self.one()
        for act, why in ((lambda: p.material(5, "glass"), "paraview (4242): it draws no object 5; objects() has them"), (lambda: p.material(3), "name a material, values, or hidden_from"),
                         (lambda: p.material("3", "glass"), "'3': use the number of an object, a list of them, or 'all'"), (lambda: p.material(3.5, "glass"), "3.5: use the number"),
                         (lambda: p.material(3, "glass", reset=True), "reset takes objects alone"), (lambda: p.material(3, "glass, 4"), "'glass, 4': use one word a value"),
                         (lambda: p.material(3, metal=""), "'metal=': use one word a value"), (lambda: p.material(3, 7), "7: use one word a value")):
            self.assertIn(why, self.refusal(act))
        program.live["material.objects"] = "3 glass"
        self.assertIn("does not say what material.objects is", self.refusal(p.materials))
        self.assertEqual(program.steps, [])


class Films(DrawnCase):
    def one(self):
        program, p = super().one()
        program.draws = 2
        return program, p

    def test_film(self):
        program, p = self.one()
        done = []
        self.assertEqual(p.film(self.folder / "a-%02d.png", 3, progress=lambda *counts: done.append(counts)), [1044, 1046, 1048])
        self.assertEqual(sorted(file.name for file in self.folder.glob("*.png")), ["a-01.png", "a-02.png", "a-03.png"])
        self.assertEqual((image_of(self.folder / "a-03.png"), done), ((5, 3, IMAGE), [(1, 3), (2, 3), (3, 3)]))
        self.assertEqual(len(p.film(str(self.folder / "b.png"), 9, progress=lambda done, _: done < 2)), 2)
        self.assertTrue((self.folder / "b-0002.png").exists())
        begin = time.monotonic()
        p.film(self.folder / "c_.png", 3, every=0.2)
        self.assertTrue(0.4 <= time.monotonic() - begin < 5)
        self.assertTrue((self.folder / "c_0001.png").exists())

    def test_settings_vary(self):
        program, p = self.one()
        program.live = {"lights.azimuth": 7}
        seen, answer = [], program.call
        def call(request):
            seen.extend([dict(program.live)] if request["name"] == "shot" else [])
            return answer(request)
        program.call = call
        p.film(self.folder / "a.png", 3, set={"lights_azimuth": (0, 90), "ao.samples": (1, 2)})
        self.assertEqual(seen, [{"lights.azimuth": azimuth, "ao.samples": samples} for azimuth, samples in ((0, 1), (45, 2), (90, 2))])
        self.assertEqual((program.live, len(program.steps)), ({"lights.azimuth": 7}, 1))
        program.no_image = "its window is gone"
        self.assertEqual(self.refusal(lambda: p.film(self.folder / "a.png", 3, set={"spp": (1, 4)})), "paraview (4242): its window is gone")
        self.assertEqual(program.live, {"lights.azimuth": 7})

    def test_the_first_frame_with_the_values_counts(self):
        program, p = self.one()
        answer = program.set
        program.set = lambda request: answer(request) | {"frame": program.frame + 4}  # two frames before it are shown
        self.assertEqual(p.film(self.folder / "a.png", 2, set={"spp": (1, 2)}), [1046, 1050])

    def test_passes(self):
        program, p = self.one()
        passes, taken, ended = [0], [], threading.Event()
        answer_set, answer_call, fake = program.set, program.call, self.fakes[-1]
        def change(request):
            passes[0] = 0
            return answer_set(request)
        def call(request):
            taken.extend(passes if request["name"] == "shot" else [])
            return answer_call(request)
        def tell():
            while not ended.wait(0.02):
                with fake.lock:
                    passes[0] = min(passes[0] + 1, 6)
                    fake.tell({"type": "event", "what": "state", "program": 1, "state": {"frame": program.frame, "passes": passes[0], "noise": 1.0}})
        program.set, program.call = change, call
        thread = threading.Thread(target=tell)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(ended.set)
        p.film(self.folder / "a.png", 3, set={"spp": (1, 3)}, passes=4)
        self.assertTrue(len(taken) == 3 and min(taken) >= 4, taken)
        program.live["refine.passes"] = 3
        begin = time.monotonic()
        p.film(self.folder / "a.png", 1, passes=9)
        self.assertTrue(taken[3] >= 3 and time.monotonic() < begin + 5, taken)
        program.live["refine.idle"] = False
        self.assertEqual(self.refusal(lambda: p.film(self.folder / "a.png", 1, passes=4)), "paraview (4242): passes needs refine.idle = true")

    def hub(self, **options):
        self.fakes = [*getattr(self, "fakes", []), super().hub(**options)]
        return self.fakes[-1]

    def test_mistakes(self):
        program, p = self.one()
        (self.folder / "a-0002.png").write_text("notes")
        for name, why in (("a.jpg", "ends in .png"), ("%s.png", "use one %d"), ("%d%d.png", "use one %d"), ("%4d.png", "use one %d"), ("a.png", "is no PNG file")):
            self.assertIn(why, self.refusal(lambda: p.film(self.folder / name, 3)))
        for more, why in (({"frames": 0}, "use a number from 1"), ({"frames": "2"}, "use a number from 1"), ({"frames": 2, "set": {"ao": (0, 1)}}, "only settings that are one number"),
                          ({"frames": 2, "set": {"spp": 3}}, "only settings that are one number"), ({"frames": 2, "set": {"spq": (1, 2)}}, "no setting is called 'spq'")):
            self.assertIn(why, self.refusal(lambda: p.film(self.folder / "b.png", **more)))
        self.assertEqual((program.calls, program.steps), ([], []))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
