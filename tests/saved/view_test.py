"""gluray view: view_test.py GLURAY CLIENT TOOLKIT VIEW_LIVE ENGINE OUT, with an X server at hand. VIEW_LIVE (apps/panel/view_live.cpp) drives
the window; images of it are left in OUT."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

from saved_case import GLURAY, PATIENCE, SavedCase

VIEW_LIVE, ENGINE = sys.argv[4:6]
OUT = pathlib.Path(sys.argv[6])
QUICK = ("--ao", "--set", "ao.samples=2", "--set", "noise=0.03")


class View(SavedCase):
    def drive(self, scene):
        OUT.mkdir(parents=True, exist_ok=True)
        run = subprocess.run([VIEW_LIVE, ENGINE, GLURAY, scene, str(OUT)], cwd=self.folder, env={**self.environment, "QT_QPA_PLATFORM": "xcb"},
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_scenes_with_light(self):
        self.saved(*QUICK)
        self.drive("scene.gluray")

    def test_the_launcher_opens_the_window(self):
        self.saved(*QUICK)
        viewer = self.spawn(GLURAY, "view", "scene.gluray", "--preset", "draft")
        end = time.monotonic() + PATIENCE
        while "scene.gluray - GLuRay" not in subprocess.run(["xwininfo", "-root", "-tree"], capture_output=True, text=True).stdout:
            self.assertIsNone(viewer.poll())
            self.assertLess(time.monotonic(), end)
            time.sleep(0.1)
        self.assertEqual(pathlib.Path(f"/proc/{viewer.pid}/comm").read_text().strip(), "gluray-panel")

    def test_mistakes_get_one_line(self):
        scene = self.saved()
        whole = scene.read_bytes()
        self.file("damaged.gluray").write_bytes(whole[:len(whole) // 2])
        self.file("other.gluray").write_text("something else")
        self.file("model.glb").write_bytes(whole)
        self.refused(1, ["view", "missing.gluray"], "No such file")
        self.refused(1, ["view", "damaged.gluray"], "damaged.gluray")
        self.refused(1, ["view", "other.gluray"], "other.gluray")
        self.refused(1, ["view", "model.glb"], "end in .gluray")
        self.refused(2, ["view"], "SCENE is required")
        self.refused(2, ["view", "scene.gluray", "--preset", "nothing"], "no such preset")
        self.environment.pop("QT_QPA_PLATFORM", None)
        self.environment["DISPLAY"] = ":98765"
        self.refused(1, ["view", "scene.gluray"], "no display can be reached")
        self.environment.pop("DISPLAY")
        self.refused(1, ["view", "scene.gluray"], "DISPLAY is not set")

    def test_without_qt(self):
        self.saved()
        (self.folder / "bin").mkdir()
        alone = shutil.copy(GLURAY, self.folder / "bin" / "gluray")
        run = subprocess.run([alone, "view", "scene.gluray"], cwd=self.folder, env={**self.environment, "PATH": str(self.folder)},
                             capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout, run.stderr.count("\n")), (1, "", 1), run.stderr)
        self.assertIn("gluray-panel is missing", run.stderr)


if __name__ == "__main__":
    os.environ.pop("WAYLAND_DISPLAY", None)
    unittest.main(argv=sys.argv[:1])
