"""Reports: where they are written, which files they do not touch, and programs that end early.

    reports_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
import unittest

from manners import CLIENTS, GLURAY, Folder, run


class Report(Folder):
    def test_old_report_is_removed(self):
        report = self.folder / "r.json"
        report.write_text("old")
        run(GLURAY, "--report", report, "true")
        self.assertFalse(report.exists())

    def test_off_counts_frames_only(self):
        report = self.folder / "r.json"
        done = run(GLURAY, "--off", "--report", report, CLIENTS / "door_linked_gl")
        seen = json.loads(report.read_text())
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual((seen["off"], seen["frames"], seen["triangles"]["traced"]), (True, 10, 0))

    def test_unwritable_report_is_one_line(self):
        done = run(GLURAY, "--report", "/nowhere/r.json", CLIENTS / "door_linked_gl")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr, "gluray: cannot write the report /nowhere/r.json: No such file or directory\n")

    def test_what_is_no_file_is_left_alone(self):
        victim, folder, fifo = self.folder / "victim", self.folder / "folder", self.folder / "fifo"
        victim.write_text("precious")
        folder.mkdir()
        os.mkfifo(fifo)
        (self.folder / "link").symlink_to(victim)
        (self.folder / "r.json.new").symlink_to(victim)
        for path, why in ((folder, "Is a directory"), (fifo, "it is a FIFO, not a regular file"), (self.folder / "link", "it is a symbolic link"),
                          ("/dev/full", "it is a device")):
            before = os.lstat(path)
            for words in ((), ("sh", "-c", '"$0"; true')):  # the launched program, and its child process
                done = run(GLURAY, "--report", path, "--log", self.folder / "log", *words, CLIENTS / "door_linked_gl")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
            after = os.lstat(path)
            self.assertEqual((after.st_ino, after.st_mode), (before.st_ino, before.st_mode))
            told = (self.folder / "log").read_text().splitlines()
            self.assertTrue(all(line.startswith(f"gluray: cannot write the report {path}: {why}") for line in told), told)
            (self.folder / "log").unlink()
        self.assertEqual(run(GLURAY, "--report", self.folder / "r.json", CLIENTS / "door_linked_gl").returncode, 0)
        self.assertEqual(victim.read_text(), "precious")
        self.assertEqual({p.name for p in self.folder.iterdir()}, {"victim", "folder", "fifo", "link", "r.json", "r.json.new"})

    def test_report_on_standard_output(self):
        for name in ("-", "/dev/stdout"):
            done = run(GLURAY, "--report", name, CLIENTS / "door_linked_gl")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(json.loads(done.stdout[done.stdout.index("{"):])["frames"], 10)
        self.assertIn('"frames": 10', run(GLURAY, "--report", "/dev/stderr", CLIENTS / "door_linked_gl").stderr)

    def test_report_to_nowhere(self):
        done = run(GLURAY, "--report", "/dev/null", CLIENTS / "door_linked_gl")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_programs_with_odd_names(self):
        program = os.fsencode(self.folder / "odd") + b"\xff\x1b[31m"
        shutil.copy(CLIENTS / "door_linked_gl", program)
        report = self.folder / "r.json"
        done = subprocess.run([GLURAY, "--report", report, program], capture_output=True, timeout=100)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.assertEqual(json.loads(report.read_text())["frames"], 10)
        done = subprocess.run([GLURAY, b"no\xff\x1b[31m\nprogram"], capture_output=True, timeout=100)
        self.assertEqual((done.returncode, done.stderr), (127, b"gluray: no\\xff\\x1b[31m\\nprogram: program not found\n"))

    def test_child_of_a_script_reports_in_its_place(self):
        report = self.folder / "r.json"
        run(GLURAY, "--report", report, "sh", "-c", f"{CLIENTS}/door_linked_gl; true")
        self.assertEqual(json.loads(report.read_text())["frames"], 10)

    def test_killed_program_leaves_a_report(self):
        report = self.folder / "r.json"
        run("timeout", "-s", "KILL", "4", GLURAY, "--report", report, "glxgears")
        self.assertGreater(json.loads(report.read_text())["frames"], 0)

    def test_program_killed_at_rest_leaves_its_last_frame(self):
        """Three frames at once, then nothing more."""
        report = self.folder / "r.json"
        script = ("import time\nfrom OpenGL.GLUT import *\nglutInit()\nglutInitDisplayMode(GLUT_DOUBLE)\n"
                  "glutCreateWindow(b'still')\nfor i in range(3): glutSwapBuffers()\ntime.sleep(1000)\n")
        program = subprocess.Popen([GLURAY, "--report", report, "--", "/usr/bin/python3", "-c", script])
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        frames, deadline = 0, time.monotonic() + 60
        while frames < 3 and time.monotonic() < deadline:
            time.sleep(0.1)
            frames = json.loads(report.read_text())["frames"] if report.exists() else 0
        self.assertEqual(frames, 3)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
