"""Manual pages of the launcher's commands: each command has one, stale pages are noticed, and help texts of CLI11 are understood.

manual_pages_test.py GLURAY ROOT
"""
from __future__ import annotations

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

GLURAY, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.append(str(ROOT / "tools"))
import manual_examples  # noqa: E402
import manual_pages  # noqa: E402
from manual_help import Help  # noqa: E402

TEXT = """Saves things: all `of` them.
  eval x
Usage: gluray try [OPTIONS] FILE

Positionals:
  FILE TEXT REQUIRED      Name of the file

Options:
  -h,--help               Print this help message and exit
  --key,--hub-key FILE    File with the key [setting hub-key]
  --fit TEXT:{all,crop}=all
                          How it fits, and
                          where
  --frames N:INT in [1 - 1e+06]=3 Needs: --fit
                          End after N images
  --fps N=25 Needs: --fit Rate of the film
  --no-overlays{false}    Leave out text
  --hide Excludes: --fit --fps
                          Hide it
"""


def pages(*words) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, ROOT / "tools/manual_pages.py", GLURAY, *map(str, words)], capture_output=True, text=True)


class Parts(unittest.TestCase):
    def test_help_texts(self):
        said = Help(TEXT)
        self.assertEqual(said.usage, "gluray try [OPTIONS] FILE")
        self.assertEqual([(o.names, o.text) for o in said.positionals], [(["FILE"], "Name of the file")])
        options = {o.names[-1]: (o.value, o.text, o.facts) for o in said.options}
        self.assertEqual(options["--hub-key"], ("FILE", "File with the key [setting hub-key]", ""))
        self.assertEqual(options["--fit"], ("HOW", "How it fits, and where", "Values: all or crop. The default is all."))
        self.assertEqual(options["--frames"], ("N", "End after N images", "From 1 to 1000000. It needs --fit. The default is 3."))
        self.assertEqual(options["--fps"], ("N", "Rate of the film", "It needs --fit. The default is 25."))
        self.assertEqual(options["--no-overlays"], ("", "Leave out text", ""))
        self.assertEqual(options["--hide"], ("", "Hide it", "It cannot be combined with --fit or --fps."))

    def test_pages(self):
        page = manual_pages.page("try", TEXT, [], [("gluray try a-b", "a comment")])
        for part in ("gluray\\-try \\- save things\n", "all \\fBof\\fR them.", ".nf\n  eval x\n.fi", "The default is the setting hub\\-key.",
                     ".TP\n.B gluray try a\\-b\na comment\n", ".TP\n.B \\fB\\-\\-key\\fR, \\fB\\-\\-hub\\-key\\fR \\fIFILE\\fR\n"):
            self.assertIn(part, page)

    def test_examples_are_commands_of_the_guide(self):
        found = manual_examples.read(ROOT)
        self.assertIn(("gluray render --again figure.png", ""), found["render"])
        self.assertNotIn("gluray set ao.samples=0", [command for command, _ in found["set"]])  # a mistake there
        self.assertGreater(sum(map(len, found.values())), 40)


class Files(unittest.TestCase):
    def test_every_command_has_a_page_that_see_also_names(self):
        listed = manual_pages.commands(manual_pages.shown(GLURAY))
        self.assertGreater(len(listed), 28)
        related = set(re.findall(r"gluray\\-([a-z\\-]+) \(1\)", (ROOT / "docs/man/gluray.1").read_text().split(".SH SEE ALSO")[1]))
        self.assertEqual({name.replace("\\", "") for name in related} - {"worker"}, set(listed))
        for name in listed:
            self.assertTrue((ROOT / f"docs/man/gluray-{name}.1").exists(), name)

    def test_stale_pages_are_noticed(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for part in ("docs/guide", "docs/tutorials", "docs/man"):
                shutil.copytree(ROOT / part, folder / part)
            for file in ("README.md", "docs/explain.md", "docs/troubleshooting.md"):
                shutil.copy(ROOT / file, folder / file)
            self.assertEqual(pages("--check", folder).returncode, 0)
            shot, gone = folder / "docs/man/gluray-shot.1", folder / "docs/man/gluray-gone.1"
            shot.write_text(shot.read_text() + "more\n")
            shutil.copy(ROOT / "docs/man/gluray-film.1", gone)
            done = pages("--check", folder)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"^stale: docs/man/gluray-gone.1 docs/man/gluray-shot.1;")
            self.assertEqual(pages("--pages", folder).returncode, 0)
            self.assertEqual(pages("--check", folder).returncode, 0)
            self.assertFalse(gone.exists())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
