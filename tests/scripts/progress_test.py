#!/usr/bin/env python3
"""scripts/progress shows a build's progress and returns its exit code."""
import pathlib
import subprocess
import tempfile
import unittest

PROGRESS = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "progress"
BUILD = 'for i in $(seq 40); do echo "[$i/40] Building CXX object x$i"; done; echo "x.cpp:1: error: what went wrong"; exit {}'


class Progress(unittest.TestCase):
    def shown(self, code):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "build.log")
            done = subprocess.run([str(PROGRESS), "demo", str(log), "bash", "-c", BUILD.format(code)],
                                  capture_output=True, text=True, timeout=60)
            self.assertIn("[17/40]", log.read_text())
            self.assertEqual([file.name for file in log.parent.iterdir()], ["build.log"])
        self.assertEqual(done.returncode, code)
        return done

    def test_a_line_at_each_tenth(self):
        done = self.shown(0)
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 11)
        self.assertEqual(lines[5], "demo: building  50 % (20 of 40 steps)")
        self.assertEqual(done.stderr, "")

    def test_a_failure_is_shown(self):
        self.assertIn("what went wrong", self.shown(3).stderr)


if __name__ == "__main__":
    unittest.main()
