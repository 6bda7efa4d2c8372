"""import gluray, with a hub that only pretends: python_test.py GLURAY PYTHON_FOLDER. hub_python_test.py tests how it finds a hub."""
import contextlib
import io
import itertools
import os
import sys
import threading
import time
import unittest

from memory_hub import FakeProgram, IMAGE, image_of
from python_case import GLURAY, ROWS, PythonCase, gluray


class Python(PythonCase):
    def test_names_of_python_stay(self):
        names = {}
        exec("from gluray import *", names)
        self.assertEqual({"set", "help"} & set(names), set())
        self.assertIs(names["settings"], gluray.settings)

    def test_programs(self):
        self.two()
        paraview, vmd = gluray.programs()
        self.assertEqual((paraview.name, paraview.pid, paraview.ranks, paraview.since, repr(vmd)), ("paraview", 4242, 1, 1764000000.5, "<gluray.Program vmd (77)>"))
        self.assertEqual(gluray.programs("vmd"), [vmd])

    def test_set_and_get(self):
        _, first, second = self.two()
        paraview, vmd = gluray.programs()
        self.assertEqual(gluray.set(ao=True, **{"ao.samples": 8}), {paraview: 1042, vmd: None})
        self.assertEqual((first.live, second.live), ({"ao": True, "ao.samples": 8},) * 2)
        paraview["ao.samples"] = 32
        self.assertEqual((paraview["ao.samples"], paraview.get("ao"), vmd["ao.samples"]), (32, True, 8))
        self.assertEqual(paraview.why("ao.samples"), {"value": 32, "layer": "live", "place": ""})
        self.assertEqual(paraview.set({"ao": None}, ao_samples=4), 1042)
        self.assertEqual(first.live, {"ao.samples": 4})
        self.assertEqual(paraview.settings()["ao.samples"], 4)
        self.assertEqual(vmd.preset("draft"), None)
        self.assertEqual(second.live["preset"], "draft")
        gluray.preset("streamlines")
        self.assertEqual(first.live["preset"], "streamlines")

    def test_undo_and_gestures(self):
        _, first, _ = self.two()
        p = gluray.programs()[0]
        with p.gesture():
            for samples in (1, 2, 3):
                p["ao.samples"] = samples
        p["spp"] = 4
        gluray.programs("vmd")[0].set(spp=2)
        gluray.undo()
        self.assertEqual(first.live, {"ao.samples": 3})
        p.undo()
        self.assertEqual((first.live, p.redo(), first.live), ({}, 1042, {"ao.samples": 3}))
        gluray.redo()
        p.undo(), p.undo()
        self.assertEqual(self.refusal(p.undo), "paraview (4242): there is nothing to undo")

    def test_settings_for_a_while(self):
        _, first, second = self.two()
        gluray.programs()[0]["spp"] = 2
        with self.assertRaises(ZeroDivisionError), gluray.settings(ao=True, spp=4):
            self.assertEqual((first.live, second.live), ({"ao": True, "spp": 4},) * 2)
            gluray.programs()[0]["ao.samples"] = 3
            1 / 0
        self.assertEqual((first.live, second.live), ({"spp": 2, "ao.samples": 3}, {}))

    def test_shot(self):
        hub, first, _ = self.two()
        p = gluray.programs()[0]
        file = self.folder / "a.png"
        self.assertEqual((p.shot(file), p.shot(str(file))), ((5, 3), (5, 3)))
        self.assertEqual(image_of(file), (5, 3, IMAGE))
        first.no_image = "no"
        self.assertEqual(self.refusal(lambda: p.shot(file)), "paraview (4242): no")
        self.assertEqual([one.name for one in self.folder.iterdir() if one.name != "run"], ["a.png"])

    def test_shots_replace_images_alone(self):
        self.two()
        p = gluray.programs()[0]
        notes = self.folder / "notes.png"
        notes.write_text("notes")
        (self.folder / "folder.png").mkdir()
        (self.folder / "link.png").symlink_to("notes.png")
        for name in ("notes.png", "folder.png", "link.png"):
            self.assertIn("is no PNG file", self.refusal(lambda: p.shot(self.folder / name)))
        self.assertIn(".png", self.refusal(lambda: p.shot(self.folder / "a.jpg")))
        self.assertIn("No such file", self.refusal(lambda: p.shot(self.folder / "nowhere" / "a.png")))
        self.assertEqual(notes.read_text(), "notes")

    def test_wrong_shots(self):
        hub, *_ = self.two()
        p, size = gluray.programs()[0], {"shot": 1, "width": 5, "height": 3}
        for value in (3, {}, size | {"width": 0}, size | {"width": 1 << 40}, size | {"height": "3"}, size, size | {"pixels": "AAAA"}, size | {"pixels": "?"}):
            hub.instead["call"] = {"results": [{"program": 1, "value": value}]}
            self.assertEqual(self.refusal(lambda: p.shot(self.folder / "a.png")), "paraview (4242): it sends no image")
        self.assertFalse((self.folder / "a.png").exists())

    def test_names(self):
        hub, first, _ = self.two()
        hub.rows += [{"name": "a.b-c", "value": 1, "layer": "built-in", "place": "", "default": 1}, {"name": "a.b.c", "value": 1, "layer": "built-in", "place": "", "default": 1}]
        p = gluray.programs()[0]
        p.set(camera_f_number=4, log_level="debug")
        self.assertEqual(first.live, {"camera.f-number": 4, "log-level": "debug"})
        self.assertEqual(self.refusal(lambda: p.set(ao_sample=1)), "paraview (4242): no setting is called 'ao_sample'")
        self.assertIn("no name", self.refusal(lambda: p.set({3: 1})))
        hub.add("third", 3)
        third = gluray.programs("third")[0]
        self.assertEqual(self.refusal(lambda: third.get("a_b_c")), "a_b_c may mean a.b-c or a.b.c; use the setting's own name")

    def test_values(self):
        _, first, _ = self.two()
        p = gluray.programs()[0]

        class Array:
            def tolist(self):
                return [1.0, 0.5]

        p["lights.up"] = Array()
        self.assertEqual(first.live["lights.up"], [1.0, 0.5])
        for value in (object(), float("nan"), {1, 2}):
            self.assertIn("a value is no boolean, number, text or list", self.refusal(lambda: p.set(spp=value)))
        self.assertEqual(p["spp"], 1)
        self.assertIn("longer than 1 MiB", self.refusal(lambda: p.set(report="x" * (1 << 20))))

    def test_programs_refuse(self):
        _, first, second = self.two()
        first.refuses["spp"] = "spp: not\nnow"
        self.assertEqual(self.refusal(lambda: gluray.set(spp=4)), "paraview (4242): spp: not now")
        self.assertEqual(second.live, {"spp": 4})

    def test_all_programs_get_one_request(self):
        hub, first, second = self.two()
        gluray.set(ao_samples=8), gluray.preset("draft"), gluray.undo(), gluray.redo()
        with gluray.settings(spp=3):
            pass
        sent = [(r["type"], r["program"]) for r in hub.requests if r["type"] not in ("list", "describe")]
        self.assertEqual(sent, [(kind, [1, 2]) for kind in ("set", "set", "undo", "redo", "get", "set", "set")])
        self.assertEqual((first.live, second.live), ({"ao.samples": 8, "preset": "draft"},) * 2)

    def test_silent_programs_delay_all_by_one_limit(self):
        programs = self.real_hub(*(FakeProgram(1, f"p{i}", i, ROWS) for i in range(1, 7)))
        gluray.set(spp=2)
        for program in programs[1:]:
            program.silent = ("set", "undo", "redo")
        silent, seen = [f"p{i} ({i})" for i in range(2, 7)], []
        for act in (lambda: gluray.set(spp=4), gluray.undo, lambda: gluray.settings(spp=5).__enter__()):
            begin = time.monotonic()
            said = self.refusal(act)
            self.assertLess(time.monotonic() - begin, 9)  # one after the other: 15
            self.assertEqual([name for name in silent if name in said], silent)
            self.assertNotIn("p1", said)
            seen.append(programs[0].live)
        self.assertEqual(seen, [{"spp": 4}, {"spp": 2}, {"spp": 2}])

    def test_two_clients(self):
        """A change of one is seen and taken back by the other; gestures of two clients are two steps, also where they meet."""
        first, second = self.real_hub(FakeProgram(1, "paraview", 4242, ROWS), FakeProgram(1, "vmd", 77, ROWS))
        paraview, vmd = sorted(gluray.programs(), key=lambda p: p.name)
        other = "import gluray, sys\np, = gluray.programs('paraview')\nwith p.gesture():\n"
        other += "    for line in sys.stdin:\n        print(p.set({'ao.radius': float(line)}), flush=True)\nprint(p.undo(), sorted(gluray.undo().values()))"
        with self.python(other) as python, paraview.gesture():
            for radius in (1, 2):
                paraview["ao.radius"] = radius
            python.stdin.write("3\n"), python.stdin.flush()
            self.assertEqual(python.stdout.readline(), "1042\n")
            paraview["ao.radius"] = 4
            self.assertEqual([step[1]["ao.radius"] for step in first.steps], [2, 3.0, 4])
            paraview.undo()
            self.assertEqual(paraview["ao.radius"], 3)
            vmd["spp"] = 2
            said, failed = python.communicate(timeout=20)
        self.assertEqual((said.split("\n")[0], failed), ("1042 [1042, 1042]", ""))
        self.assertEqual((first.live, second.live), ({}, {}))

    def test_settings_for_a_while_of_programs_that_differ(self):
        first, second, third = self.real_hub(*(FakeProgram(1, name, pid, ROWS) for pid, name in ((1, "a"), (2, "b"), (3, "c"))))
        a, b, _ = sorted(gluray.programs(), key=lambda p: p.name)
        a["ao.samples"], b["ao.samples"] = 2, 3
        with gluray.settings(ao_samples=9, spp=4):
            self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 9, "spp": 4}] * 3)
        self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 2}, {"ao.samples": 3}, {}])
        second.refuses["spp"] = "spp: not now"
        with self.assertRaisesRegex(gluray.GlurayError, r"^b \(2\): spp: not now$"), gluray.settings(spp=4):
            self.fail("the block is not entered")
        self.assertEqual([p.live for p in (first, second, third)], [{"ao.samples": 2}, {"ao.samples": 3}, {}])

    def test_programs_that_end_meanwhile(self):
        hub, first, second = self.two()
        found = gluray.programs()
        hub.remove(second)
        real, gluray._some = gluray._some, lambda: found
        self.addCleanup(setattr, gluray, "_some", real)
        self.assertEqual(self.refusal(lambda: gluray.set(spp=4)), "vmd (77): it has ended")
        self.assertEqual(first.live, {"spp": 4})

    def test_state(self):
        hub, *_ = self.two()
        p = gluray.programs()[0]
        for fps, moment in ((0.0, 0.2), (24.0, 0.5)):
            event = {"type": "event", "what": "state", "program": 1, "state": {"fps": fps}}
            threading.Timer(moment, hub.tell, [event]).start()
        self.assertEqual(p.state(), {"fps": 24.0})
        self.assertEqual(self.refusal(lambda: p.state(seconds=0.2)), "paraview (4242): it does not tell its state")

    def test_watch(self):
        hub, first, second = self.two()
        events = gluray.watch(seconds=20)
        threading.Timer(0.3, lambda: (gluray.set(spp=4), hub.add("third", 3), hub.remove(second))).start()
        seen = list(itertools.islice((e for e in events if e.get("values") != {}), 4))
        self.assertEqual([(e["what"], e["program"].name, e["values"]["spp"]["value"]) for e in seen[:2]], [("settings", "paraview", 4), ("settings", "vmd", 4)])
        self.assertEqual([[p.name for p in e["programs"]] for e in seen[2:]], [["paraview", "vmd", "third"], ["paraview", "third"]])
        events.close()
        self.assertEqual(list(gluray.watch(what=["programs"], seconds=0.2)), [])
        events = gluray.watch()
        hub.add("fourth", 4)
        threading.Timer(0.3, hub.end).start()
        with self.assertRaisesRegex(gluray.HubError, "the connection to the hub ended"):
            list(events)

    def test_help(self):
        os.environ["GLURAY"] = GLURAY
        hub, *_ = self.two()
        for _ in range(2):  # from a program, then from the executable
            text = io.StringIO()
            with contextlib.redirect_stdout(text):
                gluray.help("ao.samples")
            self.assertIn("ao.samples (default: 16)", text.getvalue())
            self.assertIn("Occlusion rays (Occlusion, advanced)", text.getvalue())
            self.assertIn("from 1 to 4096 rays\n", text.getvalue())
            self.refusal(lambda: gluray.help("ao.sample"))
            hub.end()
            hub = self.hub()

    def test_no_program(self):
        self.hub()
        for act in (lambda: gluray.set(spp=4), gluray.undo, lambda: gluray.settings(spp=4).__enter__()):
            self.assertEqual(self.refusal(act), "no program runs under GLuRay; start one with: gluray PROGRAM")
        self.assertEqual(gluray.programs(), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
