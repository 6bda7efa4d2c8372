"""docs/gallery.md and docs/guide/light.md have the commands of bench/guide/pictures.toml, which names all pictures below docs/; each preset has a picture in
both, and their pictures are wide enough for print."""
import pathlib
import re
import struct
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench" / "guide"))
sys.dont_write_bytecode = True
import pictures  # noqa: E402

LEAST_WIDTH = 1200  # pixels
MOST_BYTES = 20 << 20  # of all pictures
MARKS = re.compile(r"!\[[^\]]*\]\(([\w/.-]+)\.png\)")


def size_of(png):
    """(width, height) in pixels."""
    return struct.unpack(">II", png.read_bytes()[16:24])


def presets_in(rows):
    """The presets that commands name, with those of --quality."""
    return {name if option == "preset" else f"quality-{name}" for row in rows for line in row["commands"]
            for option, name in re.findall(r"--(preset|quality) (\S+)", line)}


class GuidePage(unittest.TestCase):
    def setUp(self):
        self.rows = pictures.table()
        self.light = [row for row in self.rows.values() if row["file"].startswith("guide/light/")]
        self.gallery = pictures.gallery_rows(self.rows)

    def test_pages_have_the_commands_of_the_table(self):
        for path, text, written in pictures.pages():
            self.assertEqual(text, written, f"{path.name}: run python3 bench/guide/images.py --pages")

    def test_a_changed_command_changes_the_pages(self):
        self.rows["guide/light/presentation"]["commands"] = ["gluray --preset presentation --spp 2 PROGRAM"]
        self.assertIn("--spp 2 PROGRAM\n", pictures.light_page(pictures.LIGHT.read_text(), self.rows))
        self.assertIn("--spp 2 python3 bench/guide/draw.py head presentation.png 640x540", pictures.gallery_page(pictures.GALLERY.read_text(), self.rows))

    def test_the_table_names_all_pictures_and_pages_show_theirs(self):
        files = {file.relative_to(pictures.DOCS).with_suffix("").as_posix() for file in pictures.DOCS.rglob("*.png")}
        self.assertEqual(files, set(self.rows))
        self.assertEqual({f"guide/{name}" for name in MARKS.findall(pictures.LIGHT.read_text())}, {row["file"] for row in self.light})
        self.assertEqual(MARKS.findall(pictures.GALLERY.read_text()), [row["file"] for row in self.gallery])

    def test_each_row_can_be_drawn(self):
        scenes = "".join((ROOT / "bench" / "guide" / name).read_text() for name in ("scenes.py", "fields.py", "objects.py"))
        for row in self.rows.values():
            for line in row["commands"]:
                self.assertTrue(line.startswith("gluray "), row["file"])
            if "scene" in row:
                self.assertIn(f"def {row['scene']}(renderer)", scenes)
            if "made_by" in row:
                self.assertTrue((ROOT / row["made_by"]).exists(), row["file"])
            elif row in self.light:
                self.assertEqual(len(row["commands"]) > 1, not row.get("own", True), row["file"])
                self.assertNotIn("", [word for line in row["commands"] for word in pictures.words_of(line)])
            for script in re.findall(r"bench/\S+", row.get("program", "")):
                self.assertTrue((ROOT / script).exists(), row["file"])

    def test_tutorials_have_their_commands(self):
        for row in self.rows.values():
            if row.get("made_by", "").startswith("docs/tutorials/"):
                for line in row["commands"]:
                    self.assertIn(line, (ROOT / row["made_by"]).read_text())

    def test_pictures_are_wide(self):
        for row in [*self.light, *self.gallery]:
            self.assertGreaterEqual(size_of(pictures.DOCS / f"{row['file']}.png")[0], LEAST_WIDTH, row["file"])
        self.assertLess(sum(file.stat().st_size for file in pictures.DOCS.rglob("*.png")), MOST_BYTES)

    def test_each_preset_has_a_picture(self):
        presets = set(re.findall(r"^\[presets\.([\w-]+)\]", (ROOT / "spec" / "presets.toml").read_text(), re.MULTILINE))
        self.assertEqual(presets - presets_in(self.light), set())
        self.assertEqual({name for name in presets if not name.startswith("quality-")} - presets_in(self.gallery), set())


if __name__ == "__main__":
    unittest.main()
