"""What the tests of the Python module share: a folder of their own, hubs that pretend, real ones."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from memory_hub import FakeHub, seek_hub

class PythonCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        os.environ |= {"GLURAY_RUNTIME": str(self.folder / "run"), "GLURAY": "/nowhere/gluray", "XDG_CONFIG_HOME": "/nowhere"}
        self.addCleanup(gluray.hub._drop)

    def hub(self, **options):
        hub = FakeHub(self.folder / "run", ROWS, **options)
        self.addCleanup(hub.end)
        return hub

    def two(self):
        hub = self.hub()
        first, second = hub.add("paraview", 4242), hub.add("vmd", 77)
        second.frame = None
        return hub, first, second

    def real_hub(self, *programs):
        """gluray hub with these programs."""
        hub = subprocess.Popen([GLURAY, "hub", "--with-parent"], stdin=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(hub.communicate)
        hub.stderr.readline()
        for program in programs:
            self.addCleanup(seek_hub(program, self.folder / "run"))
        self.until(lambda: len(gluray.programs()) == len(programs))
        return programs

    def until(self, done):
        end = time.monotonic() + 20
        while not done():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def refusal(self, act, kind=None):
        with self.assertRaises(kind or gluray.GlurayError) as raised:
            act()
        self.assertNotIn("\n", str(raised.exception))
        return str(raised.exception)


def prepare(module):
    """Gives a test module the names GLURAY, FOLDER, ROWS and gluray, of its command line: GLURAY PYTHON_FOLDER."""
    gluray_program, folder = sys.argv[1:3]
    sys.path.insert(0, folder)
    sys.dont_write_bytecode = True
    for variable in [name for name in os.environ if name.startswith("GLURAY")]:
        del os.environ[variable]
    import gluray
    rows = json.loads(subprocess.run([gluray_program, "settings", "--json"], capture_output=True, check=True, cwd="/",
                                     env={**os.environ, "XDG_CONFIG_HOME": "/nowhere"}).stdout)
    for names in (globals(), module):
        names.update(GLURAY=gluray_program, FOLDER=folder, ROWS=rows, gluray=gluray)
