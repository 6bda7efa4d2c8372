"""A program whose toolkit keeps images of its views: settings show although it only shows these again when it is exposed, and
a pixel of its window tells what it shows: toolkit_test.py GLURAY CLIENT, with a display."""
import base64
import time
import unittest

from linked import Linked

WIDTH, HEIGHT = 320, 240


class Toolkit(Linked):
    def frame(self):
        print("frame", file=self.client.stdin, flush=True)
        return self.client.stdout.readline().strip()

    def count(self):
        """Views that it has drawn, and the window's width as it knows it."""
        print("count", file=self.client.stdin, flush=True)
        return tuple(map(int, self.client.stdout.readline().split()))

    def settled(self):
        self.frame()

    def rests(self):
        """Waits until it has drawn nothing for a moment; its window has its own size then."""
        before = None
        while before != (before := self.count()):
            time.sleep(1)
        self.assertEqual(before[1], WIDTH)

    def pixels(self, hub):
        shot = hub.ask("call", name="shot", arguments={})["value"]
        self.assertEqual((shot["width"], shot["height"]), (WIDTH, HEIGHT))
        piece = hub.ask("call", name="pixels", arguments={"shot": shot["shot"], "row": 0})["value"]
        return base64.b64decode(piece["pixels"])

    def test_settings_show_in_a_program_that_draws_nothing(self):
        hub = self.linked()
        before = self.pixels(hub)
        for _ in range(2):  # at first it is not known how the toolkit draws
            hub.ask("set", values={"ao": True, "ao.strength": 1})
            self.wait_until(lambda: self.pixels(hub) != before)
            self.assertLess(sum(self.pixels(hub)), sum(before))
            hub.ask("set", values={"ao": None, "ao.strength": None})
            self.wait_until(lambda: self.pixels(hub) == before)
            self.rests()

    def test_a_pixel_of_the_window_tells_what_it_shows(self):
        hub = self.linked()
        self.assertEqual(hub.ask("call", name="objects", arguments={})["value"]["total"], 2)
        image = self.pixels(hub)
        background = image[3 * (WIDTH * (HEIGHT // 2) + 45):][:3]
        found = set()
        for y in range(0, HEIGHT, 8):
            for x in range(0, WIDTH, 8):
                got = hub.ask("call", name="pick", arguments={"x": x + 0.5, "y": y + 0.5})["value"]["object"]
                pixel = image[3 * (WIDTH * y + x):][:3]
                if got is None:
                    self.assertIn(pixel, (background, b"\x80\x80\x80"), (x, y))
                else:
                    self.assertNotIn(pixel, (background, b"\x80\x80\x80"), (x, y))
                found.add(got)
        self.assertEqual(len(found), 3)


if __name__ == "__main__":
    unittest.main(argv=["toolkit_test.py", "-v"])
