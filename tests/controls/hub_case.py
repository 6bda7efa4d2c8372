"""A test with a folder of its own and hubs of memory_hub.py in it."""
import pathlib
import tempfile
import unittest

from memory_hub import FakeHub


class HubCase(unittest.TestCase):
    ROWS = []  # as `gluray settings --json` prints them

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def hub(self, **options):
        hub = FakeHub(self.folder / "run", self.ROWS, **options)
        self.addCleanup(hub.end)
        return hub

    def two(self):
        """A hub with two programs, the second of which draws nothing."""
        hub = self.hub()
        first, second = hub.add("paraview", 4242), hub.add("vmd", 77)
        second.frame = None
        return hub, first, second
