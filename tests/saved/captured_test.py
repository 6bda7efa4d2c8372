"""gluray run --shot: captured_test.py GLURAY CLIENT, with an X server at hand."""
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from shots_case import PATIENCE, ShotsCase, pixels, size_of

GLURAY, CLIENT = sys.argv[1:3]
SERIES = pathlib.Path(__file__).resolve().parent / "series.py"
PYTHON = "/usr/bin/python3"  # Debian's own, for which Debian's VTK is built
HAS_VTK = subprocess.run([PYTHON, "-c", "import vtk"], capture_output=True).returncode == 0


class Captured(ShotsCase):
    GLURAY = GLURAY

    def wait_for(self, name):
        end = time.monotonic() + PATIENCE
        while name not in self.names():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def run_frames(self, count, *options):
        return self.gluray("run", *options, "--", CLIENT, input="frame\n" * count)

    def test_a_frame_by_its_number(self):
        run = self.run_frames(3, "--shot", "second.png", "--shot-at", "2")
        self.assertEqual((run.returncode, run.stderr), (0, "gluray: second.png: frame 2\n"))
        self.assertEqual(len(run.stdout.splitlines()), 3, "the program's own output")
        self.assertEqual((self.names(), size_of(self.file("second.png"))), (["second.png"], (160, 120)))
        self.run_frames(2, "--shot", "scene.gluray", "--shot-at", "2")
        self.done("render", "scene.gluray", "rendered.png")
        self.assertTrue(pixels(self.file("rendered.png")) == pixels(self.file("second.png")))
        self.assertGreater(len(set(pixels(self.file("second.png"))[::4])), 20, "surfaces with shades")

    def test_openexr_files(self):
        run = self.run_frames(1, "--shot", "light.exr", "--shot-at", "1", "--layers", "depth")
        if "built without OpenEXR" in run.stderr:
            self.skipTest("OpenEXR")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue(self.file("light.exr").read_bytes().startswith(b"\x76\x2f\x31\x01"))

    def test_each_second_frame(self):
        run = self.run_frames(5, "--shot", "step-%02d.png", "--shot-at", "every:2", "--size", "320x240", "--no-overlays")
        self.assertEqual(run.stderr, "gluray: step-01.png: frame 2\ngluray: step-02.png: frame 4\n")
        self.assertEqual(self.names(), ["step-01.png", "step-02.png"])
        self.assertEqual(size_of(self.file("step-02.png")), (320, 240))

    def test_the_last_frame_of_a_program_that_ends(self):
        run = self.run_frames(3, "--shot", "last.glb")
        self.assertIn("gluray: last.glb: frame 3\n", run.stderr)
        self.assertTrue(self.file("last.glb").read_bytes().startswith(b"glTF"))

    def test_a_program_at_rest(self):
        program = self.spawn(GLURAY, "run", "--shot", "rest.png", "--", CLIENT)
        print("frame\nframe", file=program.stdin, flush=True)
        self.wait_for("rest.png")
        self.assertIsNone(program.poll(), "it goes on")
        print("frame", file=program.stdin, flush=True)
        for _ in range(3):
            self.assertTrue(program.stdout.readline())

    def test_a_time(self):
        start = time.monotonic()
        program = self.spawn(GLURAY, "run", "--shot", "later.png", "--shot-at", "1.5s", "--quit", "--", CLIENT, "always", "30")
        self.assertEqual(program.wait(PATIENCE), 0)
        self.assertGreater(time.monotonic() - start, 1.5)
        self.assertEqual(self.names(), ["later.png"])

    def test_the_program_can_be_ended(self):
        program = self.spawn(GLURAY, "run", "--shot", "third.png", "--shot-at", "3", "--quit", "--shot-set", "spp=4", "--", CLIENT, "always", "20")
        self.assertEqual(program.wait(PATIENCE), 0)
        self.assertEqual(self.names(), ["third.png"])

    def test_a_stopped_launcher_ends_the_program(self):
        program = self.spawn(GLURAY, "run", "--shot", "late.png", "--shot-at", "1000000", "--", CLIENT, "always", "20")
        while not any(name.startswith("late.png.scenes") for name in self.names()):
            time.sleep(0.02)
        program.send_signal(signal.SIGTERM)
        program.wait(PATIENCE)
        self.assertEqual(self.names(), [])

    def test_missing_pictures_are_told(self):
        run = self.run_frames(2, "--shot", "x.png", "--shot-at", "9")
        self.assertEqual(run.returncode, 1)
        self.assertIn("the program ended after 2 frames, and --shot-at says 9", run.stderr)
        run = self.gluray("run", "--shot", "x.png", "--", "true")
        self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1))
        self.assertEqual(self.names(), [])

    def test_mistakes_get_one_line(self):
        for words, part in ((["--shot", "x.jpg"], "ends in .png"), (["--shot-at", "3"], "need --shot FILE"),
                            (["--size", "10x10"], "need --shot FILE"), (["--layers", "depth"], "need --shot FILE"),
                            (["--shot", "x.png", "--layers", "depth"], "ends in .exr"), (["--shot", "x.png", "--shot-at", "soon"], "use a frame's number"),
                            (["--shot", "x-%s.png", "--shot-at", "every"], "%04d"),
                            (["--shot", "x.png", "--shot-set", "spp=many"], "spp")):
            self.refused(2, ["run", *words, "--", "true"], part)
        self.refused(1, ["run", "--shot", "missing/x.png", "--", "true"], "cannot be written")
        self.file("x.png").write_text("some text")
        self.refused(2, ["run", "--shot", "x.png", "--", "true"], "x.png")
        self.assertEqual(self.names(), ["x.png"])

    @unittest.skipUnless(HAS_VTK, "Debian's python3-vtk9 or python3-paraview is missing")
    def test_a_batch_program_gives_each_step(self):
        run = self.done("run", "--shot", "step-%d.png", "--shot-at", "every", "--", PYTHON, str(SERIES), "4")
        self.assertEqual(run.stderr.count("frame"), 4, run.stderr)
        for step in range(1, 5):
            self.assertTrue(pixels(self.file(f"step-{step}.png")) == pixels(self.file(f"own-{step}.png")), step)
        self.assertEqual(len({pixels(self.file(f"step-{step}.png")) for step in range(1, 5)}), 4)

    @unittest.skipUnless(HAS_VTK, "Debian's python3-vtk9 or python3-paraview is missing")
    def test_a_crash_leaves_what_was_before(self):
        run = self.gluray("run", "--shot", "step-%d.gluray", "--shot-at", "every", "--", PYTHON, str(SERIES), "6", "4")
        self.assertEqual(run.returncode, 128 + signal.SIGABRT)
        self.assertIn("the program ended by signal 6", run.stderr)
        self.assertEqual([name for name in self.names() if name.startswith("step")], [f"step-{step}.gluray" for step in range(1, 5)])
        self.done("render", "step-4.gluray", "fourth.png")
        self.assertTrue(pixels(self.file("fourth.png")) == pixels(self.file("own-4.png")))

    @unittest.skipUnless(HAS_VTK, "Debian's python3-vtk9 or python3-paraview is missing")
    def test_the_last_picture_of_a_batch_program(self):
        self.done("run", "--shot", "last.png", "--", PYTHON, str(SERIES), "4")
        self.assertTrue(pixels(self.file("last.png")) == pixels(self.file("own-4.png")))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
