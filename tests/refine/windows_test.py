"""Images with light in windows: windows_test.py GLURAY CLIENT, with an X server at hand.

The reference is what the client reads back with very many rays. What only the real OpenGL draws over it must
stay to the bit.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "doors"))
from compare_images import images

WIDTH, HEIGHT = 240, 180
HEADER = b"P6\n240 180\n255\n"
FEW = ("--set", "ao.samples=4", "--set", "ao.radius=0.3")
MANY = ("--set", "ao.samples=1024", "--set", "ao.radius=0.3", "--set", "noise=0")


def images_in(data):
    """Pixels by name, in the order they came; the last of a name counts."""
    found = []
    while data:
        name, rest = data.split(b"\n", 1)
        end = len(HEADER) + WIDTH * HEIGHT * 3
        pixels = images(rest[:end])[0][2]
        found.append((name.decode(), [tuple(pixels[i:i + 3]) for i in range(0, len(pixels), 3)]))
        data = rest[end:]
    return found


def overlaid(x, y):
    """Whether the client's overlay covers the pixel, and a margin around it."""
    return x < 0.2 * WIDTH + 2 or 0.05 * HEIGHT - 2 < y < 0.1 * HEIGHT + 2


def psnr(a, b, skip=lambda x, y: False):
    errors = [sum((u - v) ** 2 for u, v in zip(p, q)) for i, (p, q) in enumerate(zip(a, b))
              if not skip(i % WIDTH, i // WIDTH)]
    return 10 * math.log10(255 ** 2 * 3 * len(errors) / max(sum(errors), 1e-9))


class Refine(unittest.TestCase):
    def run_client(self, habit, *options):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            done = subprocess.run([GLURAY, "--report", report, *options, "--", CLIENT, habit], capture_output=True,
                                  timeout=100)
            self.report = json.loads(report.read_text()) if report.exists() else {}
        self.assertEqual((done.returncode, done.stderr.decode()), (0, ""), habit)
        return images_in(done.stdout)

    def lit(self, habit, *options):
        return dict(self.run_client(habit, "--ao", *FEW, *options))

    def truth(self):
        return self.run_client("reads", "--ao", *MANY)[0][1]

    def check_overlays(self, seen):
        line = [i for i in range(WIDTH * HEIGHT) if 0.06 * HEIGHT < i // WIDTH < 0.09 * HEIGHT]
        self.assertEqual({tuple(seen["last"][i]) for i in line}, {(255, 0, 255)})
        blended = [i for i in range(WIDTH * HEIGHT) if i % WIDTH < 0.19 * WIDTH]
        self.assertEqual([seen["first"][i] for i in blended], [seen["last"][i] for i in blended])

    def test_a_waiting_window_becomes_cleaner(self):
        truth = self.truth()
        seen = self.lit("plain")
        before, after = psnr(seen["first"], truth), psnr(seen["last"], truth)
        print(f"waiting: {before:.1f} dB, then {after:.1f}; {self.report['light']}")
        self.assertGreater(after, before + 6)
        self.assertGreater(after, 38)
        self.assertGreaterEqual(self.report["light"]["idle"]["shown"], 1)
        self.assertGreater(self.report["light"]["idle"]["noise"], 0)

    def test_overlays_stay_to_the_bit(self):
        truth = self.truth()
        seen = self.lit("overlays")
        self.assertGreater(psnr(seen["last"], truth, overlaid), psnr(seen["first"], truth, overlaid) + 6)
        self.check_overlays(seen)

    def test_redrawing_the_same_frame_makes_it_cleaner(self):
        truth = self.truth()
        seen = self.lit("redraws", "--set", "refine.idle=off")
        self.assertGreater(psnr(seen["last"], truth, overlaid), psnr(seen["first"], truth, overlaid) + 6)
        self.assertEqual(self.report["light"]["idle"]["frames"], 0)

    def test_reads_get_finished_images(self):
        truth = self.truth()
        for habit in ("reads", "hidden"):
            first, again = self.lit(habit)["last"], self.lit(habit)["last"]
            self.assertGreater(psnr(first, truth), 38, habit)
            self.assertEqual(first, again, "passes follow from noise, not from time")
            self.assertLessEqual(self.report["light"]["noise"], 0.01)
            self.assertLess(psnr(self.lit(habit, "--set", "noise=0")["last"], truth), 36, habit)

    def test_reads_of_what_was_shown_or_copied_get_finished_images(self):
        truth = self.truth()
        for habit in ("reads-shown", "reads-plain", "reads-copies"):
            seen = self.lit(habit)
            print(f"{habit}: {psnr(seen['first'], truth, overlaid):.1f} dB, read {psnr(seen['last'], truth, overlaid):.1f},"
                  f" then {psnr(seen['window'], truth, overlaid):.1f}")
            self.assertGreater(psnr(seen["last"], truth, overlaid), psnr(seen["first"], truth, overlaid) + 3, habit)
            self.assertGreater(psnr(seen["window"], truth, overlaid), 38, habit)
            for other in ("again", "floats"):
                self.assertEqual(seen[other], seen["last"], f"{habit}, {other}")
            if habit != "reads-plain":
                self.check_overlays(seen)
            self.assertGreater(self.report["light"]["passes"], 0)
            quick = self.lit(habit, "--set", "noise=0")
            self.assertEqual(quick["first"], quick["last"], habit)

    def test_reads_do_not_need_refinement_of_windows(self):
        seen, idle = self.lit("reads-shown", "--set", "refine.idle=off"), self.lit("reads-shown")
        self.assertEqual(seen["last"], idle["last"])
        self.assertEqual(self.lit("reads-shown", "--set", "refine.idle=off")["window"], seen["first"], "nobody refines it")

    def test_framebuffers_of_other_kinds_are_read_as_they_are(self):
        seen = self.lit("reads-others")
        self.assertGreater(psnr(seen["last"], seen["first"]), 48)

    def test_small_reads_are_not_waited_for(self):
        self.run_client("picks", "--ao", *FEW)
        self.assertEqual(self.report["light"]["passes"], 0)

    def test_the_newest_frame_is_always_seen(self):
        without = [p for _, p in self.run_client("goes-on", "--ao", *FEW, "--set", "refine.idle=off")]
        ours = [p for _, p in self.run_client("goes-on", "--ao", *FEW)]
        for i, (a, b) in enumerate(zip(without, ours)):
            self.assertGreater(psnr(a, b), 20, f"frame {i}: another frame than the program's last")

    def test_what_others_paint_stays(self):
        seen = self.lit("paints")["last"]
        inside = [seen[y * WIDTH + x] for y in range(60, 100) for x in range(100, 140)]
        self.assertEqual({tuple(p) for p in inside}, {(0, 255, 0)})

    def test_programs_may_end_or_lose_their_windows(self):
        for habit in ("leaves", "closes", "destroys"):
            self.run_client(habit, "--ao", "--set", "ao.samples=64", "--set", "noise=0.0001")

    def test_windows_of_changing_size(self):
        self.assertGreater(psnr(self.lit("resizes")["last"], self.truth(), overlaid), 38)

    def test_off_starts_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "t.json")
            self.run_client("leaves", "--timeline", file, "--ao", *FEW)
            self.assertIn('"refines"', file.read_text(), "with light there is such a thread")
        for options in ((), ("--ao", *FEW, "--set", "refine.idle=off")):
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder, "t.json")
                self.run_client("plain", "--timeline", file, *options)
                self.assertNotIn('"refines"', file.read_text())
            self.assertEqual(set(self.report["light"]["idle"].values()), {0}, "nothing was refined")


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
