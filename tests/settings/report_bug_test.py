"""gluray report-bug: the archive, and what it says. report_bug_test.py GLURAY"""
import json
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

GLURAY = sys.argv[1]


class ReportBug(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.environment = {**{k: v for k, v in os.environ.items() if not k.startswith(("GLURAY", "XDG_", "SECRET"))}, "HOME": str(self.folder),
                            "GLURAY_RUNTIME": str(self.folder / "run"), "SECRET_TOKEN": "do not tell", "GLURAY_SPP": "4"}

    def run_it(self, *words):
        return subprocess.run([GLURAY, "report-bug", *words], cwd=self.folder, env=self.environment, capture_output=True, text=True)

    def files(self, name="gluray-report.tar.gz"):
        with tarfile.open(self.folder / name) as archive:
            return {pathlib.PurePath(member.name).name: archive.extractfile(member).read().decode() for member in archive if member.isfile()}

    def test_without_a_program(self):
        done = self.run_it()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        files = self.files()
        self.assertEqual(set(files), {"doctor.json", "settings.json", "system.txt"})
        for name in files:
            self.assertIn(f"  {name}, ", done.stdout)
        self.assertIn("nothing was sent", done.stdout)
        self.assertIn("gluray ", files["system.txt"])
        self.assertIn("GLURAY_SPP=4", files["system.txt"])
        self.assertNotIn("do not tell", "".join(files.values()))
        json.loads(files["doctor.json"]), json.loads(files["settings.json"])

    def test_with_a_program(self):
        done = self.run_it("-o", "mine.tar.gz", "--seconds", "20", "--", "sh", "-c", "echo said; exit 3")
        self.assertEqual(done.returncode, 0, done.stderr)
        files = self.files("mine.tar.gz")
        self.assertIn("explain.json", files)
        self.assertIn("sh -c echo said; exit 3", files["command.txt"])
        self.assertNotIn("said", done.stdout.replace("echo said", ""))

    def test_mistakes_get_one_line(self):
        for words, part in ((["-o", "report.zip"], "ends in .tar.gz"), (["-o", "missing/report.tar.gz"], "missing")):
            done = self.run_it(*words)
            self.assertNotEqual(done.returncode, 0)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(part, done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name != "run"], [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
