"""The launcher's manners, and programs that must survive when something of ours is missing.

    manners_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import errno
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

GLURAY, LIBRARIES, CLIENTS = (pathlib.Path(p) for p in sys.argv[1:4])


def run(*words, **environment) -> subprocess.CompletedProcess:
    variables = dict(os.environ) | {k: str(v) for k, v in environment.items() if v is not None}
    for name in (k for k, v in environment.items() if v is None):
        variables.pop(name, None)
    return subprocess.run([str(w) for w in words], env=variables, capture_output=True, text=True, timeout=100)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)


class Launcher(Folder):
    def test_exit_code_is_the_programs(self):
        self.assertEqual(run(GLURAY, "--", "sh", "-c", "exit 42").returncode, 42)

    def test_run_is_an_alias(self):
        done = run(GLURAY, "run", "--off", "--", "sh", "-c", "echo $GLURAY_OFF")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "1\n", ""))

    def test_options_of_the_program_are_its_own(self):
        done = run(GLURAY, "--bvh", "fast", "echo", "--bvh", "slow", "--help")
        self.assertEqual((done.stdout, done.stderr), ("--bvh slow --help\n", ""))

    def test_settings_reach_the_environment(self):
        done = run(GLURAY, "--threads=3", "--bvh", "compact", "--shading", "vertex", "--renderer", "null", "--spp", "4", "--hud", "--log-level",
                   "debug", "--report", "r.json", "--", "sh", "-c",
                   "echo $GLURAY_THREADS $GLURAY_BVH $GLURAY_SHADING $GLURAY_RENDERER $GLURAY_SPP $GLURAY_HUD $GLURAY_LOG_LEVEL $GLURAY_REPORT")
        self.assertEqual(done.stdout, f"3 compact vertex null 4 1 debug {os.getcwd()}/r.json\n")

    def test_pid_is_kept(self):
        done = run(GLURAY, "sh", "-c", 'test "$GLURAY_PID" = $$')
        self.assertEqual(done.returncode, 0)

    def test_earlier_preload_and_library_path_are_kept(self):
        done = run(GLURAY, "--door", "preload", "sh", "-c", "echo $LD_PRELOAD", LD_PRELOAD="libm.so.6")
        self.assertRegex(done.stdout, r"/libgluray\.so:libm\.so\.6\n$")
        done = run(GLURAY, "--door", "vendor", "sh", "-c", "echo $LD_LIBRARY_PATH", LD_LIBRARY_PATH="/opt/x")
        self.assertEqual(done.stdout, f"{LIBRARIES}:/opt/x\n")

    def test_earlier_vendor_is_the_real_one(self):
        done = run(GLURAY, "sh", "-c", "echo $__GLX_VENDOR_LIBRARY_NAME $GLURAY_REAL_GLX", __GLX_VENDOR_LIBRARY_NAME="mesa")
        self.assertEqual(done.stdout, "gluray mesa\n")

    def test_launched_twice_it_does_not_wrap_itself(self):
        done = run(GLURAY, GLURAY, "sh", "-c", "echo $GLURAY_REAL_GLX $GLURAY_REAL_EGL $LD_LIBRARY_PATH", LD_LIBRARY_PATH=None)
        self.assertRegex(done.stdout, r"^mesa libEGL_mesa\.so\.0 \S+\n$")
        self.assertNotIn(":", done.stdout)

    def test_bad_usage(self):
        for words, line in ((["--bogus", "true"], "--bogus"), ([], "no program given"), (["--threads", "x", "true"], "threads"),
                            (["--bvh", "slow", "true"], "bvh"), (["--door"], "door"), (["--"], "no program given")):
            done = run(GLURAY, *words)
            self.assertEqual(done.returncode, 2, words)
            self.assertRegex(done.stderr, rf"^gluray: .*{line}.*\n$", words)

    def test_missing_and_unrunnable_programs(self):
        done = run(GLURAY, "no-such-program")
        self.assertEqual((done.returncode, done.stderr), (127, "gluray: no-such-program: program not found\n"))
        done = run(GLURAY, "/etc/passwd")
        self.assertEqual((done.returncode, done.stderr), (126, "gluray: /etc/passwd: Permission denied\n"))
        done = run(GLURAY, "/tmp")
        self.assertEqual(done.returncode, 126)

    def test_script_without_interpreter_line(self):
        script = self.folder / "script"
        script.write_text("exit 7\n")
        script.chmod(0o755)
        self.assertEqual(run(GLURAY, script).returncode, 7)

    def test_help_and_version(self):
        done = run(GLURAY, "--help")
        self.assertEqual(done.returncode, 0)
        for option in ("--door", "--report", "--threads", "--bvh", "--shading", "--renderer", "--off", "--log", "--log-level"):
            self.assertIn(option, done.stdout)
        self.assertRegex(run(GLURAY, "--version").stdout, r"^gluray \d+\.\d+\.\d+\n$")

    def test_set_uid_program_is_told_and_run(self):
        if os.getuid() != 0:
            self.skipTest("needs root to make a set-uid program")
        program = self.folder / "true"
        shutil.copy("/bin/true", program)
        os.chown(program, 65534, 65534)
        program.chmod(0o4755)
        done = run(GLURAY, program)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^gluray: not ray traced: .* is set-uid: .*\n$")

    def test_no_display_is_a_hint(self):
        done = run(GLURAY, CLIENTS / "door_linked_gl", DISPLAY=None, WAYLAND_DISPLAY=None)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(re.findall("DISPLAY is not set", done.stderr)), 1)

    def test_mute_x_server_does_not_hang_the_launcher(self):
        import socket
        with socket.socket(socket.AF_UNIX) as mute:
            for number in itertools.count(4242):
                try:
                    mute.bind(f"\0/tmp/.X11-unix/X{number}")
                    break
                except OSError as error:  # another run of this test has that one
                    if error.errno != errno.EADDRINUSE:
                        raise
            mute.listen(5)
            done = run(GLURAY, "true", DISPLAY=f":{number}")
        self.assertEqual(done.returncode, 0)

    def test_moved_tree_works(self):
        tree = self.folder / "moved"
        (tree / "bin").mkdir(parents=True)
        shutil.copy(GLURAY, tree / "bin/gluray")
        shutil.copytree(LIBRARIES, tree / "lib/gluray")
        report = self.folder / "r.json"
        done = run(tree / "bin/gluray", "--report", report, CLIENTS / "door_linked_gl")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(json.loads(report.read_text())["frames"], 10)


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
            for words in ((), ("sh", "-c", '"$0"; true')):  # the launched program, and one that it starts
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
        """Three frames at once, and then nothing for ever."""
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


class Missing(Folder):
    def survives(self, *lines, door="vendor", **environment):
        """The client's own check of its picture passes; stderr has exactly the given lines."""
        done = run(GLURAY, "--door", door, "--", CLIENTS / "door_linked_gl", **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = done.stderr.splitlines()
        self.assertEqual(len(told), len(lines), done.stderr)
        for line, wanted in zip(told, lines):
            self.assertRegex(line, wanted)

    def test_engine_missing(self):
        for door in ("vendor", "preload"):
            self.survives(r"^gluray: .*not ray traced.*nowhere", door=door, GLURAY_ENGINE_LIBRARY="/nowhere/libgluray-engine.so")

    def test_embree_missing(self):
        """The engine as it is, but asking for an Embree that no machine has."""
        engine = self.folder / "libgluray-engine.so"
        text = (LIBRARIES / "libgluray-engine.so").read_bytes()
        engine.write_bytes(re.sub(rb"libembree\d\.so", b"libembreeX.so", text))
        for door in ("vendor", "preload"):
            self.survives(r"^gluray: .*not ray traced.*libembreeX", door=door, GLURAY_ENGINE_LIBRARY=engine)

    def test_engine_is_something_else(self):
        self.survives(r"^gluray: .*no entry point", GLURAY_ENGINE_LIBRARY="libm.so.6")

    def test_real_vendor_is_ourselves(self):
        done = run(CLIENTS / "door_linked_gl", LD_LIBRARY_PATH=LIBRARIES, __GLX_VENDOR_LIBRARY_NAME="gluray",
                   GLURAY_REAL_GLX="libGLX_gluray.so.0")
        self.assertIn("the real OpenGL is GLuRay itself", done.stderr)

    def test_bad_setting_is_one_line(self):
        self.survives(r"^gluray: GLURAY_BVH=slow: use auto, fast, full, compact or least$", GLURAY_BVH="slow")


class Memory(unittest.TestCase):
    def limited(self, kilobytes, door):
        return run("sh", "-c", f'ulimit -v {kilobytes}; exec "$@"', "sh", GLURAY, "--door", door, CLIENTS / "door_linked_gl", GLURAY_THREADS=2,
                   LP_NUM_THREADS=2, MALLOC_ARENA_MAX=2)  # as much memory on any number of cores

    def test_little_address_space(self):
        """The engine stays away where it would not have room. (Below 600 MB Mesa alone crashes now and then.)"""
        shy = "gluray: OpenGL is not ray traced in this program: the limit of its address space (ulimit -v) leaves less than 512 MB\n"
        for door in ("vendor", "preload"):
            for kilobytes in (270_000, 300_000, 330_000):
                self.assertTrue(self.limited(kilobytes, door).stderr.startswith(shy))
            done = self.limited(640_000, door)
            self.assertEqual((done.returncode, done.stderr), (0, shy))
            for kilobytes in (760_000, 850_000, 1_000_000, 4_000_000):
                done = self.limited(kilobytes, door)
                self.assertEqual(done.returncode, 0, f"{kilobytes} kB, {door}: {done.stderr}")
                self.assertLessEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertEqual(done.stderr, "")


class Fonts(unittest.TestCase):
    def test_x_fonts_look_the_same(self):
        """Drivers make the lists of glXUseXFont inside themselves."""
        plain = run(CLIENTS / "door_font")
        self.assertEqual(plain.returncode, 0, plain.stderr)
        for door in ("vendor", "preload"):
            self.assertEqual(run(GLURAY, "--door", door, CLIENTS / "door_font").stdout, plain.stdout)


class Dlopen(Folder):
    def test_other_libraries_and_run_paths_are_left_alone(self):
        """libGLabelPlot.so and a bundled libGL.so.1 are found through the program's RUNPATH."""
        for name in ("door_dlopen", "libGLabelPlot.so", "bundled/libGL.so.1"):
            self.assertTrue((CLIENTS / name).exists(), name)
        plain = run(CLIENTS / "door_dlopen", "libGLabelPlot.so")
        self.assertEqual(plain.stdout, "bundled\n")
        under = run(CLIENTS / "door_dlopen", "libGLabelPlot.so", LD_PRELOAD=LIBRARIES / "libgluray.so")
        self.assertEqual((under.returncode, under.stdout, under.stderr), (0, "bundled\n", ""))

    def test_linked_bundled_library_is_found_by_auto(self):
        done = run(GLURAY, "sh", "-c", "echo $LD_PRELOAD")
        self.assertEqual(done.stdout, "\n")
        done = run(GLURAY, CLIENTS / "door_bundled")
        self.assertIn("libgluray.so", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
