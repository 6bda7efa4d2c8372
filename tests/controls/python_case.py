"""import gluray from the folder that is tested, and hubs for it: the tests of python_test.py and its like, with GLURAY PYTHON_FOLDER."""
import json
import os
import pathlib
import subprocess
import sys
import time

from hub_case import HubCase
from memory_hub import seek_hub

GLURAY, FOLDER = sys.argv[1:3]
sys.path.insert(0, FOLDER)
sys.dont_write_bytecode = True
for variable in [name for name in os.environ if name.startswith("GLURAY")]:
    del os.environ[variable]
import gluray  # noqa: E402: the one in FOLDER

ROWS = json.loads(subprocess.run([GLURAY, "settings", "--json"], capture_output=True, check=True, cwd="/", env={**os.environ, "XDG_CONFIG_HOME": "/nowhere"}).stdout)

# What $GLURAY is in the tests: `gluray hub` by a hub that pretends.
HUB = """#!{python}
import json, os, signal, sys
sys.path.insert(0, {folder!r})
from memory_hub import FakeHub
if {fails!r} and not ({first!r} and os.fork() == 0):
    sys.exit("gluray: {fails}")
if {first!r}:
    import time
    time.sleep(0.2)
hub = FakeHub(os.environ["GLURAY_RUNTIME"], json.load(open({rows!r})))
signal.signal(signal.SIGTERM, lambda *_: (hub.end(), sys.exit(0)))
hub.add("late", 9)
sys.stdin.read()
hub.end()
"""


class PythonCase(HubCase):
    ROWS = ROWS

    def setUp(self):
        super().setUp()
        os.environ |= {"GLURAY_RUNTIME": str(self.folder / "run"), "GLURAY": "/nowhere/gluray", "XDG_CONFIG_HOME": "/nowhere"}
        self.addCleanup(gluray.hub._drop)

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

    def python(self, code):
        """Runs it in a process of its own, which can be spoken to."""
        return subprocess.Popen([sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env={**os.environ, "PYTHONPATH": FOLDER})

    def own_hub(self, fails="", first=False):
        script, rows = self.folder / "gluray", self.folder / "rows"
        rows.write_text(json.dumps(ROWS))
        script.write_text(HUB.format(python=sys.executable, folder=str(pathlib.Path(__file__).parent), rows=str(rows), fails=fails, first=first))
        script.chmod(0o755)
        os.environ["GLURAY"] = str(script)
