#!/usr/bin/env python3
"""If scripts/root lacks something, it says so in one line and changes nothing."""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "root"
CANNOT = 77  # exit code: such a system cannot be made here


class Root(unittest.TestCase):
    def run_with(self, stand_ins, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            for name, text in stand_ins.items():
                (place / name).write_text(f"#!/bin/bash\n{text}\n")
                (place / name).chmod(0o755)
            environment = {**os.environ, "PATH": f"{place}:{os.environ['PATH']}", "GLURAY_ROOTS": str(place / "roots")}
            done = subprocess.run([str(ROOT), *arguments], env=environment, capture_output=True, text=True, timeout=60)
            self.assertEqual(list(place.glob("roots/*/*")), [])
        return done

    def test_takes_root(self):
        done = self.run_with({"id": "echo 1000"}, "trixie")
        self.assertEqual(done.returncode, CANNOT)
        self.assertEqual(done.stderr, "root: making a system in a folder takes root: run it with sudo\n")

    def test_names_a_mirror_that_does_not_answer(self):
        done = self.run_with({"id": "echo 0", "unshare": "exit 0", "debootstrap": "echo E: no network; exit 1"}, "bookworm")
        self.assertEqual(done.returncode, CANNOT)
        self.assertIn("debootstrap failed", done.stderr)
        self.assertIn("E: no network", done.stderr)

    def test_knows_its_releases(self):
        self.assertEqual(self.run_with({}, "sid").returncode, 2)
        self.assertEqual(self.run_with({}, "trixie", "--all").returncode, 2)


if __name__ == "__main__":
    unittest.main()
