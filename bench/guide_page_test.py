"""docs/guide/light.md: each preset has a picture, each picture has the commands that make it, and all are wide enough for print."""
import pathlib
import re
import struct
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench" / "guide"))
sys.dont_write_bytecode = True
import images  # noqa: E402

LEAST_WIDTH = 1200  # pixels
MOST_BYTES = 12 << 20  # of all pictures


def size_of(png):
    """(width, height) in pixels."""
    return struct.unpack(">II", png.read_bytes()[16:24])


class GuidePage(unittest.TestCase):
    def setUp(self):
        self.commands = dict(images.commands_of_pictures(images.PAGE.read_text()))

    def test_each_picture_has_commands_and_a_scene(self):
        self.assertEqual(set(self.commands), set(images.SCENES))
        for name, lines in self.commands.items():
            self.assertEqual(len(lines) > 1, name in images.WITHOUT_OWN, name)
            for line in lines:
                self.assertNotIn("", images.words_of(line), name)

    def test_each_picture_is_there_and_wide(self):
        files = sorted(images.OUT.iterdir())
        self.assertEqual([file.name for file in files], sorted(f"{name}.png" for name in self.commands))
        for file in files:
            self.assertGreaterEqual(size_of(file)[0], LEAST_WIDTH, file.name)
        self.assertLess(sum(file.stat().st_size for file in files), MOST_BYTES)

    def test_each_preset_has_a_picture(self):
        shown = {word for lines in self.commands.values() for line in lines
                 for option, name in re.findall(r"--(preset|quality) (\S+)", line) for word in [name if option == "preset" else f"quality-{name}"]}
        presets = set(re.findall(r"^\[presets\.([\w-]+)\]", (ROOT / "spec" / "presets.toml").read_text(), re.MULTILINE))
        self.assertEqual(presets - shown, set())


if __name__ == "__main__":
    unittest.main()
