#!/usr/bin/env python3
"""Scripts refuse unknown options with one line and do nothing."""
import pathlib
import subprocess
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def run(name, *arguments):
    return subprocess.run([str(SCRIPTS / name), *arguments], capture_output=True, text=True, timeout=60)


class Options(unittest.TestCase):
    def test_unknown_options_are_refused(self):
        for name in ("setup", "format", "build", "test", "bench", "root"):
            with self.subTest(name):
                done = run(name, "--no-such-option")
                self.assertEqual((done.returncode, done.stdout if name != "root" else ""), (2, ""))

    def test_help_says_what_a_script_does(self):
        for name in ("setup", "format", "build", "test", "fuzz", "package", "demo", "bench"):
            with self.subTest(name):
                done = run(name, "--help")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertGreater(len(done.stdout), 40)


if __name__ == "__main__":
    unittest.main()
