"""The launcher's behaviour, and programs that must survive when a part of GLuRay is missing.

    manners_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import os
import re
import shutil
import socket
import sys
import unittest

from manners import CLIENTS, GLURAY, LIBRARIES, Folder, run


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

    def test_any_setting_is_set(self):
        done = run(GLURAY, "--set", "spp=4", "--set=log-level=debug", "--", "sh", "-c", "echo $GLURAY_SPP $GLURAY_LOG_LEVEL; echo \"$GLURAY_COMMAND_LINE\"")
        self.assertEqual(done.stdout, "4 debug\nspp=4\nlog-level=debug\n\n")
        for pair, line in (("sp=4", "did you mean 'spp'"), ("spp=0", "from 1 (the centre) to 1024"), ("spp", "NAME=VALUE")):
            done = run(GLURAY, "--set", pair, "true")
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(line, done.stderr)

    def listed(self, *words, **environment) -> dict:
        done = run("sh", "-c", 'cd "$0" && exec "$@"', self.folder, GLURAY, "settings", "--json", *words,
                   **{"XDG_CONFIG_HOME": self.folder / "home", "GLURAY_ENGINE": None, "GLURAY_REMEMBER_ENGINE": None} | environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {s["name"]: (s["value"], s["layer"]) for s in json.loads(done.stdout)}

    def test_settings_are_listed_with_their_origins(self):
        (self.folder / "home/gluray").mkdir(parents=True)
        (self.folder / "home/gluray/gluray.toml").write_text("threads = 2\nspp = 2\n[program.viewer]\nlag = \"on\"\n")
        (self.folder / "gluray.toml").write_text("spp = 3\n")
        (self.folder / "gluray.toml").chmod(0o644)
        changed = self.listed("--changed", "--bvh", "fast", "--program", "/usr/bin/viewer", GLURAY_SHADING="vertex")
        self.assertEqual(changed, {"threads": (2, "user"), "spp": (3, "project"), "lag": ("on", "program"),
                                   "shading": ("vertex", "environment"), "bvh": ("fast", "command line")})
        everything = self.listed()
        self.assertEqual((everything["lag"], everything["engine"]), (("off", "built-in"), ("auto", "built-in")))
        self.assertLess(set(changed), set(everything))

    def test_one_setting_is_explained(self):
        done = run(GLURAY, "settings", "--why", "spp", "--spp", 8, GLURAY_SPP=4)
        self.assertEqual(done.returncode, 0)
        for line in ("spp = 8  (command line: --spp)", "a number from 1 (the centre) to 1024", r"built-in +1", r"environment +4  GLURAY_SPP", r"live +-"):
            self.assertRegex(done.stdout, line.replace("(", r"\(").replace(")", r"\)"))
        done = run(GLURAY, "settings", "--why", "sppp")
        self.assertEqual((done.returncode, done.stderr), (2, "gluray: no setting is called 'sppp'; did you mean 'spp'?\n"))

    def test_planted_files_are_not_read(self):
        (self.folder / "gluray.toml").write_text(f"report = \"{self.folder}/planted.json\"\n")
        (self.folder / "gluray.toml").chmod(0o666)
        self.assertEqual(self.listed("--changed"), {})
        done = run("sh", "-c", 'cd "$0" && exec "$@"', self.folder, GLURAY, CLIENTS / "door_linked_gl", XDG_CONFIG_HOME=self.folder)
        self.assertIn("gluray.toml: others may write it", done.stderr)
        self.assertFalse((self.folder / "planted.json").exists())

    def test_a_projects_file_and_a_programs_profile_reach_the_program(self):
        (self.folder / "gluray.toml").write_text(f"timeline = \"{self.folder}/t.json\"\n[program.door_linked_gl]\nreport = \"{self.folder}/r.json\"\n"
                                                 f"[program.other]\nlog = \"{self.folder}/log\"\nlog-level = \"trace\"\n")
        (self.folder / "gluray.toml").chmod(0o644)
        run("sh", "-c", 'cd "$0" && exec "$@"', self.folder, GLURAY, CLIENTS / "door_linked_gl", XDG_CONFIG_HOME=self.folder)
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()), ["gluray.toml", "r.json", "t.json"])

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
        number = 10000 + os.getpid()  # abstract socket names are shared by all processes of the machine
        with socket.socket(socket.AF_UNIX) as mute:
            mute.bind(f"\0/tmp/.X11-unix/X{number}")
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


class Missing(Folder):
    def survives(self, *lines, door="vendor", **environment):
        """The client's own check of its image passes; stderr has exactly the given lines."""
        done = run(GLURAY, "--door", door, "--", CLIENTS / "door_linked_gl", **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = done.stderr.splitlines()
        self.assertEqual(len(told), len(lines), done.stderr)
        for line, wanted in zip(told, lines):
            self.assertRegex(line, wanted)

    def test_door_missing(self):
        """The engine alone: no library that the program would load."""
        tree = self.folder / "part"
        (tree / "bin").mkdir(parents=True), (tree / "lib/gluray").mkdir(parents=True)
        shutil.copy(GLURAY, tree / "bin/gluray"), shutil.copy(LIBRARIES / "libgluray-engine.so", tree / "lib/gluray")
        for door in ("vendor", "preload", "auto"):
            done = run(tree / "bin/gluray", "--door", door, "--", CLIENTS / "door_linked_gl")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, r"^gluray: not ray traced: lib\S+ is missing in \S+/part/lib/gluray: install GLuRay again; .*\n$")

    def test_engine_missing(self):
        for door in ("vendor", "preload"):
            self.survives(r"^gluray: .*not ray traced.*nowhere", door=door, GLURAY_ENGINE_LIBRARY="/nowhere/libgluray-engine.so")

    def test_embree_missing(self):
        """The engine, changed to need an Embree library that no machine has."""
        engine = self.folder / "libgluray-engine.so"
        text = (LIBRARIES / "libgluray-engine.so").read_bytes()
        engine.write_bytes(re.sub(rb"libembree\d\.so", b"libembreeX.so", text))
        shutil.copytree(LIBRARIES / "private", self.folder / "private")
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
                   LP_NUM_THREADS=2, MALLOC_ARENA_MAX=2)  # the same memory on any number of cores

    def test_little_address_space(self):
        """The engine is not loaded where memory is too small for it. (Below 600 MB Mesa alone sometimes crashes.)"""
        shy = r"^gluray: (OpenGL is )?not ray traced.*: limits of the process \(ulimit -v, -d\) leave less than the \d+ MB that OpenGL and ray tracing need\n"
        for door in ("vendor", "preload"):
            for kilobytes in (270_000, 300_000, 330_000):
                self.assertRegex(self.limited(kilobytes, door).stderr, shy)
            done = self.limited(640_000, door)
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr, shy + "$")
            for kilobytes in (760_000, 850_000, 1_000_000, 4_000_000):
                done = self.limited(kilobytes, door)
                self.assertEqual(done.returncode, 0, f"{kilobytes} kB, {door}: {done.stderr}")
                self.assertLessEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertEqual(done.stderr, "")


class Fonts(unittest.TestCase):
    def test_x_fonts_look_the_same(self):
        """Drivers make the lists of glXUseXFont internally."""
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
