"""gluray explain --html: the page's images and numbers, with and without GLuRay.

    page_test.py GLURAY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import base64
import json
import re
import sys
import unittest

from explaining import CLIENT, GLASS_PIXELS, TRACED_PIXELS, Folder, explained, gluray


class Page(Folder):
    def page(self, mode, frames=20):
        file = self.folder / "page.html"
        facts = explained("--frames", frames, "--html", file, CLIENT, mode)["page"]
        text = file.read_text()
        self.assertEqual(json.loads(re.search(r'id="facts">(.*?)</script>', text).group(1)), facts)
        return facts, text

    def test_same_frame_twice(self):
        facts, text = self.page("plain")
        self.assertEqual((facts["frame"], facts["frameWithout"], facts["sameFrame"]), (20, 20, True))
        self.assertEqual((facts["width"], facts["height"], facts["pixels"]), (256, 256, 65536))
        self.assertEqual(facts["traced"] + facts["drawnOver"], TRACED_PIXELS)
        self.assertEqual(facts["drawnOver"], GLASS_PIXELS)
        # The colour follows the clock, which is the same in both runs.
        self.assertEqual((facts["differingAtAll"], facts["outsideDiffering"]), (0, 0))
        images = dict(re.findall(r'<img id="(\w+)"[^>]*base64,([^"]+)"', text))
        self.assertEqual(set(images), {"with", "without", "difference", "traced"})
        for data in images.values():
            self.assertTrue(base64.b64decode(data).startswith(b"\x89PNG"))
        self.assertNotIn("did not show the same frame", text)

    def test_single_buffered_programs(self):
        facts, text = self.page("single")
        self.assertEqual((facts["frame"], facts["frameWithout"], facts["sameFrame"]), (20, 20, True))
        self.assertEqual(facts["traced"] + facts["drawnOver"], TRACED_PIXELS)
        self.assertEqual((facts["differingAtAll"], facts["outsideDiffering"]), (0, 0))
        self.assertIn('id="without"', text)

    def test_front_buffers(self):
        facts, _ = self.page("front")
        self.assertEqual((facts["frame"], facts["frameWithout"], facts["sameFrame"]), (20, 20, True))
        self.assertEqual(facts["traced"] + facts["drawnOver"], TRACED_PIXELS)
        self.assertEqual((facts["differingAtAll"], facts["outsideDiffering"]), (0, 0))

    def test_differences_are_counted(self):
        facts, _ = self.page("different")
        self.assertEqual((facts["differing"], facts["differingAtAll"]), (100, 100))
        self.assertEqual(facts["drawnOver"], GLASS_PIXELS + 100)
        self.assertTrue(facts["sameFrame"])

    def test_frames_that_are_not_the_same(self):
        for _ in range(3):  # two random bytes may be nearly equal
            facts, text = self.page("restless")
            if not facts["sameFrame"]:
                break
        self.assertFalse(facts["sameFrame"])
        self.assertIn("did not show the same frame", text)

    def test_images_at_rest(self):
        file = self.folder / "page.html"
        facts = explained("--rest", "0.5", "--html", file, CLIENT, "still")["page"]
        self.assertEqual((facts["frame"], facts["frameWithout"], facts["differingAtAll"]), (2, 2, 0))

    def test_pages_that_cannot_be_written(self):
        done = gluray("explain", "--frames", 3, "--html", "/dev/null/page.html", CLIENT)
        self.assertEqual((done.returncode, done.stderr), (1, "gluray: cannot write /dev/null/page.html: Not a directory\n"))

    def test_pages_on_standard_output(self):
        done = gluray("explain", "--frames", 3, "--html", "-", CLIENT)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("<!DOCTYPE html>") and done.stdout.endswith("</html>\n"))
        self.assertIn("triangles traced", done.stderr)

    def test_the_programs_output_is_not_in_the_json(self):
        done = gluray("explain", "--json", "--frames", 3, CLIENT)
        self.assertIn("asked to end", done.stderr)
        json.loads(done.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
