"""gluray uninstall: lists and removes what GLuRay keeps outside its folder, and nothing else. uninstall_test.py GLURAY"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

GLURAY = sys.argv[1]


class Uninstall(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.environment = {**{k: v for k, v in os.environ.items() if not k.startswith(("GLURAY", "XDG_"))}, "HOME": str(self.folder / "home"),
                            "GLURAY_RUNTIME": str(self.folder / "run")}
        self.settings, self.runtime = self.folder / "home/.config/gluray", self.folder / "run"
        self.settings.mkdir(parents=True)
        (self.settings / "gluray.toml").write_text("threads = 2\n")
        (self.folder / "home/.config/other").mkdir()
        self.trials = self.folder / "home/.cache/gluray/trials"
        self.trials.mkdir(parents=True)
        self.runtime.mkdir(mode=0o700)

    def ask(self, *words, **variables):
        done = subprocess.run([GLURAY, "uninstall", *words], capture_output=True, text=True, env={**self.environment, **variables})
        self.assertEqual(done.stderr, "")
        self.assertEqual(done.returncode, 0)
        return done.stdout

    def test_lists_and_removes(self):
        said = self.ask()
        self.assertIn(f"kept: {self.settings} (settings)", said)
        self.assertIn(f"kept: {self.runtime} (", said)
        self.assertIn("GLuRay itself is the build folder", said)
        self.assertTrue((self.settings / "gluray.toml").exists())
        listed = json.loads(self.ask("--json"))
        self.assertEqual([(one["path"], one["removed"]) for one in listed["outside"]][:3],
                         [(str(self.settings), False), (str(self.trials), False), (str(self.runtime), False)])
        self.assertIn(f"removed: {self.settings} (settings)", self.ask("--remove"))
        self.assertFalse(self.settings.exists() or self.runtime.exists() or self.trials.parent.exists())
        self.assertTrue((self.folder / "home/.config/other").exists())
        self.assertNotIn(str(self.folder), self.ask().split("GLuRay itself")[0])

    def test_leaves_other_files_beside_the_results(self):
        other = self.trials.parent / "other"
        other.write_text("")
        self.assertIn(f"removed: {self.trials} (", self.ask("--remove"))
        self.assertTrue(other.exists())

    def test_leaves_directories_of_others_alone(self):
        self.trials.rmdir()
        self.runtime.chmod(0o755)
        link = self.folder / "elsewhere"
        self.settings.rename(link)
        self.settings.symlink_to(link)
        said = self.ask("--remove")
        self.assertNotIn(str(self.folder), said.split("GLuRay itself")[0])
        self.assertTrue(self.runtime.exists() and (link / "gluray.toml").exists() and self.settings.is_symlink())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
