"""A program and a hub: link_test.py GLURAY CLIENT PYTHON_FOLDER, with an X server at hand. hubs_test.py has hubs that end or do not answer."""
import fcntl
import json
import os
import struct
import sys
import termios
import time
import unittest

from linked import PATIENCE, Linked


class Requests(Linked):
    def test_hello(self):
        hub = self.hub()
        self.start()
        hello = self.connect(hub)
        self.assertEqual({k: hello[k] for k in ("type", "version", "role", "pid", "name", "rank", "ranks", "job")},
                         {"type": "hello", "version": 1, "role": "program", "pid": self.client.pid, "name": "client", "rank": 0, "ranks": 1, "job": ""})

    def test_set_changes_the_image_in_the_frame_of_the_answer(self):
        plain, occluded = self.image(), self.image("--ao", "--set", "ao.samples=8")
        self.assertNotEqual(plain, occluded)
        hub = self.linked()
        self.assertEqual(self.frame(), plain)
        hub.ask("observe", what=["state"], every=0.05)
        before = hub.event("state")["state"]["frame"]
        hub.ask("observe", what=[])
        id = self.sent(hub, "set", values={"ao": True, "ao.samples": 8})
        self.assertEqual(self.frame(), occluded)
        result = hub.result(id)
        self.assertEqual(result["values"], {"ao": True, "ao.samples": 8})
        self.assertEqual(result["frame"], before + 1)
        self.assertEqual(self.set(hub, values={"ao": None})["values"], {"ao": False})
        self.assertEqual(self.frame(), plain)

    def test_wrong_values_change_nothing(self):
        hub = self.linked()
        plain = self.frame()
        for values, word in (({"ao": True, "ao.samples": 0}, "use a number from 1"), ({"ao": True, "aoo": 1}, "did you mean 'ao'?"),
                             ({"ao": "some"}, "use on, off"), ({"report": "/tmp/x", "ao": True}, "next run"), ("ao", "object")):
            self.assertIn(word, hub.ask("set", values=values)["why"])
            self.assertEqual(self.frame(), plain)
        self.assertIn("nothing to undo", hub.ask("undo")["why"])

    def test_undo_and_gestures(self):
        hub = self.linked()
        plain = self.frame()
        self.set(hub, values={"ao": True})
        occluded = self.frame()
        for strength in (0.1, 0.2, 0.3):
            self.set(hub, values={"ao.strength": strength}, gesture="drag")
        self.assertNotIn(self.frame(), (plain, occluded))
        for type, image in (("undo", occluded), ("undo", plain), ("redo", occluded), ("undo", plain)):
            id = self.sent(hub, type)
            self.assertEqual(self.frame(), image)
            self.assertIn("frame", hub.result(id))

    def test_get_and_describe(self):
        hub = self.linked("--set", "spp=2", GLURAY_AO_SAMPLES="5")
        values = hub.ask("get", names=["spp", "ao.samples", "ao"])["values"]
        self.assertEqual(values["spp"], {"value": 2, "layer": "command line", "place": "--spp"})
        self.assertEqual(values["ao.samples"], {"value": 5, "layer": "environment", "place": "GLURAY_AO_SAMPLES"})
        self.assertEqual(values["ao"], {"value": False, "layer": "built-in", "place": ""})
        rows = {row["name"]: row for row in hub.ask("describe")["settings"]}
        self.assertEqual(rows["ao.samples"]["default"], 16)
        self.assertEqual(set(rows), set(hub.ask("get")["values"]))
        self.assertIn("why", hub.ask("call", name="dance", arguments={}))
        self.assertIn("why", hub.ask("dance"))

    def test_state_and_settings_are_observed(self):
        hub = self.linked()
        hub.ask("observe", what=["state", "settings"], every=0.1)
        self.assertEqual(hub.event("settings")["values"].keys() & {"ao", "spp"}, set())
        until = time.monotonic() + 1.5
        while time.monotonic() < until:
            self.frame()
        hub.ask("observe", what=["state"], every=0.1)  # what came before is old
        hub.events = [e for e in hub.events if e["what"] == "settings"]
        state = hub.event("state")["state"]
        self.assertGreater(state["frame"], 10)
        self.assertGreater(state["fps"], 5)
        self.assertGreater(state["triangles"], 10)
        self.assertEqual(state["traced"], 1)
        self.assertGreater(state["memory"], 1 << 20)
        self.assertEqual(state["windows"], [{"width": 160, "height": 120}])
        self.assertTrue(state["opengl"]["renderer"])
        self.assertEqual((state["reasons"], state["building"], state["warnings"]), ({}, False, []))
        until = time.monotonic() + PATIENCE
        while hub.event("state")["state"]["fps"] > 0:
            self.assertLess(time.monotonic(), until)
        hub.ask("observe", what=["settings"])
        hub.event("settings")
        self.set(hub, values={"ao": True})
        self.assertEqual(hub.event("settings"), {"type": "event", "what": "settings", "undo": 1, "redo": 0,
                                                 "values": {"ao": {"value": True, "layer": "live", "place": ""}}})

    def test_held_changes_count_from_their_frame(self):
        hub = self.linked()
        plain = self.frame()
        held = hub.start("set", hold=True, values={"ao": True})
        at = hub.result(held)
        self.assertTrue(at["drawing"])
        self.assertEqual(hub.ask("apply", of=held, frame=at["frame"] + 3), {"frame": at["frame"] + 3, "late": False})
        drawn = hub.start("draw", of=held)
        self.assertEqual([self.frame(), self.frame()], [plain, plain])
        occluded = self.frame()
        self.assertNotEqual(occluded, plain)
        self.assertEqual(hub.result(drawn), {"frame": at["frame"] + 3, "values": {"ao": True}})
        held = hub.start("undo", hold=True)
        at = hub.result(held)
        self.frame(), self.frame()
        self.assertTrue(hub.ask("apply", of=held, frame=at["frame"] + 1)["late"])
        self.assertEqual(self.frame(), plain)
        held = hub.start("set", hold=True, values={"ao": True})
        hub.result(held), hub.ask("drop", of=held)
        self.assertIn("why", hub.ask("apply", of=held, frame=1))
        self.assertIn("why", hub.ask("set", hold=True, values={"ao": "some"}))
        self.assertEqual(self.frame(), plain)


class Idle(Linked):
    def idle(self, hub):
        """Waits until the program says that it does not draw."""
        self.wait_until(lambda: not hub.ask("set", hold=True, values={"ao": False})["drawing"])

    def test_idle_programs_are_woken(self):
        hub = self.linked()
        plain = self.frame()
        self.idle(hub)
        result = hub.ask("set", values={"ao": True})
        self.assertIsInstance(result["frame"], int)  # else null, half a second later
        self.assertNotEqual(self.exposed(), plain)

    def test_programs_that_do_not_draw_are_answered_for(self):
        hub = self.linked()
        plain = self.frame()
        # It waits for the end of a line.
        self.client.stdin.write("fra")
        self.client.stdin.flush()
        unread = lambda: struct.unpack("i", fcntl.ioctl(self.client.stdin, termios.FIONREAD, bytes(4)))[0]
        self.wait_until(lambda: unread() == 0)
        self.idle(hub)
        before = time.monotonic()
        result = hub.ask("set", values={"ao": True})
        self.assertEqual(result, {"frame": None, "values": {"ao": True}})
        self.assertGreater(time.monotonic() - before, 0.4)
        print("me", file=self.client.stdin, flush=True)
        self.assertNotEqual(self.exposed(), plain)

    def test_its_file(self):
        self.start()
        file = self.runtime / "programs" / str(self.client.pid)
        line = json.loads(file.read_text())
        self.assertEqual((line["pid"], line["name"], line["display"]), (self.client.pid, "client", os.environ["DISPLAY"]))
        self.assertGreater(line["window"], 0)
        self.assertEqual([f.stat().st_mode & 0o777 for f in (self.runtime, file.parent)], [0o700, 0o700])
        self.client.stdin.close()
        self.client.wait(20)
        self.assertFalse(file.exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
