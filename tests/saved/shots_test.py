"""gluray save, render and shot with a program that runs: shots_test.py GLURAY CLIENT TOOLKIT, with an X server at hand."""
import json
import pathlib
import resource
import signal
import struct
import subprocess
import sys
import time
import unittest

from saved_case import CLIENT, GLURAY, HEIGHT, PATIENCE, TOOLKIT, WIDTH, SavedCase, chunks, pixels, size_of


class Shots(SavedCase):
    def test_a_scene_is_rendered_as_the_window_shows_it(self):
        self.saved()
        said = json.loads(self.done("render", "scene.gluray", "picture.png", "--json").stdout)
        self.assertEqual((said["width"], said["height"], said["notes"]), (WIDTH, HEIGHT, []))
        self.assertEqual(said["scene"]["program"], pathlib.Path(CLIENT).name)
        self.done("shot", "window.png")
        self.assertTrue(pixels(self.file("picture.png")) == pixels(self.file("window.png")))
        self.assertEqual(self.names(), ["picture.png", "scene.gluray", "window.png"])

    def test_toolkits_show_scenes_in_parts_of_their_windows(self):
        self.start(client=(TOOLKIT,))
        self.done("shot", "window.png")
        self.done("save", "scene.gluray")
        self.done("render", "scene.gluray", "picture.png")
        width, height = size_of(self.file("picture.png"))
        self.assertEqual((width, height), (320 - 2 * 40, 240 - 2 * 30))
        view = pixels(self.file("window.png"), "-crop", f"{width}x{height}+40+30", "+repage")
        self.assertTrue(pixels(self.file("picture.png")) == view)

    def test_small_scenes_are_traced_to_be_saved(self):
        self.environment["GLURAY_ENGINE"] = "auto"  # which leaves them to the real OpenGL
        for client in ((CLIENT, "exposed"), (TOOLKIT,)):
            self.start(client=client)
            name = pathlib.Path(client[0]).name
            self.done("save", "-p", name, "scene.gluray")
            self.done("render", "scene.gluray", "picture.png")
            self.assertGreater(len(set(pixels(self.file("picture.png"))[::4])), 20, "surfaces with shades")

    def test_pictures_of_light_are_those_of_programs(self):
        scene = self.saved("--ao", "--set", "ao.samples=4", "--set", "refine.passes=4")
        self.assertGreater(scene.stat().st_size, 1000)
        self.done("render", "scene.gluray", "picture.png")
        self.done("render", "scene.gluray", "dark.png", "--set", "ao.strength=1", "--set", "ao.samples=8")
        self.done("render", "scene.gluray", "off.png", "--set", "ao=false")
        images = [pixels(self.file(name)) for name in ("picture.png", "dark.png", "off.png")]
        self.assertEqual(len(set(images)), 3)

    def test_pictures_have_any_size(self):
        self.saved()
        self.done("render", "scene.gluray", "window.png")
        self.done("render", "scene.gluray", "large.png", "--size", f"{8 * WIDTH}x{8 * HEIGHT}")
        self.assertEqual(size_of(self.file("large.png")), (8 * WIDTH, 8 * HEIGHT))
        small, large = pixels(self.file("window.png")), pixels(self.file("large.png"), "-scale", f"{WIDTH}x{HEIGHT}!")
        apart = sum(abs(a - b) > 40 for a, b in zip(small, large))
        self.assertLess(apart, len(small) / 50, "edges alone")
        self.done("shot", "shot.png", "--size", "400x200", "--spp", "4")
        self.assertEqual(size_of(self.file("shot.png")), (400, 200))
        self.assertEqual(self.names(), ["large.png", "scene.gluray", "shot.png", "window.png"])

    def test_other_programs_read_scenes(self):
        self.saved()
        self.done("save", "program.glb")
        for name in ("scene.glb", "scene.obj", "scene.ply"):
            self.assertIn("MB", self.done("export", "scene.gluray", name).stdout)
        self.assertTrue(self.file("scene.glb").read_bytes() == self.file("program.glb").read_bytes())
        glb = self.file("scene.glb").read_bytes()
        self.assertEqual(struct.unpack("<4sII", glb[:12]), (b"glTF", 2, len(glb)))
        self.assertTrue(self.file("scene.ply").read_bytes().startswith(b"ply\nformat binary_little_endian"))
        self.refused(2, ["export", "scene.gluray", "scene.fbx"], "ends in .glb, .obj or .ply")
        self.refused(1, ["export", "missing.gluray", "x.glb"], "No such file")

    def test_turntables_are_numbered(self):
        self.saved()
        run = self.done("render", "scene.gluray", "turn-%02d.png", "--turntable", "4", "--size", "80x60")
        self.assertIn("turn-01.png to turn-04.png, 4 pictures, 80 x 60", run.stdout)
        self.assertIn("ffmpeg", run.stdout)
        images = [pixels(self.file(f"turn-{number:02d}.png")) for number in range(1, 5)]
        self.assertEqual(len(set(images)), 4)
        self.done("render", "scene.gluray", "front.png", "--size", "80x60", "--no-overlays")
        self.assertTrue(images[0] == pixels(self.file("front.png")))

    def test_they_say_how_they_were_made(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png", "--size", "64x48", "--spp", "4")
        kinds = [kind for kind, _ in chunks(self.file("picture.png"))]
        self.assertIn("sRGB", kinds)
        texts = [content for kind, content in chunks(self.file("picture.png")) if kind == "iTXt"]
        command = next(text for text in texts if text.startswith(b"Command\0")).split(b"\0")[-1].decode()
        self.assertEqual(command, "gluray render scene.gluray picture.png --size 64x48 --set spp=4")
        before = self.file("picture.png").read_bytes()
        self.done(*command.split()[1:])
        self.assertTrue(before == self.file("picture.png").read_bytes())

    def test_backgrounds_can_be_transparent(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png", "--background", "transparent", "--spp", "4")
        alphas = set(pixels(self.file("picture.png"))[3::4])
        self.assertLessEqual({0, 255}, alphas)
        self.assertGreater(len(alphas), 2, "edges are in between")

    def test_what_was_interrupted_goes_on(self):
        self.saved()
        words = [GLURAY, "render", "scene.gluray", "picture.png", "--size", "4096x3072", "--spp", "4"]
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment)
        part = self.file("picture.png.unfinished")
        end = time.monotonic() + PATIENCE
        while not part.exists() or part.stat().st_size < 4096 * 4 * 600:  # a band
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(process.poll(), "it was too fast")
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse(self.file("picture.png").exists())
        self.assertIn("went on from an interrupted run", self.done(*words[1:]).stdout)
        self.assertFalse(part.exists())
        words[3] = "whole.png"
        self.done(*words[1:])
        self.assertTrue(pixels(self.file("picture.png")) == pixels(self.file("whole.png")))

    def test_a_film_that_was_interrupted_goes_on(self):
        self.saved()
        words = [GLURAY, "render", "scene.gluray", "turn-%02d.png", "--turntable", "6", "--size", "1000x750", "--spp", "16"]
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, stdout=subprocess.DEVNULL)
        end = time.monotonic() + PATIENCE
        while not self.file("turn-03.png.unfinished").exists():  # one band a picture
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(process.poll(), "it was too fast")
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.wait()
        before = {name: self.file(name).stat().st_mtime_ns for name in ("turn-01.png", "turn-02.png")}
        self.assertIn("went on from an interrupted run", self.done(*words[1:]).stdout)
        self.assertEqual({name: self.file(name).stat().st_mtime_ns for name in before}, before)
        self.assertEqual(len([name for name in self.names() if name.startswith("turn-")]), 6)

    def test_a_full_disk_leaves_the_last_good_file(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png", "--size", "64x48")
        before = {name: self.file(name).read_bytes() for name in self.names()}
        def full():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (50000, 50000))
        self.refused(1, ["render", "scene.gluray", "picture.png", "--size", "640x480"], "cannot be written: File too large", preexec_fn=full)
        self.file("picture.png.unfinished").unlink()
        self.assertEqual({name: self.file(name).read_bytes() for name in self.names()}, before)

    def test_mistakes_get_one_line(self):
        self.saved()
        self.refused(2, ["save", "scene.png"], "ends in .gluray, or in .glb")
        self.refused(2, ["render", "scene.gluray", "picture.jpg"], "ends in .png")
        self.refused(1, ["render", "scene.gluray", "picture.png", "--size", "0x5"], "use WIDTHxHEIGHT")
        self.refused(1, ["render", "scene.gluray", "picture.png", "--size", "40000x5"], "32768")
        self.refused(1, ["render", "missing.gluray", "picture.png"], "No such file")
        self.refused(2, ["render", "scene.gluray", "picture.png", "--preset", "presentatoin"], "did you mean 'presentation'")
        self.file("text.gluray").write_text("some text")
        self.refused(1, ["render", "text.gluray", "picture.png"], "no saved scene")
        whole = self.file("scene.gluray").read_bytes()
        self.file("half.gluray").write_bytes(whole[:len(whole) // 2])
        self.refused(1, ["render", "half.gluray", "picture.png"], "not whole")
        self.refused(1, ["save", "missing/scene.gluray"], "cannot be written")
        self.assertEqual(self.names(), ["half.gluray", "scene.gluray", "text.gluray"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
