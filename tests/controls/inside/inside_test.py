"""gluray.enable() and its like: each case is a Python process that draws. inside_test.py GLURAY PYTHON_FOLDER [unittest arguments]"""
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap
import unittest

GLURAY, FOLDER = sys.argv[1:3]
HERE = pathlib.Path(__file__).resolve().parent
GREEN = "(0, 255, 0, 255)"


class Inside(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("GLURAY", "DISPLAY", "__EGL", "__GLX"))}
        self.environment = {**kept, "GLURAY": GLURAY, "GLURAY_RUNTIME": str(self.folder / "run"), "XDG_CONFIG_HOME": "/nowhere",
                            "PYTHONPATH": f"{FOLDER}:{HERE}", "PYTHONDONTWRITEBYTECODE": "1"}

    def run_python(self, text, *words, before=(sys.executable,), **variables):
        script = self.folder / "script.py"
        script.write_text("import os, sys\nimport gluray\nfrom egl_drawing import Window\n" + textwrap.dedent(text))
        return subprocess.run([*before, script, *words], capture_output=True, text=True, timeout=100, cwd=self.folder,
                              env={**self.environment, **variables})

    def lines(self, text, **more):
        done = self.run_python(text, **more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def test_enabled_process_is_traced(self):
        said = self.lines("""
            print(gluray.enable(engine="always", ao_samples=7))
            print(Window().draw(3))
            print(gluray.report()["triangles"], gluray.enabled(), gluray.this_process().get("ao.samples"))
        """)
        self.assertEqual(said, ["gluray: what this process draws is ray traced, with engine=always, ao_samples=7", "True", GREEN,
                                "{'rasterised': 0, 'traced': 600} True 7"])

    def test_settings_before_and_after_the_first_window(self):
        said = self.lines("""
            gluray.enable({"engine": "always"}, quiet=True)
            print(gluray.set(spp=4, ao=True))
            gluray.set(ao=None)
            window = Window()
            window.draw()
            own = gluray.this_process()
            print(own.get("spp"), own.get("engine"), own.why("spp")["layer"], own.get("ao"))
            gluray.set({"ao.samples": 9}, shadows=True)
            window.draw()
            print(own["ao.samples"], own["shadows"])
            gluray.undo()
            print(own["shadows"])
            with gluray.settings(spp=1):
                print(own["spp"])
            print(own["spp"])
        """)
        self.assertEqual(said, ["{}", "4 always command line False", "9 True", "False", "1", "4"])

    def test_after_the_first_window_it_is_too_late(self):
        said = self.lines("""
            window = Window()
            print(window.draw())
            print(gluray.enable(engine="always"))
            print(window.draw(), gluray.enabled(), gluray.disable())
            try:
                gluray.report()
            except gluray.GlurayError as error:
                print(error)
        """)
        self.assertEqual(said[0], GREEN)
        self.assertRegex(said[1], r"^gluray: not enabled: OpenGL is in use in this process \(libEGL_\w+\.so\S*\); call it before the first window")
        self.assertEqual(said[2:4], ["False", f"{GREEN} False False"])
        self.assertIn("gluray.enable()", said[4])

    def test_disabled_before_the_first_window(self):
        said = self.lines("""
            before = dict(os.environ)
            gluray.enable(engine="always")
            print(gluray.disable(), dict(os.environ) == before, gluray.enabled())
            print(Window().draw(), gluray.this_process())
        """)
        self.assertEqual(said[1:], ["gluray: disabled", "True True False", f"{GREEN} None"])

    def test_disabled_later_and_enabled_again(self):
        said = self.lines("""
            gluray.enable(engine="always", quiet=True)
            window = Window()
            counts = []
            def draw():
                window.draw(2)
                counts.append(gluray.report()["triangles"]["traced"] if gluray.this_process() else None)
            draw()
            gluray.disable(quiet=True)
            draw()
            gluray.enable(engine="always", quiet=True)
            draw()
            print(counts)
        """)
        self.assertEqual(said, ["[400, 400, 800]"])

    def test_wrong_settings_are_refused(self):
        said = self.lines("""
            for values in ({"ao.sampels": 3}, {"engine": "perhaps"}):
                try:
                    print(gluray.enable(values))
                except gluray.GlurayError as error:
                    print(error)
            print(gluray.enabled(), "GLURAY_PID" in os.environ)
        """)
        self.assertIn("ao.samples", said[0])
        self.assertIn("engine", said[1])
        self.assertEqual(said[2:], ["False False"])

    def test_without_the_program(self):
        said = self.lines("print(gluray.enable(), Window().draw())", GLURAY="/nowhere/gluray")
        self.assertRegex(said[0], "^gluray: not enabled: /nowhere/gluray: ")
        self.assertEqual(said[1], f"False {GREEN}")

    def test_what_it_cannot_ask_itself(self):
        said = self.lines("""
            gluray.enable(engine="always", quiet=True)
            window = Window()
            window.draw()
            own = gluray.this_process()
            for act in (lambda: own.shot("a.png"), own.state, lambda: own.set({"no.such": 1}), lambda: own._ask({"type": 3})):
                try:
                    print(act())
                except gluray.GlurayError as error:
                    print(error)
        """)
        self.assertEqual(len(said), 4)
        self.assertIn("cannot ask itself for 'call'", said[0])
        self.assertIn("gluray.report()", said[1])
        self.assertIn("no.such", said[2])

    def test_children_say_nothing(self):
        said = self.lines("""
            import subprocess
            gluray.enable(engine="always", quiet=True)
            child = [sys.executable, "-c", "from egl_drawing import Window; print(Window().draw())"]
            print(subprocess.run(child, capture_output=True, text=True))
        """)
        self.assertIn(f"returncode=0, stdout='{GREEN}\\n', stderr=''", said[0])

    def test_as_a_module(self):
        text = "print(sys.argv[1:], Window().draw(), gluray.report()['triangles']['traced'])"
        for options in ((), ("--set", "ao=on", "--")):
            done = self.run_python(text, "one", "--two", before=(sys.executable, "-m", "gluray", "--engine", "always", *options), DISPLAY=":none")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout, f"['one', '--two'] {GREEN} 200\n")
        done = self.run_python(text, before=(sys.executable, "-m", "gluray", "--no-such-option"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("--no-such-option", done.stderr)

    def test_shell_with_the_variables(self):
        done = subprocess.run(["sh", "-c", f'eval "$({GLURAY} environment --engine always --set ao=on)"; exec "$0" "$@"', sys.executable, "-c",
                               "import gluray; from egl_drawing import Window; Window().draw(); print(gluray.report()['triangles']['traced'],"
                               "gluray.this_process().get('ao'))"], capture_output=True, text=True, env=self.environment)
        self.assertEqual((done.stdout, done.stderr), ("200 True\n", ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
