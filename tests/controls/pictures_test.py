"""Images of a program's window: pictures_test.py GLURAY CLIENT PYTHON_FOLDER, with an X server at hand."""
import base64
import json
import os
import subprocess
import sys
import time
import unittest

from linked import GLURAY, Linked
from memory_hub import image_of

WIDTH, HEIGHT = 160, 120  # of the client's window


class WindowImages(Linked):
    def show(self):
        """Draws a frame that is not read back."""
        print("show", file=self.client.stdin, flush=True)
        while (line := self.client.stdout.readline()) != "shown\n":  # frames after Expose events
            self.assertTrue(line)

    def window(self):
        return json.loads((self.runtime / "programs" / str(self.client.pid)).read_text())["window"]

    def screen(self):
        """RGB bytes of the window as the X server shows it."""
        words = ["import", "-silent", "-window", str(self.window()), "-depth", "8", "rgb:-"]
        return subprocess.run(words, check=True, capture_output=True, timeout=30).stdout

    def shot(self, hub, arguments={}):
        """RGB bytes of a shot."""
        value = hub.ask("call", name="shot", arguments=arguments)["value"]
        self.assertEqual((value["width"], value["height"]), (WIDTH, HEIGHT))
        piece = hub.ask("call", name="pixels", arguments={"shot": value["shot"], "row": 0})["value"]
        self.assertEqual(piece["rows"], HEIGHT)
        return base64.b64decode(piece["pixels"], validate=True)

    def kept(self, hub):
        hub.ask("observe", what=["state"], every=0.05)
        kept = hub.event("state")["state"]["pictures"]
        hub.ask("observe", what=[])
        hub.events.clear()
        return kept


class Shots(WindowImages):
    def check_shots(self, *options, **variables):
        hub = self.linked(*options, **variables)
        shots = []
        for values in ({}, {"ao": True, "ao.samples": 8}, {"ao": None, "background": "color", "background.color": "#ff8000"}):
            if values:
                hub.ask("set", values=values)
            for draw in (self.frame, self.show):
                draw()
                shots.append(self.shot(hub))
                time.sleep(0.1)
                self.assertTrue(shots[-1] == self.screen(), (values, draw))
        return shots

    def test_they_are_what_the_window_shows(self):
        shots = self.check_shots()
        self.assertEqual(len(set(shots[::2])), 3)

    def test_of_rasterised_frames(self):
        self.assertEqual(len(set(self.check_shots(GLURAY_ENGINE="never"))), 1)

    def test_of_frames_that_lag(self):
        self.check_shots("--lag", "on")

    def test_with_figures_over_the_image(self):
        hub = self.linked("--hud")
        self.show()
        shot, plain = self.shot(hub), self.screen()
        self.assertTrue(shot == plain)

    def test_they_say_why_not(self):
        hub = self.linked()
        self.assertIn("width", hub.ask("call", name="shot", arguments={"width": 3})["why"])
        self.assertIn("not kept", hub.ask("call", name="pixels", arguments={"shot": 7, "row": 0})["why"])
        self.shot(hub)
        for row in (HEIGHT, -1, "x", None):
            self.assertIn("row", hub.ask("call", name="pixels", arguments={"shot": 1, "row": row})["why"])

    def test_none_is_read_unless_one_is_wanted(self):
        hub = self.linked()
        self.assertEqual(self.kept(hub), 0)
        for _ in range(5):
            self.frame(), self.show()
        self.assertEqual(self.kept(hub), 0)
        self.shot(hub)
        kept = self.kept(hub)
        for _ in range(5):
            self.frame(), self.show()
        self.assertEqual((kept, self.kept(hub)), (1, 1))


class Saved(WindowImages):
    def test_by_the_shell_and_by_python(self):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_")}
        environment |= {"XDG_CONFIG_HOME": "/nowhere", "GLURAY_RUNTIME": str(self.runtime), "PYTHONPATH": PYTHON, "GLURAY": GLURAY}
        real = subprocess.Popen([GLURAY, "hub"], env=environment, stderr=subprocess.DEVNULL)
        self.addCleanup(lambda: (real.terminate(), real.wait(10)))
        until = time.monotonic() + 10
        while not (self.runtime / "hub.sock").exists():
            self.assertLess(time.monotonic(), until)
            time.sleep(0.01)
        self.start()
        self.assertTrue(self.frames_until(lambda: "gluray-control" in self.threads()))
        time.sleep(0.2)  # it says hello
        for words in ([GLURAY, "shot", "a.png"], [sys.executable, "-c", "import gluray; gluray.programs()[0].shot('a.png')"]):
            subprocess.run(words, check=True, cwd=self.folder, env=environment, timeout=60, stdout=subprocess.DEVNULL)
            self.assertTrue(image_of(self.folder / "a.png") == (WIDTH, HEIGHT, self.screen()))
            (self.folder / "a.png").unlink()


class Thumbnails(WindowImages):
    def thumbnail(self, hub):
        event = hub.event("thumbnail")
        pixels = base64.b64decode(event["pixels"], validate=True)
        self.assertEqual(len(pixels), 3 * event["width"] * event["height"])
        return event["width"], event["height"], pixels

    def quiet(self, hub, seconds):
        """No thumbnail comes in that time."""
        with self.assertRaises(TimeoutError):
            hub.message(seconds)

    def test_they_follow_the_image(self):
        hub = self.linked()
        hub.ask("observe", what=["thumbnail"], every=0.05)
        width, height, first = self.thumbnail(hub)
        self.assertEqual((width, height), (WIDTH, HEIGHT))
        self.assertTrue(first == self.screen())
        self.quiet(hub, 0.6)
        hub.ask("set", values={"ao": True, "ao.samples": 8})
        until = time.monotonic() + 5
        while (newest := self.thumbnail(hub)[2]) != self.screen():
            self.assertLess(time.monotonic(), until)
        self.assertNotEqual(newest, first)

    def test_size_and_pace(self):
        hub = self.linked()
        self.assertIn("size", hub.ask("observe", what=["thumbnail"], size=5)["why"])
        hub.ask("observe", what=["thumbnail"], every=0.3, size=64)
        begin = time.monotonic()
        while time.monotonic() < begin + 1.5:
            self.show()
            time.sleep(0.01)
        hub.ask("observe", what=[])
        events = [e for e in hub.events if e["what"] == "thumbnail"]
        self.assertTrue(3 <= len(events) <= 6, len(events))
        self.assertEqual({(e["width"], e["height"]) for e in events}, {(64, 48)})
        before = self.kept(hub)
        self.show(), self.show()
        self.assertEqual(self.kept(hub), before)

    def check_the_last_frame(self, *options):
        hub = self.linked(*options)
        hub.ask("observe", what=["thumbnail"], every=0.5)
        first = self.thumbnail(hub)[2]
        self.show()
        hub.ask("set", values={"ao": True, "ao.samples": 8})
        self.show(), self.show()
        until, newest = time.monotonic() + 5, first
        while newest == first or newest != self.screen():
            self.assertLess(time.monotonic(), until)
            newest = self.thumbnail(hub)[2]
        time.sleep(1.2)
        hub.ask("observe", what=[])
        events = [e for e in hub.events if e["what"] == "thumbnail"]
        self.assertLessEqual(len(events), 1, "it draws nothing any more")

    def test_the_last_of_some_frames_is_seen(self):
        self.check_the_last_frame()

    def test_the_last_of_some_frames_that_lag_is_seen(self):
        self.check_the_last_frame("--lag", "on")


if __name__ == "__main__":
    PYTHON = sys.argv[3]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
