"""A program that waits for an image that takes long: waiting_test.py GLURAY CLIENT, with an X server at hand.

Standard error is a terminal here. The image never reaches its noise; refine.seconds ends it.
"""
import json
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest

SECONDS = 5
ENDLESS = ("--ao", "--set", "noise=0.0000001", "--set", "refine.passes=65536", "--set", f"refine.seconds={SECONDS}")


class Terminal:
    """What programs write to a terminal."""

    def __init__(self):
        self.main, self.side = pty.openpty()
        self.text = b""
        self.reader = threading.Thread(target=self.read)
        self.reader.start()

    def read(self):
        try:
            while part := os.read(self.main, 4096):
                self.text += part
        except OSError:  # the last writer has closed it
            pass

    def close(self):
        os.close(self.side)
        self.reader.join()
        os.close(self.main)
        return self.text.decode()


class Waiting(unittest.TestCase):
    def run_client(self, *options):
        """What stands on the terminal, and the progress that reports had meanwhile."""
        terminal, seen = Terminal(), []
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            program = subprocess.Popen([GLURAY, "--report", report, *options, "--", CLIENT, "reads"],
                                       stdout=subprocess.DEVNULL, stderr=terminal.side)
            while program.poll() is None:
                if report.exists():
                    seen.append(json.loads(report.read_text())["light"]["progress"])
                time.sleep(0.05)
            self.report = json.loads(report.read_text())
        self.assertEqual(program.returncode, 0)
        return terminal.close(), [progress for progress in seen if progress]

    def test_a_line_tells_how_far_it_is(self):
        text, seen = self.run_client(*ENDLESS)
        shares = [int(share) for share in re.findall(r"gluray: refining the image: (\d+) %", text)]
        print(repr(text[:300]), len(shares), "lines")
        self.assertGreater(len(shares), 2)
        self.assertEqual(shares, sorted(shares))
        self.assertRegex(text, r"noise 0\.\d{4} of 0\.0000, \d+ s left")
        self.assertNotIn("\n", text)
        self.assertTrue(text.endswith("\r\x1b[K"), "the line disappears")
        self.assertGreater(self.report["light"]["passes"], 4)
        self.assertIsNone(self.report["light"]["progress"], "nothing is waited for any more")
        self.assertGreater(len(seen), 1)
        self.assertLess(seen[0]["share"], seen[-1]["share"])
        self.assertLess(seen[-1]["secondsLeft"], SECONDS)

    def test_the_line_can_be_switched_off(self):
        text, seen = self.run_client(*ENDLESS, "--set", "refine.progress=off")
        self.assertEqual(text, "")
        self.assertGreater(len(seen), 1, "reports have it")

    def test_short_images_tell_nothing(self):
        text, seen = self.run_client("--ao", "--set", "refine.passes=4")
        self.assertEqual((text, seen), ("", []))


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
