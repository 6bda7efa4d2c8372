"""Settings files that are edited while a program runs: files_test.py GLURAY CLIENT, with an X server at hand."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

LOOK = 0.05     # seconds between looks at the files
WRITING = 0.02  # files that are younger may still be written


def plain_environment():
    """Without settings, but with the engine that tests choose."""
    return {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_") or k == "GLURAY_ENGINE"}


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "gluray").mkdir()
        self.user, self.project, self.log = self.folder / "gluray/gluray.toml", self.folder / "gluray.toml", self.folder / "log"

    def start(self, *options, **variables):
        environment = plain_environment()
        environment |= {"XDG_CONFIG_HOME": str(self.folder), **variables}
        self.client = subprocess.Popen([GLURAY, "--log", self.log, *options, "--", CLIENT], cwd=self.folder, env=environment, text=True,
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(self.end)

    def end(self):
        self.client.stdin.close()
        self.assertEqual(self.client.wait(20), 0)
        self.client.stdout.close()

    def frame(self):
        print("frame", file=self.client.stdin, flush=True)
        return self.client.stdout.readline().strip()

    def later(self):
        """A frame after the files have rested: the swap of the frame before looks at them, too, and looks are LOOK apart."""
        time.sleep(2 * WRITING)
        self.frame()
        time.sleep(2 * LOOK)
        return self.frame()

    def write(self, file, text):
        file.write_text(text)

    def replace(self, file, text):
        """As careful editors do."""
        new = file.with_suffix(".new")
        new.write_text(text)
        new.rename(file)

    def image(self, *options):
        """The checksum in a run of its own."""
        words = [GLURAY, *options, "--", CLIENT]
        environment = plain_environment() | {"XDG_CONFIG_HOME": "/nowhere"}
        return subprocess.run(words, input="frame\n", capture_output=True, text=True, timeout=60, env=environment, check=True, cwd="/").stdout.strip()

    def complaints(self):
        return self.log.read_text().splitlines() if self.log.exists() else []

    def test_each_file_counts_at_the_next_frame(self):
        plain, occluded, coarse = self.image(), self.image("--ao"), self.image("--ao", "--set", "ao.strength=0.5")
        self.assertEqual(len({plain, occluded, coarse}), 3)
        self.start()
        self.assertEqual(self.frame(), plain)
        for write in (self.write, self.replace):
            write(self.user, "ao = true\n")
            self.assertEqual(self.later(), occluded)
            write(self.project, "[ao]\nstrength = 0.5\n")
            self.assertEqual(self.later(), coarse)
            write(self.user, "[program.client]\nao = false\n")
            self.assertEqual(self.later(), plain)
            write(self.user, "ao = true\n")
            write(self.project, "\n")
            self.assertEqual(self.later(), occluded)
            write(self.user, "\n")
            self.assertEqual(self.later(), plain)
        self.assertEqual(self.complaints(), [])

    def test_presets_by_name(self):
        plain, paper, stronger = self.image(), self.image("--preset", "streamlines"), self.image("--preset", "streamlines", "--set", "shadows.strength=0.5")
        self.assertEqual(len({plain, paper, stronger}), 3)
        self.start()
        self.write(self.user, "preset = 'streamlines'\n")
        self.assertEqual(self.later(), paper)
        self.write(self.project, "[presets.streamlines]\nshadows.strength = 0.5\n")
        self.assertEqual(self.later(), stronger)
        self.write(self.project, "preset = 'none'\n")
        self.assertEqual(self.later(), plain)
        self.write(self.project, "preset = 'draft'\n")
        self.assertEqual(self.later(), plain)

    def test_mistakes_keep_what_was(self):
        self.start("--set", "ao.samples=4")
        self.write(self.user, "ao = true\n")
        occluded = self.later()
        for text, word in (("ao = perhaps\n", ""), ("[ao\n", ""), ("ao.strenth = 1\nao = false\n", ""), ("ao = 'some'\n", "use on, off, true"),
                           ("aoo = true\n", "did you mean 'ao'?"), ("preset = 'streamlinez'\n", "did you mean 'streamlines'?"), ("ao = true\0\n", "")):
            before = len(self.complaints())
            self.write(self.user, text)
            self.assertEqual([self.later(), self.later()], [occluded] * 2, text)
            lines = self.complaints()[before:]
            self.assertEqual(len(lines), 1, lines)
            self.assertIn(word, lines[0])
            self.assertIn("all settings stay as they are", lines[0])
        self.write(self.user, "ao = true\n")
        self.assertEqual(self.later(), occluded)

    def test_variables_and_options_stay_above(self):
        self.start("--set", "ao=off", GLURAY_SHADOWS="off")
        plain = self.frame()
        self.write(self.user, "ao = true\nshadows = true\n")
        self.assertEqual(self.later(), plain)

    def test_files_that_others_may_write_are_not_read(self):
        self.start()
        plain = self.frame()
        self.write(self.project, "ao = true\n")
        self.project.chmod(0o666)
        self.assertEqual(self.later(), plain)
        self.assertIn("others may write it", self.complaints()[0])


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
