"""The example of docs/program-families.md: a program that GLuRay does not know, and the file that makes it known.

    rings_test.py GLURAY RINGS RINGS.toml [unittest arguments]
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

GLURAY, RINGS, FAMILY = (pathlib.Path(p).resolve() for p in sys.argv[1:4])
FRAMES, TRIANGLES = 3, 3 * 5 * 160 * 80 * 2  # of all frames
# Both light each pixel: only silhouettes differ, where a ray hits and the rasteriser misses.
TOLERANCE, SHARE = 3, 0.004


class Rings(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_rings(self, *options, **environment):
        """The image's bytes, the report, and the program's messages."""
        image, report = self.folder / "image.ppm", self.folder / "report.json"
        done = subprocess.run([GLURAY, "--report", report, *options, "--", RINGS, str(FRAMES), image],
                              env={**os.environ, **environment}, capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        magic, size, depth, pixels = image.read_bytes().split(b"\n", 3)
        self.assertEqual((magic, size, depth), (b"P6", b"480 360", b"255"))
        return pixels, json.loads(report.read_text()), done.stderr

    def plain(self):
        pixels, _, _ = self.run_rings("--off")
        self.assertGreater(len(set(pixels)), 100, "nothing is to be seen without GLuRay")
        return pixels

    def check_traced(self, *options, **environment):
        expected = self.plain()
        got, report, said = self.run_rings(*options, **environment)
        self.assertEqual(said, "")
        self.assertEqual(report["triangles"], {"traced": TRIANGLES, "rasterised": 0})
        self.assertEqual(report["draws"], {"traced": 3 * 5, "rasterised": {}})
        self.assertEqual(report["bvh"]["builds"], 1)
        self.assertEqual(len(got), len(expected))
        differing = sum(any(abs(got[i + c] - expected[i + c]) > TOLERANCE for c in range(3))
                        for i in range(0, len(got), 3))
        self.assertLessEqual(differing, SHARE * len(got) / 3)

    def check_untraced(self, *options, **environment):
        got, report, said = self.run_rings(*options, **environment)
        self.assertEqual(report["triangles"], {"traced": 0, "rasterised": TRIANGLES})
        self.assertTrue(got == self.plain(), "images differ although nothing was traced")
        return said

    def test_traced_with_its_file(self):
        for door in ("vendor", "preload"):
            with self.subTest(door=door):
                self.check_traced("--door", door, "--program-families", FAMILY)

    def test_traced_with_several_files(self):
        other = self.folder / "other.toml"
        other.write_text('[[family]]\nname = "other"\nmatch.active = ["nothing"]\nmatch.rasterise = "a test"\n')
        self.check_traced("--program-families", other, "--program-families", FAMILY)

    def test_traced_as_the_environment_says(self):
        self.check_traced(GLURAY_PROGRAM_FAMILIES=f":{FAMILY}:")

    def test_traced_as_the_configuration_says(self):
        config = self.folder / "gluray.toml"
        config.write_text(f'program-families = "{FAMILY}"\n')
        self.check_traced("--config", config)

    def test_rasterised_without_its_file(self):
        self.assertEqual(self.check_untraced(), "")

    def test_the_first_family_that_fits_wins(self):
        first = self.folder / "first.toml"
        first.write_text('[[family]]\nname = "first"\nmatch.any = "uColor"\nmatch.strict = false\n'
                         'match.rasterise = "a test"\n')
        self.assertEqual(self.check_untraced("--program-families", first, "--program-families", FAMILY), "")

    def explained(self, *options):
        done = subprocess.run([GLURAY, "explain", "--json", "--frames", str(FRAMES), *options, "--", RINGS],
                              capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        [process] = json.loads(done.stdout)["processes"]
        [program] = process["explain"]["programs"]
        return program

    def test_explain_names_the_family(self):
        program = self.explained("--program-families", FAMILY)
        self.assertEqual((program["family"], program["why"]), ("rings", ""))
        self.assertEqual((program["traced"], program["rasterised"], program["triangles"]), (15, 0, TRIANGLES))
        self.assertEqual(program["attributes"], ["normal", "position"])
        self.assertIn("lightPosition", program["uniforms"])

    def test_explain_says_what_is_missing(self):
        program = self.explained()
        self.assertIsNone(program["family"])
        self.assertEqual((program["traced"], program["rasterised"], program["triangles"]), (0, 15, TRIANGLES))
        self.assertRegex(program["why"], r'^no family fits; nearest: .*, but it lacks ".*" and \d+ more$')
        near = self.folder / "near.toml"
        near.write_text(FAMILY.read_text().replace('material.shininess = "shininess"', "material.shininess = 3"))
        program = self.explained("--program-families", near)
        self.assertEqual(program["why"], 'no family fits; nearest: rings, but it has uniform "shininess" (float), '
                         "which the family does not describe")

    def test_the_table_of_explain_has_them_too(self):
        def text(*options):
            return subprocess.run([GLURAY, "explain", "--frames", "1", *options, "--", RINGS], capture_output=True,
                                  text=True, timeout=100).stdout
        self.assertRegex(text("--program-families", FAMILY),
                         r"\nshader programs\n  program \d+, rings: 5 draws traced, 0 rasterised, 128 000 triangles\n")
        self.assertRegex(text(), r"program \d+, no family fits: 0 draws traced, 5 rasterised, 128 000 triangles\n"
                                 r"    no family fits; nearest: ")

    def test_a_file_with_a_mistake_is_one_line(self):
        bad = self.folder / "bad.toml"
        bad.write_text(FAMILY.read_text() + "lights.colour = 3\n")
        line = bad.read_text().count("\n")
        said = self.check_untraced("--program-families", bad)
        self.assertEqual(said, f'gluray: {bad}:{line}: unknown key "colour"\n')

    def test_a_file_that_is_not_there_is_one_line(self):
        gone = self.folder / "gone.toml"
        done = subprocess.run([GLURAY, "--program-families", gone, "--", RINGS, "1"], capture_output=True, text=True,
                              timeout=100)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        said = self.check_untraced(GLURAY_PROGRAM_FAMILIES=str(gone))
        self.assertEqual(said, f"gluray: {gone}: No such file or directory\n")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
