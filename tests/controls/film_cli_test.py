"""gluray film, with a hub that only pretends: film_cli_test.py GLURAY."""
import json
import os
import pty
import signal
import subprocess
import sys
import threading
import time
import unittest

from cli_case import GLURAY, CliCase
from memory_hub import IMAGE, image_of

PATIENCE = 40  # seconds, on a machine that has much to do


class FilmCase(CliCase):
    def one(self, draws=1):
        hub = self.hub()
        program = hub.add("paraview", 4242)
        program.draws = draws
        return hub, program

    def images(self):
        return sorted(file.name for file in self.folder.glob("*.png"))

    def start(self, *words, **more):
        process = subprocess.Popen([GLURAY, "film", *words], stdout=subprocess.PIPE, text=True, env=self.environment, cwd=self.folder,
                                   **{"stderr": subprocess.PIPE, **more})
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def until(self, done):
        end = time.monotonic() + PATIENCE
        while not done():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)


class Film(FilmCase):
    def test_images_are_numbered(self):
        _, program = self.one()
        self.assertEqual(self.output("film", "a-%02d.png", "--frames", "3"),
                         "paraview (4242): 3 images, a-01.png to a-03.png, 5 x 3\n"
                         "As a film: ffmpeg -framerate 25 -i a-%02d.png -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p a.mp4\n")
        self.assertEqual(self.images(), ["a-01.png", "a-02.png", "a-03.png"])
        self.assertEqual(image_of(self.folder / "a-03.png"), (5, 3, IMAGE))
        self.assertIn(" -frames:v 2 ", self.output("film", "a-%02d.png", "--frames", "2"))  # a third is still there
        self.assertEqual(self.output("film", "b.png", "--frames", "1"), "paraview (4242): 1 image, b-0001.png, 5 x 3\n")
        self.assertEqual(program.live, {})

    def test_missed_frames_are_counted(self):
        self.one(draws=3)
        self.assertIn("; 4 frames between them missed\n", self.output("film", "a.png", "--frames", "3"))
        found = json.loads(self.output("film", "a.png", "--frames", "2", "--json"))
        self.assertEqual(found, {"program": 1, "name": "paraview", "pid": 4242, "files": ["a-0001.png", "a-0002.png"], "frames": [1054, 1057], "missed": 2, "unfinished": 0})

    def test_images_are_of_later_frames(self):
        _, program = self.one(draws=0)
        counted = iter([5, 5, 4, 6, 6, 9])
        answer = program.call
        def call(request):
            program.frame = next(counted) if request["name"] == "shot" else program.frame
            return answer(request)
        program.call = call
        self.assertEqual(json.loads(self.output("film", "a.png", "--frames", "3", "--json"))["frames"], [5, 6, 9])

    def test_unknown_frames(self):
        _, program = self.one()
        program.frame = None
        self.assertEqual(json.loads(self.output("film", "a.png", "--frames", "2", "--json"))["frames"], [None, None])

    def test_settings_vary(self):
        _, program = self.one()
        program.live = {"lights.azimuth": 7}
        seen, answer = [], program.call
        def call(request):
            if request["name"] == "shot":
                seen.append(dict(program.live))
            return answer(request)
        program.call = call
        self.output("film", "a.png", "--frames", "3", "--set", "lights.azimuth=0..90", "--set", "ao.samples=1..2")
        self.assertEqual(seen, [{"lights.azimuth": azimuth, "ao.samples": samples} for azimuth, samples in ((0, 1), (45, 2), (90, 2))])
        self.assertEqual((program.live, len(program.steps)), ({"lights.azimuth": 7}, 1))
        self.assertIsInstance(seen[0]["ao.samples"], int)

    def test_the_first_frame_with_the_values_counts(self):
        _, program = self.one(draws=1)
        answer = program.set
        program.set = lambda request: answer(request) | {"frame": program.frame + 3}  # two frames before it are shown
        self.assertEqual(json.loads(self.output("film", "a.png", "--frames", "2", "--set", "spp=1..2", "--json"))["frames"], [1045, 1048])

    def test_settings_are_given_back_where_it_fails(self):
        _, program = self.one()
        answer = program.call
        program.call = lambda request: {"why": "its window is gone"} if program.live.get("spp") == 3 else answer(request)
        done = self.run_gluray("film", "a.png", "--frames", "4", "--set", "spp=1..4")
        self.assertEqual((done.returncode, done.stderr), (1, "gluray: paraview (4242): its window is gone\n"))
        self.assertTrue(done.stdout.startswith("paraview (4242): 2 images, a-0001.png to a-0002.png, 5 x 3\nAs a film: "))
        self.assertEqual((program.live, self.images()), ({}, ["a-0001.png", "a-0002.png"]))
        program.refuses["spp"] = "not now"
        self.assertIn("paraview (4242): not now", self.run_gluray("film", "a.png", "--frames", "4", "--set", "spp=1..4").stderr)

    def test_interrupts(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            hub, program = self.one()
            film = self.start("a.png", "--frames", "1000000", "--set", "spp=1..2")
            self.until(lambda: len(self.images()) > 3)
            film.send_signal(number)
            out, error = film.communicate(timeout=PATIENCE)
            self.assertEqual((film.returncode, error), (0, ""))
            self.assertTrue(out.startswith(f"paraview (4242): {len(self.images())} images, a-0001.png to "), out)
            self.assertEqual(program.live, {})
            hub.end()
            for name in self.images():
                (self.folder / name).unlink()

    def test_seconds(self):
        self.one()
        begin = time.monotonic()
        self.output("film", "a.png", "--seconds", "2")
        self.assertLess(1.9, time.monotonic() - begin)
        self.assertGreater(len(self.images()), 1)

    def test_progress_on_a_terminal(self):
        self.one()
        main, other = pty.openpty()
        film = self.start("a.png", "--frames", "2", stderr=other)
        film.wait(PATIENCE)
        os.close(other)
        said = os.read(main, 1000).decode()
        os.close(main)
        self.assertEqual(said, "\r\x1b[K1 of 2 images\r\x1b[K2 of 2 images\r\x1b[K")

    def test_mistakes(self):
        hub, _ = self.one()
        (self.folder / "a-0002.png").write_text("notes")
        for words, line in ((("a.jpg", "--frames", "2"), "ends in .png"), (("a-%s.png", "--frames", "2"), "use one %d"), (("a.png",), "use --frames N or --seconds S"),
                            (("a.png", "--frames", "2"), "a-0002.png exists and is no PNG file"), (("b.png", "--frames", "0"), "--frames"),
                            (("b.png", "--seconds", "1", "--set", "spp=1..2"), "--set needs --frames"), (("b.png", "--frames", "2", "--set", "spp=1"), "use NAME=FROM..TO"),
                            (("b.png", "--frames", "2", "--set", "sppp=1..2"), "did you mean 'spp'"), (("b.png", "--frames", "2", "--set", "ao=0..1"), "one number"),
                            (("b.png", "--frames", "2", "--set", "spp=0..2"), "spp = 0: use a number"), (("b.png", "--frames", "2", "--passes", "0"), "--passes"), ((), "FILE")):
            self.assertIn(line, self.failure("film", *words, code=2))
        self.assertEqual(hub.requests, [])
        hub.add("vmd", 77)
        self.assertEqual(self.failure("film", "b.png", "--frames", "2"), "several programs run; choose one with -p")
        done = self.run_gluray("film", "-p", "1", "nowhere/b.png", "--frames", "2")
        self.assertEqual((done.returncode, done.stdout), (1, "paraview (4242): 0 images\n"))
        self.assertIn("No such file", done.stderr)


class Passes(FilmCase):
    """Its image has one more pass in each state, up to 6 or until its noise is 0.01."""

    def refining(self, noise=lambda passes: 1.0):
        hub, program = self.one()
        hub.passes, hub.frozen, hub.taken = 0, False, []
        answer_set, answer_call = program.set, program.call
        def change(request):
            hub.passes = 0
            program.frame += 1
            return answer_set(request)
        def call(request):
            if request["name"] == "shot":
                hub.taken.append(hub.passes)
            return answer_call(request)
        program.set, program.call = change, call
        ended = threading.Event()
        def tell():
            while not ended.wait(0.02):
                with hub.lock:
                    hub.passes = hub.passes if hub.frozen else min(hub.passes + 1, 6)
                    hub.tell({"type": "event", "what": "state", "program": 1, "state": {"frame": program.frame, "passes": hub.passes, "noise": noise(hub.passes)}})
        thread = threading.Thread(target=tell)
        thread.start()
        self.addCleanup(thread.join)
        self.addCleanup(ended.set)
        return hub, program

    def test_images_have_passes(self):
        hub, program = self.refining()
        self.output("film", "a.png", "--frames", "3", "--passes", "4", "--set", "spp=1..3")
        self.assertTrue(len(hub.taken) == 3 and min(hub.taken) >= 4, hub.taken)
        self.assertEqual([r["what"] for r in hub.requests if r["type"] == "observe"], [["state"]])

    def test_finished_images_are_taken(self):
        hub, program = self.refining(lambda passes: 0.01 if passes >= 3 else 1.0)
        self.assertIn("; 2 images with fewer new passes\n", self.output("film", "a.png", "--frames", "2", "--passes", "9", "--set", "spp=1..2"))
        self.assertTrue(min(hub.taken) >= 3, hub.taken)

    def test_images_with_most_passes_are_taken(self):
        hub, program = self.refining()
        program.live["refine.passes"] = 5
        self.assertEqual(json.loads(self.output("film", "a.png", "--frames", "2", "--passes", "9", "--json"))["unfinished"], 2)
        self.assertTrue(min(hub.taken) >= 5, hub.taken)

    def test_the_same_image_again_is_not_waited_for(self):
        hub, program = self.refining()
        begin = time.monotonic()
        self.output("film", "a.png", "--frames", "8", "--passes", "4", "--set", "spp=1..2")
        self.assertEqual([r["values"] for r in hub.requests if r["type"] == "set"], [{"spp": 1}, {"spp": 2}, {"spp": None}])
        self.assertTrue(len(hub.taken) == 8 and min(hub.taken) >= 4 and time.monotonic() < begin + 12, hub.taken)  # six images again, 4 s each

    def test_images_without_passes_are_taken(self):
        hub, program = self.refining()
        hub.frozen = True
        begin = time.monotonic()
        self.assertIn("; 1 image with fewer new passes\n", self.output("film", "a.png", "--frames", "1", "--passes", "4"))
        self.assertTrue(3 < time.monotonic() - begin < 30)  # not the 60 s that --passes waits at most

    def test_interrupt_while_it_waits(self):
        hub, program = self.refining()
        hub.frozen = True
        film = self.start("a.png", "--frames", "2", "--passes", "4")
        self.until(lambda: any(r["type"] == "observe" for r in hub.requests))
        time.sleep(0.5)
        film.send_signal(signal.SIGINT)
        out, error = film.communicate(timeout=PATIENCE)
        self.assertEqual((film.returncode, out, error), (0, "paraview (4242): 0 images\n", ""))

    def test_programs_that_do_not_refine(self):
        _, program = self.one()
        program.live["refine.idle"] = False
        self.assertEqual(self.failure("film", "a.png", "--frames", "2", "--passes", "4"),
                         "paraview (4242): --passes needs refine.idle = true; use gluray set refine.idle=on")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
