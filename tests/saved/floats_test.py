"""OpenEXR pictures with their layers, and PNG files of 16 bits: floats_test.py GLURAY CLIENT TOOLKIT, with an X server at hand."""
import json
import pathlib
import resource
import signal
import struct
import subprocess
import sys
import time
import unittest

from exr_file import ExrFile
from saved_case import CLIENT, GLURAY, HEIGHT, PATIENCE, WIDTH, SavedCase, chunks, pixels


def encoded(linear):
    """Displayed value of linear light, IEC 61966-2-1, 0 .. 1."""
    linear = min(max(linear, 0), 1)
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def finished_bands(file):
    """Of a picture that is being made (apps/gluray/pictures/files/band_file.cpp)."""
    with file.open("rb") as part:
        head = part.read(52)
    return struct.unpack("=i", head[48:])[0] if len(head) == 52 else 0


class Floats(SavedCase):
    def test_openexr_files_have_the_light_of_the_picture(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png")
        self.done("render", "scene.gluray", "picture.exr")
        exr = ExrFile(self.file("picture.exr"))
        self.assertEqual((exr.width, exr.height), (WIDTH, HEIGHT))
        self.assertEqual(exr.channels, {name: "float" for name in "ABGR"})
        bytes_of_png = pixels(self.file("picture.png"))
        for c, name in enumerate("RGB"):
            shown = [round(255 * encoded(value)) for value in exr.values(name)]
            self.assertLessEqual(max(abs(a - b) for a, b in zip(shown, bytes_of_png[c::4])), 1)
        self.assertEqual(set(exr.values("A")), {1.0})
        self.assertEqual(exr.attributes["Command"], "gluray render scene.gluray picture.exr")
        self.assertEqual(exr.attributes["GLuRay program"], pathlib.Path(CLIENT).name)
        before = self.file("picture.exr").read_bytes()
        self.done(*exr.attributes["Command"].split()[1:])
        self.assertTrue(before == self.file("picture.exr").read_bytes())
        self.done("render", "scene.gluray", "half.exr", "--depth", "16", "--background", "transparent")
        half = ExrFile(self.file("half.exr"))
        self.assertEqual(set(half.channels.values()), {"half"})
        self.assertEqual(set(half.values("A")), {0.0, 1.0})
        self.done("shot", "shot.exr")
        self.assertTrue(ExrFile(self.file("shot.exr")).values("G") == exr.values("G"))
        self.done("render", "scene.gluray", "turn-%02d.exr", "--turntable", "2", "--size", "80x60")
        self.assertEqual(ExrFile(self.file("turn-02.exr")).width, 80)

    def test_openexr_files_have_layers(self):
        self.saved()
        self.done("render", "scene.gluray", "colors.exr", "--spp", "4", "--background", "transparent")
        run = self.done("render", "scene.gluray", "all.exr", "--spp", "4", "--background", "transparent", "--layers", "all")
        exr = ExrFile(self.file("all.exr"))
        for layer, letters in (("albedo", "RGB"), ("normal", "XYZ"), ("position", "XYZ"), ("depth", "Z"), ("CryptoMaterial02", "RGBA")):
            self.assertEqual([exr.channels.get(f"{layer}.{letter}") for letter in letters], ["float"] * len(letters), run.stderr)
        colors = ExrFile(self.file("colors.exr"))
        for name in "RGBA":
            self.assertTrue(exr.values(name) == colors.values(name), "layers change no colours")
        depths, alphas = exr.values("depth.Z"), exr.values("A")
        self.assertEqual([depth < 1e9 for depth in depths], [alpha > 0 for alpha in alphas])
        names = {key.split("/")[2]: value for key, value in exr.attributes.items() if key.startswith("cryptomatte/") and "Object" not in value}
        self.assertEqual(names["hash"], "MurmurHash3_32")
        covers = [exr.values(f"CryptoMaterial{part:02d}.{letter}") for part in range(3) for letter in "GA"]
        self.assertLess(max(abs(sum(cover) - alpha) for *cover, alpha in zip(*covers, alphas)), 1e-5)
        ids = set(exr.values("CryptoMaterial00.R")) - {0.0}
        known = [json.loads(value) for key, value in exr.attributes.items() if key.endswith("/manifest")]
        hashes = {struct.unpack(">f", bytes.fromhex(text))[0] for manifest in known for text in manifest.values()}
        self.assertTrue(ids and ids <= hashes)
        self.done("render", "scene.gluray", "some.exr", "--spp", "4", "--layers", "normal,depth")
        some = ExrFile(self.file("some.exr"))
        self.assertEqual(sorted(some.channels), ["A", "B", "G", "R", "depth.Z", "normal.X", "normal.Y", "normal.Z"])
        self.assertTrue(some.values("depth.Z") == depths)

    def test_png_files_can_have_sixteen_bits(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png")
        self.done("render", "scene.gluray", "deep.png", "--depth", "16")
        found = dict(chunks(self.file("deep.png")))
        self.assertEqual(found["IHDR"][8:10], bytes([16, 2]), "16 bits of red, green and blue")
        self.assertIn("sRGB", found)
        both = zip(pixels(self.file("deep.png")), pixels(self.file("picture.png")))
        self.assertLessEqual(max(abs(a - b) for a, b in both), 1, "halves are rounded otherwise")
        words = subprocess.run(["convert", self.file("deep.png"), "-depth", "16", "rgb:-"], check=True, capture_output=True).stdout
        self.assertGreater(len({words[i:i + 2] for i in range(0, len(words), 2)}), 256)

    def test_pictures_with_layers_that_were_interrupted_go_on(self):
        self.saved()
        self.interrupted("picture.exr", ["--size", "2000x1500", "--spp", "4", "--layers", "normal,depth,material"])
        self.assertTrue(ExrFile(self.file("picture.exr")).rows == ExrFile(self.file("whole.exr")).rows)

    def interrupted(self, name, options):
        """Interrupts a picture after a band, goes on, and makes it at once under the name whole."""
        words = [GLURAY, "render", "scene.gluray", name, *options]
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment)
        part = self.file(name + ".unfinished")
        end = time.monotonic() + PATIENCE
        while not part.exists() or finished_bands(part) == 0:
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(process.poll(), "it was too fast")
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse(self.file(name).exists())
        self.assertIn("went on from an interrupted run", self.done(*words[1:]).stdout)
        self.assertFalse(part.exists())
        words[3] = "whole" + self.file(name).suffix
        self.done(*words[1:])

    def test_a_full_disk_leaves_the_last_good_file(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.exr", "--size", "64x48")
        before = self.file("picture.exr").read_bytes()
        def full():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))
        self.refused(1, ["render", "scene.gluray", "picture.exr", "--size", "640x480"], "cannot be written: File too large", preexec_fn=full)
        self.assertTrue(before == self.file("picture.exr").read_bytes())

    def test_mistakes_get_one_line(self):
        self.saved()
        render = ["render", "scene.gluray"]
        self.refused(2, [*render, "picture.jpg"], "ends in .png or .exr")
        self.refused(2, [*render, "picture.png", "--depth", "32"], "use a name that ends in .exr")
        self.refused(2, [*render, "picture.exr", "--depth", "8"], "16 or 32 bits")
        self.refused(2, [*render, "picture.png", "--layers", "depth"], "PNG files have no layers")
        self.refused(2, ["shot", "picture.png", "--layers", "depth"], "PNG files have no layers")
        self.refused(1, [*render, "picture.exr", "--layers", "depth,nomral"], "--layers nomral: use albedo, normal, position, depth, object, material, or all")
        self.refused(1, [*render, "missing/picture.exr"], "cannot be written")
        self.file("text.exr").write_text("some text")
        self.refused(2, [*render, "text.exr"], "is no OpenEXR file")
        self.assertEqual(self.names(), ["scene.gluray", "text.exr"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
