"""The choice of --engine auto: engine_test.py GLURAY CLIENT (with an X server at hand).

Tiny scenes go to the real OpenGL, large ones are traced from their first frame on, and the images stay the same."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SMALL, MIDDLE, LARGE = 2000, 45000, 150000  # triangles, under 512 x 512 pixels
REASON = "small scene: the real OpenGL is faster"
STREAMS = pathlib.Path(__file__).parent.parent / "streams"


def run(*command, engine=None, before=(), **variables):
    """(lines printed, report)."""
    environment = {k: v for k, v in os.environ.items() if k != "GLURAY_ENGINE"} | variables
    if engine is None:
        done = subprocess.run([*before, *map(str, command)], capture_output=True, text=True, timeout=200, env=environment)
        return done.stdout.split("\n")[:-1], None
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        done = subprocess.run([GLURAY, "--engine", engine, "--shading", "vertex", "--report", report, "--", *map(str, command)],
                              capture_output=True, text=True, timeout=200, env=environment)
        if done.returncode:
            raise AssertionError(f"{command} ended with {done.returncode}: {done.stderr}")
        return done.stdout.split("\n")[:-1], json.loads(report.read_text())


class Engine(unittest.TestCase):
    def same_images(self, plain, seen):
        self.assertEqual(len(plain), len(seen))
        for a, b in zip(plain, seen):
            self.assertEqual(a.split()[0], b.split()[0])
            self.assertAlmostEqual(int(a.split()[1]) / int(b.split()[1]), 1, delta=0.002, msg="sum of colours")

    def test_tiny_scene_is_left_to_the_real_opengl(self):
        for path in ("list", "arrays", "vbo", "immediate"):
            with self.subTest(path):
                plain, _ = run(CLIENT, path, SMALL, 60)
                seen, report = run(CLIENT, path, SMALL, 60, engine="auto")
                self.same_images(plain, seen)
                # On a busy machine a trial may trace three frames.
                self.assertLessEqual(report["draws"]["traced"], 6)
                self.assertEqual(set(report["draws"]["rasterised"]), {REASON})
                self.assertGreaterEqual(report["framesDirect"], 53)

    def test_large_scene_is_traced_from_its_first_frame_on(self):
        for path in ("list", "arrays", "vbo", "immediate"):
            with self.subTest(path):
                plain, _ = run(CLIENT, path, LARGE, 20)
                seen, report = run(CLIENT, path, LARGE, 20, engine="auto")
                self.same_images(plain, seen)
                # On a busy machine frames take long, and a trial may leave three of them to the real OpenGL.
                self.assertLessEqual(set(report["draws"]["rasterised"]), {REASON})
                self.assertGreaterEqual(report["draws"]["traced"], 14)
                _, report = run(CLIENT, path, LARGE, 2, engine="auto")
                self.assertEqual(report["draws"], {"traced": 2, "rasterised": {}})
                self.assertEqual(report["framesDirect"], 0)

    def test_scene_that_changes(self):
        for path in ("list", "vbo", "immediate"):
            with self.subTest(path):
                scenes = (path, SMALL, 40, LARGE, 40, SMALL, 200, LARGE, 5)
                plain, _ = run(CLIENT, *scenes)
                seen, report = run(CLIENT, *scenes, engine="auto")
                self.same_images(plain, seen)
                self.assertGreaterEqual(report["framesDirect"], 39 + 50)
                # Triangles sent by glBegin are counted when they are drawn: the first frame of a larger scene is still direct.
                self.assertGreaterEqual(report["draws"]["traced"], 40 + 5 - (2 if path == "immediate" else 0))

    def test_settings(self):
        _, report = run(CLIENT, "list", SMALL, 20, engine="always")
        self.assertEqual(report["draws"], {"traced": 20, "rasterised": {}})
        _, report = run(CLIENT, "list", LARGE, 20, engine="never")
        self.assertEqual(report["draws"], {"traced": 0, "rasterised": {"switched off": 20}})
        self.assertEqual(report["framesDirect"], 20)

    def test_results_of_trials_are_used_by_the_next_run(self):
        with tempfile.TemporaryDirectory() as folder:
            kept = pathlib.Path(folder) / "gluray/trials" / (pathlib.Path(CLIENT).name + ".json")
            variables = {"GLURAY_REMEMBER_ENGINE": "on", "GLURAY_THREADS": "2", "XDG_CACHE_HOME": folder}
            plain, _ = run(CLIENT, "vbo", MIDDLE, 60)
            for _ in range(5):  # on a busy machine the first frame of a trial may end it
                seen, report = run(CLIENT, "vbo", MIDDLE, 60, engine="auto", **variables)
                if kept.exists():
                    break
            self.same_images(plain, seen)
            engines = json.loads(kept.read_text())["engines"]
            self.assertEqual([(one["renderer"], one["threads"]) for one in engines], [(report["gl"]["renderer"], 2)])
            self.assertAlmostEqual(engines[0]["trials"][0]["triangles"], MIDDLE, delta=0.05 * MIDDLE)
            # A large scene that the real OpenGL has drawn faster is left to it until that was measured.
            trial = engines[0]["trials"][0] | {"triangles": LARGE, "traced": 3.0, "direct": 0.01}
            kept.write_text(json.dumps({"format": 1, "engines": [engines[0] | {"trials": [trial]}]}))
            plain, _ = run(CLIENT, "vbo", LARGE, 20)
            seen, report = run(CLIENT, "vbo", LARGE, 20, engine="auto", **variables)
            self.same_images(plain, seen)
            self.assertGreaterEqual(report["framesDirect"], 6)
            _, report = run(CLIENT, "vbo", LARGE, 2, engine="auto", **variables | {"GLURAY_REMEMBER_ENGINE": "off"})
            self.assertEqual(report["framesDirect"], 0)
            for damaged in ("{", "[]", '{"format": 1, "engines": [7]}'):
                kept.write_text(damaged)
                _, report = run(CLIENT, "vbo", LARGE, 2, engine="auto", **variables)
                self.assertEqual(report["framesDirect"], 0)

    def test_recorded_program(self):
        _, report = run("glretrace", "--benchmark", "--loop=50", STREAMS / "glxgears.trace", engine="auto")
        self.assertGreaterEqual(report["framesDirect"], 20)  # the others are trials on a busy machine

    def test_explanation_names_the_reason(self):
        done = subprocess.run([GLURAY, "explain", "--engine", "auto", "--frames", "20", "--", CLIENT, "list", str(SMALL), "100"],
                              capture_output=True, text=True, timeout=100)
        self.assertRegex(done.stdout, f"surfaces +list .*rasterised: {REASON}")


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)
