"""What tests of gluray's pictures share: a folder, programs that run in it, and pixels of pictures."""
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest

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


class ShotsCase(unittest.TestCase):
    GLURAY = None  # the launcher's file

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        plain = {name: value for name, value in os.environ.items() if not name.startswith("GLURAY_")}
        self.environment = plain | {"XDG_CONFIG_HOME": "/nowhere", "GLURAY_RUNTIME": str(self.folder / "runtime"), "GLURAY_ENGINE": "always"}

    def spawn(self, *words, **more):
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   **{"stderr": subprocess.DEVNULL} | more)
        def end():
            process.stdin.close()
            process.terminate()
            process.stdout.read(), process.stdout.close()
            process.wait(PATIENCE)
        self.addCleanup(end)
        return process

    def gluray(self, *words, **more):
        return subprocess.run([self.GLURAY, *words], cwd=self.folder, env=self.environment, text=True, capture_output=True,
                              timeout=PATIENCE * 5, **more)

    def done(self, *words, **more):
        run = self.gluray(*words, **more)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def refused(self, code, words, part, **more):
        """One line on standard error, of which `part` is a part."""
        run = self.gluray(*words, **more)
        self.assertEqual((run.returncode, run.stdout), (code, ""), run.stderr)
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertIn(part, run.stderr)

    def file(self, name):
        return self.folder / name

    def names(self):
        return sorted(path.name for path in self.folder.iterdir() if path.name != "runtime")
