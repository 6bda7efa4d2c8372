"""Frame lag in a window: windows_test.py GLURAY CLIENT, with an X server at hand.

Compares every frame that the client sees in its window with the frame of the same number without GLuRay. The
time of frames depends on the machine; their order and the last frame do not.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "doors"))
from compare_images import SHARE, differing, images

FRAMES = 8
WIDTH, HEIGHT = 200, 150
HEADER = b"P6\n200 150\n255\n"


def frames_in(data):
    """Pixels by number of the frame, in the order they were seen."""
    found = {}
    while data:
        number, rest = data.split(b"\n", 1)
        end = len(HEADER) + WIDTH * HEIGHT * 3
        found[int(number)] = images(rest[:end])[0][2]
        data = rest[end:]
    return found


class Lag(unittest.TestCase):
    def run_client(self, habit, *options, frames=FRAMES):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            done = subprocess.run([GLURAY, "--shading", "vertex", "--report", report, *options, "--", CLIENT, habit, str(frames)],
                                  capture_output=True, timeout=200)
            seen = json.loads(report.read_text()) if report.exists() else {}
        lines = [line for line in done.stderr.decode().splitlines() if not line.startswith("rest ")]
        self.assertEqual((done.returncode, lines), (0, []), habit)
        self.rests = [line for line in done.stderr.decode().splitlines() if line.startswith("rest ")]
        return frames_in(done.stdout), seen.get("lag", {})

    def expect(self, habit, last, *options, later=FRAMES, mode="on"):
        """All frames that are seen are right, and the last one is seen."""
        plain, _ = self.run_client(habit, "--off")
        ours, lag = self.run_client(habit, "--lag", mode, *options)
        self.assertEqual(list(ours), sorted(ours))
        self.assertIn(last, ours)
        for number, image in ours.items():
            if number in plain:
                self.assertLessEqual(differing(plain[number], image), SHARE * WIDTH * HEIGHT, f"{habit}: frame {number}")
        self.assertGreaterEqual(lag["later"], later)
        return ours, lag

    def test_frames_come_in_order_and_none_is_lost(self):
        ours, _ = self.expect("finished", FRAMES - 1)
        self.assertGreaterEqual(len(ours), FRAMES - 1)  # the test may miss one

    def test_binding_what_is_bound_shows_nothing(self):
        self.expect("binds", FRAMES - 1)

    def test_off_is_off(self):
        _, lag = self.run_client("finished")
        self.assertEqual((lag["later"], lag["atOnce"]), (0, {}))

    def test_both_doors(self):
        for door in ("vendor", "preload"):
            self.expect("finished", FRAMES - 1, "--door", door)

    def test_the_newest_frame_comes_when_the_program_rests(self):
        for mode in ("on", "auto"):
            _, lag = self.expect("still", FRAMES + 1, mode=mode, later=1)
            self.assertGreaterEqual(lag["shownByUs"], 1)
            print(mode, *self.rests)

    def test_a_program_may_leave_with_a_frame(self):
        self.run_client("leaves", "--lag", "on")
        self.run_client("closes-display", "--lag", "on")

    def test_windows_and_contexts_may_go_with_a_frame(self):
        self.expect("destroys-window", FRAMES + 1)
        self.expect("destroys-context", FRAMES - 1)

    def test_forks(self):
        self.expect("forks", FRAMES + 1)

    def test_windows_of_changing_size(self):
        self.expect("resizes", FRAMES + 4)

    def test_another_window_in_between(self):
        self.expect("other-window", FRAMES + 2)

    def test_auto_waits_for_frames_that_follow_each_other(self):
        _, lag = self.run_client("finished", "--lag", "auto", frames=2)
        self.assertEqual(lag["later"], 0)

    def test_a_timeline_shows_the_other_thread(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "t.json")
            self.run_client("finished", "--lag", "on", "--timeline", file)
            events = json.loads(file.read_text().rstrip().rstrip(",") + "]")
        names = {e["tid"]: e["args"]["name"] for e in events if e["name"] == "thread_name"}
        tracing = {names.get(e["tid"]) for e in events if e["name"] == "trace"}
        self.assertIn("traces ahead", tracing)


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)
