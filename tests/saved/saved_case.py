"""What tests of saved scenes have in common: a hub, programs, commands, and files of pictures."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest

GLURAY, CLIENT, TOOLKIT = sys.argv[1:4]
WIDTH, HEIGHT = 160, 120  # of the client's window
PATIENCE = 60  # seconds, on a machine that has much to do


def chunks(file):
    """(type, content) of each chunk of a PNG file."""
    data, at = file.read_bytes(), 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind.decode(), data[at + 8:at + 8 + size]
        at += 12 + size


def size_of(file):
    return struct.unpack(">II", dict(chunks(file))["IHDR"][:8])


def pixels(file, *more):
    """RGBA bytes."""
    return subprocess.run(["convert", str(file), *more, "-depth", "8", "rgba:-"], check=True, capture_output=True).stdout


class SavedCase(unittest.TestCase):
    """A folder, and commands that run there."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        plain = {name: value for name, value in os.environ.items() if not name.startswith("GLURAY_")}
        self.environment = plain | {"XDG_CONFIG_HOME": "/nowhere", "GLURAY_RUNTIME": str(self.folder / "runtime"), "GLURAY_ENGINE": "always"}

    def spawn(self, *words):
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL)
        def end():
            process.stdin.close()
            process.terminate()
            process.stdout.read(), process.stdout.close()
            process.wait(PATIENCE)
        self.addCleanup(end)
        return process

    def start(self, *options, client=(CLIENT, "exposed")):
        self.spawn(GLURAY, "hub", "--with-parent")
        self.client = self.spawn(GLURAY, *options, "--", *client)
        print("frame", file=self.client.stdin, flush=True)
        self.client.stdout.readline()
        end = time.monotonic() + PATIENCE
        while not json.loads(self.gluray("list", "--json").stdout or "[]"):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def gluray(self, *words, **more):
        return subprocess.run([GLURAY, *words], cwd=self.folder, env=self.environment, text=True, capture_output=True, timeout=PATIENCE * 5, **more)

    def done(self, *words):
        run = self.gluray(*words)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refused(self, code, words, part, **more):
        """One line on standard error, of which `part` is a part."""
        run = self.gluray(*words, **more)
        self.assertEqual((run.returncode, run.stdout), (code, ""), run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertIn(part, run.stderr)

    def saved(self, *options):
        self.start(*options)
        self.done("save", "scene.gluray")
        return self.folder / "scene.gluray"

    def file(self, name):
        return self.folder / name

    def names(self):
        return sorted(path.name for path in self.folder.iterdir() if path.name != "runtime")

    def same(self, one, other):
        self.assertTrue(pixels(self.file(one)) == pixels(self.file(other)), f"{one}, {other}")
