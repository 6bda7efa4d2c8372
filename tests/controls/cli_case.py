"""Commands for running programs, with a hub that only pretends: the tests of cli_test.py GLURAY and its like."""
import json
import os
import subprocess
import sys

from hub_case import HubCase

GLURAY = os.path.abspath(sys.argv[1])


class CliCase(HubCase):
    ROWS = json.loads(subprocess.run([GLURAY, "settings", "--json"], capture_output=True, check=True, cwd="/",
                                     env={"PATH": os.environ["PATH"], "XDG_CONFIG_HOME": "/nowhere"}).stdout)

    def setUp(self):
        super().setUp()
        self.environment = {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_")}
        self.environment |= {"XDG_CONFIG_HOME": str(self.folder), "GLURAY_RUNTIME": str(self.folder / "run"), "TZ": "UTC"}

    def run_gluray(self, *words):
        return subprocess.run([GLURAY, *words], capture_output=True, text=True, cwd=self.folder, env=self.environment, timeout=30)

    def output(self, *words):
        done = self.run_gluray(*words)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout

    def failure(self, *words, code=1):
        done = self.run_gluray(*words)
        self.assertEqual((done.returncode, done.stderr[:8], done.stderr.count("\n")), (code, "gluray: ", 1), done)
        return done.stderr[8:-1]

    def watch(self, *words, command="watch"):
        process = subprocess.Popen([GLURAY, command, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment, cwd=self.folder)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process
