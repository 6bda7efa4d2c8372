"""A program that runs with a hub of the test's: the tests of link_test.py, hubs_test.py and pictures_test.py GLURAY CLIENT."""
import contextlib
import os
import pathlib
import select
import subprocess
import sys
import tempfile
import time
import unittest

from fake_hub import Hub

GLURAY, CLIENT = sys.argv[1:3]
PATIENCE = 20  # seconds, for what happens at once on an idle machine


def plain_environment():
    """Without settings, but with the engine that tests choose."""
    return {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_") or k == "GLURAY_ENGINE"}


class Linked(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.runtime, self.log = self.folder / "runtime", self.folder / "log"
        self.client, self.code = None, 0
        self.before = ()  # a program that starts the launcher, and its arguments

    def start(self, *options, **variables):
        environment = plain_environment() | {"XDG_CONFIG_HOME": "/nowhere", "GLURAY_RUNTIME": str(self.runtime), **variables}
        with self.log.open("w") as log:
            self.client = subprocess.Popen([*self.before, GLURAY, *options, "--", CLIENT, "exposed"], cwd=self.folder, env=environment, text=True,
                                           stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log)
        self.addCleanup(self.end)
        return self.settled()

    def end(self):
        self.client.stdin.close()
        self.client.stdout.read()
        self.assertEqual(self.client.wait(20), self.code)
        self.client.stdout.close()

    def answer(self):
        """The program's next line that an Expose event did not cause: it is asked to draw when it has drawn nothing for long."""
        while (line := self.client.stdout.readline()).startswith("exposed"):
            pass
        return line.strip()

    def exposed(self):
        """The checksum of the next frame, which an Expose event causes."""
        return self.client.stdout.readline().split()[-1]

    def frame(self):
        print("frame", file=self.client.stdin, flush=True)
        return self.answer()

    def settled(self):
        """The checksum when the frames of the window's first Expose events are drawn."""
        self.frame()
        while select.select([self.client.stdout], [], [], 0.3)[0]:
            os.set_blocking(self.client.stdout.fileno(), False)
            while self.client.stdout.readline():
                pass
            os.set_blocking(self.client.stdout.fileno(), True)
        return self.frame()

    def wait_until(self, done):
        until = time.monotonic() + PATIENCE
        while not done():
            self.assertLess(time.monotonic(), until)
            time.sleep(0.005)

    def frames_until(self, done, patience=PATIENCE):
        """Draws until `done()`; False: it never was."""
        until = time.monotonic() + patience
        while not done():
            if time.monotonic() > until:
                return False
            self.frame()
            time.sleep(0.01)
        return True

    def hub(self):
        hub = Hub(self.runtime)
        self.addCleanup(hub.close)
        return hub

    def connect(self, hub):
        self.assertTrue(self.frames_until(lambda: hub.wait_for_program(0.02)))
        return hub.greet()

    def linked(self, *options, **variables):
        """A program that draws, and the hub that it is connected to."""
        hub = self.hub()
        self.start(*options, **variables)
        self.connect(hub)
        return hub

    def set(self, hub, **members):
        """A `set` of a program that draws."""
        id = self.sent(hub, "set", **members)
        self.frame()
        return hub.result(id)

    @staticmethod
    def sent(hub, type, **members):
        """Sends a request; returns its id when the program has it: requests come in their order, and `get` is answered at once."""
        id = hub.start(type, **members)
        hub.ask("get", names=["ao"])
        return id

    def threads(self):
        names = []
        for task in pathlib.Path(f"/proc/{self.client.pid}/task").iterdir():
            with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # it has ended meanwhile
                names.append((task / "comm").read_text().strip())
        return names

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.client.pid}/fd"))

    def lines(self):
        return self.log.read_text().splitlines()

    def image(self, *options):
        """The checksum in a run of its own."""
        words = [GLURAY, "--set", "control=off", *options, "--", CLIENT]
        environment = plain_environment() | {"XDG_CONFIG_HOME": "/nowhere"}
        done = subprocess.run(words, input="frame\n" * 3, capture_output=True, text=True, timeout=60, env=environment, check=True, cwd="/")
        return done.stdout.split()[-1]
