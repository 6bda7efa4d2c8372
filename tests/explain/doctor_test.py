"""gluray doctor on valid and broken programs and installs.

    doctor_test.py GLURAY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

GLURAY, CLIENTS = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
LIBRARIES = GLURAY.parent.parent.parent / "lib" / "gluray"
CLIENT = CLIENTS / "explain_client"


class Doctor(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def ask(self, *words, gluray=GLURAY, display=True):
        """Exit code and findings by topic."""
        environment = {k: v for k, v in os.environ.items() if display or k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([str(gluray), "doctor", "--json", *map(str, words)], env=environment, capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.stderr, "")
        answer = json.loads(done.stdout)
        self.assertEqual(answer["exitCode"], done.returncode)
        return done.returncode, answer["findings"]

    def finding(self, findings, topic, health="ok"):
        texts = [f["text"] for f in findings if f["topic"] == topic and f["health"] == health]
        self.assertTrue(texts, f"no finding '{topic}' that is {health}: {findings}")
        return texts

    def program(self, name, text, mode=0o755):
        file = self.folder / name
        file.write_text(text)
        file.chmod(mode)
        return file

    def install(self):
        """A copy of the install, for a test to damage."""
        root = self.folder / "install"
        shutil.copytree(LIBRARIES, root / "lib" / "gluray", symlinks=True)
        (root / "bin").mkdir()
        shutil.copy(GLURAY, root / "bin" / "gluray")
        return root / "bin" / "gluray", root / "lib" / "gluray"

    def test_all_is_well(self):
        code, findings = self.ask(CLIENT)
        self.assertEqual(code, 0, findings)
        self.assertIn("explain_client > libGL.so.1", self.finding(findings, "program")[0])
        self.assertIn("vendor", self.finding(findings, "door")[0])
        tracer = self.finding(findings, "ray tracer")
        self.assertRegex(tracer[0], r"Embree \d+\.\d+\.\d+ .*TBB 20\d\d")
        self.assertRegex(tracer[1], r"/libembree\d\.so.*/libtbb\.so")
        self.assertIn("traced", self.finding(findings, "test image")[0])
        self.assertRegex(self.finding(findings, "OpenGL (GLX)")[0], r"\d\.\d")
        self.assertIn("GB of memory", self.finding(findings, "machine")[0])

    def test_programs_of_vtk_get_a_word_about_its_own_light(self):
        _, findings = self.ask(CLIENT)
        self.assertNotIn("light", [f["topic"] for f in findings])
        library = self.folder / "libvtkRenderingOpenGL2-9.9.so.1"
        source = self.program("client.c", "int main(void) { return 0; }")
        empty = self.program("empty.c", "")
        subprocess.run(["cc", "-shared", "-o", library, empty, f"-Wl,-soname,{library.name}"], check=True)
        client = self.folder / "client"
        subprocess.run(["cc", "-o", client, source, "-Wl,--no-as-needed", library, f"-Wl,-rpath,{self.folder}"], check=True)
        _, findings = self.ask(client)
        self.assertIn("switch VTK's own off", self.finding(findings, "light")[0])

    def test_the_text_ends_with_a_summary(self):
        done = subprocess.run([str(GLURAY), "doctor"], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, "all is well"))

    def test_no_display(self):
        code, findings = self.ask(display=False)
        self.assertEqual(code, 1, findings)
        self.finding(findings, "display", "limited")
        self.finding(findings, "OpenGL (EGL)")
        self.finding(findings, "test image")
        code, findings = self.ask(CLIENT, display=False)
        self.assertEqual(code, 2)
        self.assertIn("no display", self.finding(findings, "program", "broken")[0])
        [fix] = [f["fix"] for f in findings if f["topic"] == "program" and "fix" in f]
        self.assertIn("xvfb-run", fix)

    def test_display_that_does_not_answer(self):
        os.environ["DISPLAY"], before = ":987", os.environ["DISPLAY"]
        self.addCleanup(os.environ.__setitem__, "DISPLAY", before)
        code, findings = self.ask()
        self.assertEqual(code, 2)
        self.assertIn("X display", self.finding(findings, "OpenGL (GLX)", "broken")[0])

    def test_programs_that_are_not_there(self):
        code, findings = self.ask("no-such-program")
        self.assertEqual(code, 2)
        self.assertIn("was not found", self.finding(findings, "program", "broken")[0])
        code, findings = self.ask(self.program("data", "x", 0o644))
        self.assertEqual(code, 2)
        self.assertIn("cannot be executed", self.finding(findings, "program", "broken")[0])

    def test_static_programs(self):
        code, findings = self.ask(CLIENTS / "explain_static")
        self.assertEqual(code, 2)
        self.assertIn("statically", self.finding(findings, "program", "broken")[0])

    def test_missing_libraries_of_the_program(self):
        shutil.copy(CLIENTS / "explain_needs_gone", self.folder)
        code, findings = self.ask(self.folder / "explain_needs_gone")
        self.assertEqual(code, 2)
        self.assertIn("libexplain_gone.so is missing; explain_needs_gone needs it",
                      self.finding(findings, "program", "broken")[0])

    def test_programs_that_may_open_opengl_later(self):
        code, findings = self.ask("/bin/true")
        self.assertEqual(code, 1)
        self.finding(findings, "program", "limited")

    def test_scripts(self):
        code, findings = self.ask(self.program("script", "#!/bin/sh\nexit 0\n"))
        self.assertEqual(code, 0, findings)
        self.assertIn("script for /bin/sh", self.finding(findings, "program")[0])
        code, findings = self.ask(self.program("orphan", "#!/nowhere/interpreter\n"))
        self.assertEqual(code, 2)
        self.assertIn("/nowhere/interpreter was not found", self.finding(findings, "program", "broken")[0])

    @unittest.skipUnless(os.geteuid() == 0, "takes root to make a set-uid program of somebody else's")
    def test_set_uid_programs(self):
        file = self.folder / "setuid"
        shutil.copy("/bin/true", file)
        os.chown(file, 65534, 65534)
        file.chmod(0o4755)
        code, findings = self.ask(file)
        self.assertEqual(code, 2)
        self.assertIn("set-uid", self.finding(findings, "program", "broken")[0])

    def test_damaged_installs(self):
        gluray, libraries = self.install()
        self.assertEqual(self.ask(gluray=gluray)[0], 0)
        (libraries / "libgluray.so").unlink()
        code, findings = self.ask(gluray=gluray)
        self.assertEqual(code, 1)
        self.assertIn("libgluray.so is missing", self.finding(findings, "install", "limited")[0])
        for door in libraries.glob("libGLX_gluray.so*"):
            door.unlink()
        code, findings = self.ask(gluray=gluray)
        self.assertEqual(code, 2)
        (libraries / "libgluray-engine.so").unlink()
        code, findings = self.ask(gluray=gluray)
        self.assertEqual(code, 2)
        self.assertIn("missing beside", self.finding(findings, "install", "broken")[0])

    def test_engines_that_do_not_load(self):
        gluray, libraries = self.install()
        (libraries / "libgluray-engine.so").write_bytes(b"no library")
        code, findings = self.ask(gluray=gluray)
        self.assertEqual(code, 2)
        self.finding(findings, "engine", "broken")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
