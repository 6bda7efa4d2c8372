"""The generator of settings: pages that follow added rows, and rows that it refuses."""
from __future__ import annotations

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = pathlib.Path(__file__).resolve().parent
TOOL = ROOT / "tools/settings.py"
PAGES = ("completions/gluray", "docs/man/gluray.1", "docs/man/gluray.toml.5", "docs/settings.md")


def run(*words) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for page in PAGES:
            (self.folder / page).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / page, self.folder / page)
        self.added = self.folder / "settings.toml"
        self.added.write_text((ROOT / "spec/settings.toml").read_text() + (HERE / "added_rows.toml").read_text())


class Pages(Folder):
    def setUp(self):
        super().setUp()
        self.assertEqual(run(TOOL, "--pages", self.folder, "--spec", self.added).returncode, 0)
        self.pages = {page: (self.folder / page).read_text() for page in PAGES}

    def check(self, page: str, *parts: str):
        for part in parts:
            self.assertIn(part, self.pages[page])

    def test_man_page_of_the_launcher(self):
        self.check("docs/man/gluray.1", ".B \\-\\-added\nAdds a switch.", '.BI \\-\\-added\\-radius " X"\nAdds a number. It has a unit. From 0 (nothing) to 10 ms. '
                   "The default is 0.5.", "\\fBvery\\-high\\fR: adds much", "\\fBGLURAY_ADDED_DEEP_FIRST_MODE\\fR")

    def test_man_page_of_files(self):
        self.check("docs/man/gluray.toml.5", '.BR added.radius " = \\fInumber\\fR"', ".BR added.sky", ".BR added.names", ".BR added.deep.first\\-mode")

    def test_settings_page(self):
        self.check("docs/settings.md", "### Added switch (`added.enabled`)\n\nAdds a switch.\n\nbasic; true or false; default: false; applies from the next frame on; changes the image",
                   "`GLURAY_ADDED_UP`", "a number, from 0 (nothing) to 10 ms; default: 0.5", "- `low`: adds little", "default: 0.25,0.5,1")

    def test_settings_page_has_groups_with_basic_settings_first(self):
        page = self.pages["docs/settings.md"]
        occlusion = page[page.index("\n## Occlusion\n"):page.index("\n## Materials\n")]
        places = [occlusion.index(f"(`{name}`)") for name in ("ao", "added.enabled", "ao.samples", "added.radius", "ao.on", "added.count")]
        self.assertEqual(places, sorted(places))
        self.assertGreater(page.index("(`added.deep.first-mode`)"), page.index("\n## Cluster\n"))

    def complete(self, *words: str) -> list[str]:
        script = f"""source '{self.folder}/completions/gluray'; COMP_WORDS=({' '.join(f"'{w}'" for w in words)}); COMP_CWORD={len(words) - 1}
                     _gluray; printf '%s\\n' "${{COMPREPLY[@]}}\""""
        return subprocess.run(["bash", "--norc", "-c", script], capture_output=True, text=True).stdout.split()

    def test_completions(self):
        self.assertEqual(self.complete("gluray", "--added-r"), ["--added-radius"])
        self.assertEqual(self.complete("gluray", "--added-mode", "v"), ["very-high"])
        self.assertEqual(self.complete("gluray", "--set", "added.e"), ["added.enabled="])
        self.assertEqual(self.complete("gluray", "--set", "added.deep.first-mode=l"), ["added.deep.first-mode=low"])
        self.assertEqual(self.complete("gluray", "settings", "--why", "added.u"), ["added.up"])

    def test_stale_pages_are_noticed(self):
        self.assertEqual(run(TOOL, "--check", self.folder, "--spec", self.added).returncode, 0)
        done = run(TOOL, "--check", self.folder)
        self.assertEqual(done.returncode, 1)
        for page in PAGES:
            self.assertIn(page, done.stderr)


class Refused(Folder):
    def refuse(self, why: str, **fields):
        row = dict(name="x", title="New", type="int", range=[0, 1], help="h", group="Light", level="basic", since="1", applies="frame", changes="way") | fields
        text = "\n".join(f"{k.replace('_', '-')} = {self.toml(v)}" for k, v in row.items() if v is not None)
        spec = self.folder / "spec.toml"
        spec.write_text((ROOT / "spec/settings.toml").read_text() + "\n[[setting]]\n" + text + "\n")
        done = run(TOOL, self.folder / "gen", "--spec", spec)
        self.assertEqual(done.returncode, 1, why)
        self.assertIn(why, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    @staticmethod
    def toml(value) -> str:
        return str(value).lower() if isinstance(value, bool) else repr(value)

    def test_rows(self):
        self.refuse("needs a field 'help'", help=None)
        self.refuse("needs a field 'title'", title=None)
        self.refuse("needs a field 'level'", level=None)
        self.refuse("needs a field 'group'", group=None)
        self.refuse("group must be one of Quality, Speed", group="Lights")
        self.refuse("level must be one of basic, advanced, expert", level="simple")
        self.refuse("another setting has the title Ambient occlusion", title="Ambient occlusion")
        self.refuse("a title has at most 4 words", title="One two three four five")
        self.refuse("a title has at most 4 words", title="Two  blanks")
        self.refuse("sentence case", title="New Radius")
        self.refuse("sentence case", title="new radius")
        self.refuse("unknown field rnage", rnage=[0, 1])
        self.refuse("type must be one of", type="double")
        self.refuse("numbers need a range", range=None)
        self.refuse("the default is out of range", default=2)
        self.refuse("the default is not of type int", default="1")
        self.refuse("applies must be one of", applies="now")
        self.refuse("must apply to frames or contexts", applies="process", changes="image")
        self.refuse("needs choices", type="choice", range=None)
        self.refuse("another setting has the name spp", name="spp")
        self.refuse("another setting has the variable GLURAY_LOG_LEVEL", name="log.level")
        self.refuse("another setting has the option --spp", option="--spp")
        self.refuse("only switches and choices head a group", name="spp.more")
        self.refuse("and not reserved", name="config")
        self.refuse("and not reserved", name="program.x")


if __name__ == "__main__":
    unittest.main()
