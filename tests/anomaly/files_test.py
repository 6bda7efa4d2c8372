"""GLuRay's files cannot be opened: the program runs, its own check of its image passes, and stderr has one line.

files_test.py GLURAY CLIENT
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

GLURAY, CLIENT = map(pathlib.Path, sys.argv[1:3])


class Files(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def survives(self, line, *options, **environment):
        environment = {**os.environ, "DISPLAY": ":none", "XDG_CONFIG_HOME": str(self.folder), **{k: str(v) for k, v in environment.items()}}
        for door in ("vendor", "preload"):
            done = subprocess.run([GLURAY, "--door", door, *map(str, options), "--", CLIENT, "surfaceless"], env=environment,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, f"{door}: {done.stderr}")
            self.assertEqual(len(done.stderr.splitlines()), 1 if line else 0, f"{door}: {done.stderr}")
            self.assertRegex(done.stderr, line or "^$")

    def test_nothing_is_said_where_nothing_is_wrong(self):
        self.survives("")

    def test_report(self):
        self.survives(r"^gluray: cannot write the report /proc/nowhere/r.json: No such file or directory$", "--report", "/proc/nowhere/r.json")

    def test_log(self):
        self.survives(r"^gluray: cannot write the log file /proc/nowhere/l.txt: No such file or directory; logging to stderr$", "--log", "/proc/nowhere/l.txt")

    def test_log_is_a_folder(self):
        self.survives(r"^gluray: cannot write the log file", "--log", self.folder)

    def test_configuration_that_was_named(self):
        self.survives(r"^gluray: /proc/nowhere/c.toml: No such file or directory$", "--config", "/proc/nowhere/c.toml")

    def test_configuration_that_is_a_folder(self):
        self.survives(r"^gluray: .*: Is a directory$", "--config", self.folder)

    def test_what_is_read_is_never_waited_for(self):
        fifo = self.folder / "fifo"
        os.mkfifo(fifo)
        for option in ("--config", "--program-families"):
            self.survives(f"^gluray: {fifo}: it is a FIFO, not a regular file$", option, fifo)
            self.survives("^gluray: /dev/zero: it is a device, not a regular file$", option, "/dev/zero")

    def test_timeline(self):
        fifo = self.folder / "fifo"
        os.mkfifo(fifo)
        self.survives("^gluray: cannot write the timeline .*/fifo: it is a FIFO, not a regular file; recording ends$", "--timeline", fifo)
        self.assertTrue(fifo.is_fifo())

    def test_log_is_a_device(self):
        self.survives("^gluray: cannot write the log file /dev/full: it is a device, not a regular file; logging to stderr$", "--log", "/dev/full")
        self.survives("", "--log", "/dev/null")

    def test_controls_are_not_sent_to_the_terminal(self):
        self.survives(r"^gluray: /nowhere/\\x1b\[31m\\nred\\u202e: No such file or directory$", "--config", "/nowhere/\x1b[31m\nred\u202e")
        self.survives(r"^gluray: GLURAY_BVH=\\x07: use ", GLURAY_BVH="\x07")
        self.survives(r"^gluray: .*not ray traced.*/nowhere/\\x1b\[31m", GLURAY_ENGINE_LIBRARY="/nowhere/\x1b[31m")

    def test_configuration_that_is_wrong(self):
        file = self.folder / "gluray/gluray.toml"
        file.parent.mkdir()
        file.write_text("threads = 2\nbvh = 'slow'\n")
        self.survives("^gluray: " + re.escape(str(file)) + ":2: bvh = slow: use auto, fast, full, compact or least$")
        file.write_text("threads = = 2\n")
        self.survives("^gluray: " + re.escape(str(file)) + ":1: ")

    def test_engine(self):
        broken = self.folder / "libgluray-engine.so"
        self.survives(r"^gluray: .*not ray traced", GLURAY_ENGINE_LIBRARY="/nowhere/libgluray-engine.so")
        broken.write_bytes(b"no library")
        self.survives(r"^gluray: .*not ray traced", GLURAY_ENGINE_LIBRARY=broken)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
