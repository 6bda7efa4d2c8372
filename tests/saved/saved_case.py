"""What tests of saved scenes have in common beside shots_case.py: a hub, and a program that it sees."""
import json
import sys
import time

from shots_case import PATIENCE, ShotsCase, chunks, pixels, size_of  # noqa: F401: for the tests

GLURAY, CLIENT, TOOLKIT = sys.argv[1:4]
WIDTH, HEIGHT = 160, 120  # of the client's window


class SavedCase(ShotsCase):
    GLURAY = GLURAY

    def start(self, *options, client=(CLIENT, "exposed")):
        self.spawn(GLURAY, "hub", "--with-parent")
        self.client = self.spawn(GLURAY, *options, "--", *client)
        print("frame", file=self.client.stdin, flush=True)
        self.client.stdout.readline()
        end = time.monotonic() + PATIENCE
        while not json.loads(self.gluray("list", "--json").stdout or "[]"):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def saved(self, *options):
        self.start(*options)
        self.done("save", "scene.gluray")
        return self.folder / "scene.gluray"

    def same(self, one, other):
        self.assertTrue(pixels(self.file(one)) == pixels(self.file(other)), f"{one}, {other}")
