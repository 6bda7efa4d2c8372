"""`--timeline` and `gluray timeline` with a real program: timeline_test.py GLURAY CLIENT (with an X server at hand)."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest


class Timeline(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = pathlib.Path(self.folder.name) / "t.json"

    def record(self, *command):
        done = subprocess.run([GLURAY, "--engine", "always", "--timeline", self.file, "--", *command], capture_output=True, text=True,
                              timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_stage_of_a_run(self):
        self.record(CLIENT, "vbo", "150000", "10")
        events = json.loads(self.file.read_text().rstrip().rstrip(",") + "]")
        names = {event["name"] for event in events if event["ph"] == "X"}
        self.assertLessEqual({"capture", "build", "build mesh", "trace", "tiles", "write back", "batch", "swap"}, names)
        self.assertEqual(sum(event["name"] == "frame" for event in events), 10)
        chart = self.file.with_suffix(".svg")
        done = subprocess.run([GLURAY, "timeline", self.file, "-o", chart], capture_output=True, text=True, timeout=100)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^\d+ ms, 10 frames\n")
        self.assertIn("</svg>", chart.read_text())

    def test_a_program_that_is_killed_leaves_what_was_written(self):
        """Writes happen twice a second."""
        self.record("sh", "-c", f"{CLIENT} vbo 150000 100000 & sleep 4; kill -9 $!")
        files = list(pathlib.Path(self.folder.name).glob("t.json*"))
        self.assertEqual(len(files), 1)
        done = subprocess.run([GLURAY, "timeline", files[0]], capture_output=True, text=True, timeout=100)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, "show|write back")

    def test_a_file_that_cannot_be_written(self):
        done = subprocess.run([GLURAY, "--engine", "always", "--timeline", "/nowhere/t.json", "--", CLIENT, "vbo", "20000", "3"],
                              capture_output=True, text=True, timeout=100)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("/nowhere/t.json", done.stderr)


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1], verbosity=2)
