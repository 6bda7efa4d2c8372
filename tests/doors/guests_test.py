"""What a program must never lose because of GLuRay: its files, its life and its OpenGL.

    guests_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import fcntl
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import unittest

from manners import CLIENTS, GLURAY, LIBRARIES, Folder, run

DOORS = ("vendor", "preload")
WITHOUT_DISPLAY = {"EGL_PLATFORM": "surfaceless", "DISPLAY": None, "WAYLAND_DISPLAY": None}
CLIENT = CLIENTS / "door_descriptors"
COMPLAINT = {"GLURAY_SPP": "nonsense"}  # makes the engine say a line
ALWAYS = ("--engine", "always")


class Files(Folder):
    def test_messages_stay_out_of_a_file_that_took_the_number_of_stderr(self):
        for door in DOORS:
            for closes in ("", " 2>&-", " 2>&- 1>&-", " 2>&- 1>&- 0>&-"):
                with self.subTest(door=door, closes=closes):
                    done = run("sh", "-c", f'exec "$@"{closes}', "sh", GLURAY, "--door", door, *ALWAYS, "--", CLIENT, "second",
                               self.folder / "data", **WITHOUT_DISPLAY, **COMPLAINT)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual((self.folder / "data").read_text(), "data\n")

    def test_messages_stay_out_of_files_of_programs_without_the_launcher(self):
        done = run("sh", "-c", 'exec "$@" 2>&- 1>&-', "sh", CLIENT, "second", self.folder / "data", LD_LIBRARY_PATH=LIBRARIES,
                   __EGL_VENDOR_LIBRARY_FILENAMES=LIBRARIES / "gluray_egl.json", GLURAY_ENGINE="always", **WITHOUT_DISPLAY, **COMPLAINT)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "data").read_text(), "data\n")

    def test_timeline_and_log_stay_out_of_files_that_took_their_numbers(self):
        for door in DOORS:
            with self.subTest(door=door):
                folder = self.folder / door
                folder.mkdir()
                done = run(GLURAY, "--door", door, *ALWAYS, "--timeline", self.folder / "timeline", "--log", self.folder / "log", "--log-level", "debug",
                           "--report", self.folder / "report", "--", CLIENT, "all", folder, **WITHOUT_DISPLAY)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertTrue((self.folder / "timeline").read_text().startswith("[\n"))
                self.assertGreater(json.loads((self.folder / "report").read_text())["triangles"]["traced"], 0)


class Lives(Folder):
    def start(self, door, **streams):
        variables = {k: v for k, v in os.environ.items() if k not in WITHOUT_DISPLAY} | {"EGL_PLATFORM": "surfaceless"} | COMPLAINT
        return subprocess.run([GLURAY, "--door", door, *ALWAYS, "--", CLIENT, "plain"], env=variables, timeout=60, **streams)

    def test_a_reader_that_has_gone(self):
        for door in DOORS:
            with self.subTest(door=door):
                reader, writer = os.pipe()
                os.close(reader)
                try:
                    self.assertEqual(self.start(door, stderr=writer).returncode, 0)
                finally:
                    os.close(writer)

    def test_a_full_pipe(self):
        for door in DOORS:
            with self.subTest(door=door):
                reader, writer = os.pipe()
                flags = fcntl.fcntl(writer, fcntl.F_GETFL)
                fcntl.fcntl(writer, fcntl.F_SETFL, flags | os.O_NONBLOCK)
                try:
                    while True:
                        os.write(writer, b"x" * 4096)
                except BlockingIOError:
                    fcntl.fcntl(writer, fcntl.F_SETFL, flags)
                try:
                    self.assertEqual(self.start(door, stderr=writer).returncode, 0)
                finally:
                    os.close(reader), os.close(writer)

    def test_a_limit_of_file_sizes(self):
        limited = ("sh", "-c", 'ulimit -f 0; exec "$@"', "sh")
        alone = run(*limited, CLIENT, "plain", **WITHOUT_DISPLAY)  # Mesa 25 itself makes files in memory
        if alone.returncode == -signal.SIGXFSZ:
            self.skipTest("the real OpenGL does not stand the limit")
        for door in DOORS:
            with self.subTest(door=door):
                done = run(*limited, GLURAY, "--door", door, *ALWAYS, "--timeline", self.folder / "t", "--log",
                           self.folder / "log", "--", CLIENT, "plain", **WITHOUT_DISPLAY, **COMPLAINT)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_where_calls_are_forbidden(self):
        for what in ("links", "access"):
            for program in ([CLIENT, "plain"], ["sh", "-c", "exit 42"]):
                with self.subTest(what=what, program=program):
                    done = run(CLIENTS / "door_forbid", what, GLURAY, "--", *program, **WITHOUT_DISPLAY)
                    if done.returncode == 77:
                        self.skipTest("no filters of system calls here")
                    self.assertEqual(done.returncode, 42 if program[0] == "sh" else 0, done.stderr)

    def test_without_proc(self):
        hidden = ["unshare", *(["--mount"] if os.geteuid() == 0 else ["--map-root-user", "--mount"]), "sh", "-c",
                  'mount -t tmpfs none /proc && exec "$@"', "sh"]
        if run(*hidden, "true").returncode != 0:
            self.skipTest("no name spaces of mounts here")
        for door in ("auto", *DOORS):
            for program, code in (([CLIENT, "plain"], 0), (["sh", "-c", "exit 42"], 42)):
                with self.subTest(door=door, program=program):
                    done = run(*hidden, GLURAY, "--door", door, *ALWAYS, "--", *program, **WITHOUT_DISPLAY)
                    self.assertEqual((done.returncode, done.stderr), (code, ""))

    def test_another_libstdcxx_in_the_library_path(self):
        source = self.folder / "old.c"
        source.write_text("int old;\n")
        subprocess.run(["cc", "-shared", "-fPIC", "-Wl,-soname,libstdc++.so.6", "-o", self.folder / "libstdc++.so.6", source], check=True)
        done = run(GLURAY, "--", "sh", "-c", "exit 42", LD_LIBRARY_PATH=self.folder)
        self.assertEqual((done.returncode, done.stderr), (42, ""))


class OpenGl(Folder):
    def traced(self, gluray, *words, door="auto", **environment):
        report = self.folder / "report.json"
        report.unlink(missing_ok=True)
        done = run(gluray, "--door", door, *ALWAYS, "--report", report, "--", *words, **WITHOUT_DISPLAY, **environment)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return report.exists() and json.loads(report.read_text())["triangles"]["traced"] > 0

    def test_scripts_that_change_the_library_path(self):
        for change in ("unset LD_LIBRARY_PATH", "export LD_LIBRARY_PATH=/opt/lib"):
            for door in ("auto", "vendor"):
                with self.subTest(change=change, door=door):
                    self.assertTrue(self.traced(GLURAY, "sh", "-c", f'{change}; exec "$0" plain', CLIENT, door=door))

    def test_scripts_that_change_the_library_path_of_glx_programs(self):
        done = run(GLURAY, "--", "sh", "-c", 'unset LD_LIBRARY_PATH; exec "$0"', CLIENTS / "door_linked_gl")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def moved(self, name):
        """A tree of links to GLuRay's files, in a folder of this name."""
        tree = self.folder / name
        (tree / "bin").mkdir(parents=True), (tree / "lib/gluray").mkdir(parents=True)
        shutil.copy(GLURAY, tree / "bin/gluray")
        for path in LIBRARIES.iterdir():
            if path.name != "gluray_egl.json":
                (tree / "lib/gluray" / path.name).symlink_to(path)
        shutil.copy(LIBRARIES / "gluray_egl.json", tree / "lib/gluray")
        return tree

    def test_folders_with_names_that_lists_cannot_hold(self):
        for name in ("a:b", "a;b", "$LIB", "$ORIGIN", "${PLATFORM}", "a b", 'a"b', "a\\b"):
            tree = self.moved(name)
            for door in ("auto", *DOORS):
                with self.subTest(name=name, door=door):
                    self.assertTrue(self.traced(tree / "bin/gluray", CLIENT, "plain", door=door, XDG_RUNTIME_DIR=self.folder))

    def privileged(self, name):
        """A copy of the client that gets privileges: the loader and Mesa then ignore most variables."""
        os.chmod(self.folder, 0o755)
        program = self.folder / name
        shutil.copy(CLIENT, program)
        program.chmod(0o2755 if name == "group" else 0o755)
        if name == "capabilities":
            kRevision2, kEffective, kBindService = 0x02000000, 1, 1 << 10
            os.setxattr(program, "security.capability", struct.pack("<5I", kRevision2 | kEffective, kBindService, 0, 0, 0))
        return program

    def test_privileged_programs_keep_their_opengl(self):
        nobody = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")
        if os.geteuid() != 0 or run(*nobody, "test", "-x", GLURAY).returncode != 0:
            self.skipTest("only root can give privileges, and nobody must reach GLuRay")
        for name in ("capabilities", "group"):
            program = self.privileged(name)
            self.assertEqual(run(*nobody, program, "plain", **WITHOUT_DISPLAY).returncode, 0)
            for door in ("auto", *DOORS):
                with self.subTest(name=name, door=door):
                    done = run(*nobody, GLURAY, "--door", door, *ALWAYS, "--", program, "plain", **WITHOUT_DISPLAY, HOME=self.folder)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    said = "has file capabilities" if name == "capabilities" else "is set-gid"
                    self.assertRegex(done.stderr, rf"^gluray: not ray traced: .* {said}: .*\n$")

    def test_gluray_that_vanishes(self):
        tree = self.moved("vanishing")
        for door in ("auto", "vendor"):
            with self.subTest(door=door):
                self.traced(tree / "bin/gluray", "sh", "-c", 'mv "$1" "$1.gone"; "$0" plain; outcome=$?; mv "$1.gone" "$1"; exit $outcome', CLIENT,
                            tree / "lib", door=door)

    def test_devices_are_those_of_the_machine(self):
        plain = run(CLIENT, "devices", **WITHOUT_DISPLAY).stdout
        self.assertRegex(plain, "[0-9] devices")
        for door in ("auto", *DOORS):
            done = run(GLURAY, "--door", door, *ALWAYS, "--", CLIENT, "devices", **WITHOUT_DISPLAY)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, plain, ""), door)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
