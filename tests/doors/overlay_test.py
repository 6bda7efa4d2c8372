"""A frame rate overlay that wraps dlsym (overlay.c), in LD_PRELOAD before and after the preload door, and with the vendor door.

    overlay_test.py GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]
"""
from __future__ import annotations

import json
import sys
import unittest

from manners import CLIENTS, GLURAY, LIBRARIES, Folder, run

OVERLAY, OURS = CLIENTS / "libdoor_overlay.so", LIBRARIES / "libgluray.so"
PROGRAMS = (["door_linked_gl"], ["door_linked_glvnd"], ["door_opened", "local"], ["door_lookup"], ["door_egl", "window"])


class Overlay(Folder):
    def check(self, door, preloaded, shows, **environment):
        """The program draws its ten frames, GLuRay sees them, and the overlay does if `shows`."""
        for program in PROGRAMS:
            for way in ("version", "walk"):
                with self.subTest(door=door, program=program, way=way, **environment):
                    report = self.folder / "r.json"
                    done = run(GLURAY, "--door", door, "--report", report, "--", CLIENTS / program[0], *program[1:],
                               LD_PRELOAD=":".join(map(str, preloaded)), OVERLAY_FINDS=way, **environment)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    seen = json.loads(report.read_text())
                    self.assertEqual((seen["frames"], seen["contexts"]), (10, 1))
                    if shows:
                        self.assertEqual(done.stdout, "overlay: 10 frames\n")

    def test_vendor(self):
        for engine in ("always", "auto"):
            self.check("vendor", [OVERLAY], True, GLURAY_ENGINE=engine)

    def test_preload_before_the_overlay(self):
        """The launcher puts the door first."""
        for engine in ("always", "auto"):
            self.check("preload", [OVERLAY], False, GLURAY_ENGINE=engine)

    def test_preload_after_the_overlay(self):
        for engine in ("always", "auto"):
            self.check("preload", [OVERLAY, OURS], True, GLURAY_ENGINE=engine)

    def test_both_doors(self):
        self.check("vendor", [OURS, OVERLAY], False)
        self.check("vendor", [OVERLAY, OURS], True)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
