"""`--log-level trace`: a line for each decision, and tools/decisions.py, which compares them: decisions_test.py GLURAY CLIENT (with an X server at
hand)."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "decisions.py"


class Decisions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def record(self, name, engine="always", level="trace"):
        (self.folder / name).mkdir(exist_ok=True)
        log = self.folder / name / "client.log"
        done = subprocess.run([GLURAY, "--engine", engine, "--log", log, "--log-level", level, "--", CLIENT, *self.client], capture_output=True,
                              text=True, timeout=100)
        self.assertEqual(done.returncode, 0, done.stderr)
        return log.read_text().splitlines() if log.exists() else []

    def compare(self, before, after):
        return subprocess.run([sys.executable, TOOL, "compare", self.folder / before, self.folder / after], capture_output=True, text=True, timeout=100)

    client = ("list", "200", "4")

    def test_each_draw_and_each_batch_has_a_line(self):
        lines = self.record("a")
        draws = [line for line in lines if line.startswith("gluray: draw ")]
        self.assertEqual(len(draws), 4, lines)
        self.assertRegex(draws[0], r"^gluray: draw 1 list surfaces \d+, lighting.* -> traced in glCallList$")
        self.assertEqual([line for line in lines if line.startswith("gluray: batch ")][0], "gluray: batch 1 opaque instances 1 framebuffer 0 -> traced in SwapBuffers")
        self.assertEqual(sum(line.startswith("gluray: presented traced in ") for line in lines), 4, lines)

    def test_rasterised_draws_say_why(self):
        draws = [line for line in self.record("a", engine="auto") if line.startswith("gluray: draw ")]
        self.assertEqual(len(draws), 4)
        self.assertTrue(all("-> rasterised: small scene: the real OpenGL is faster in glCallList" in line for line in draws), draws)

    def test_other_levels_say_nothing_of_it(self):
        self.assertEqual([line for line in self.record("a", level="debug") if line.startswith(("gluray: draw ", "gluray: batch ", "gluray: presented "))], [])

    def test_two_runs_decide_alike(self):
        self.record("a"), self.record("b")
        done = self.compare("a", "b")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "1 tests, 0 differ\n", ""))

    def test_differences_are_found(self):
        lines = ["one", "two", "three"]
        for name, other in (("order", ["two", "one", "three"]), ("changed", ["one", "2", "three"]), ("more", lines + ["four"]), ("gone", None)):
            for folder, written in (("a", lines), (name, other)):
                (self.folder / folder).mkdir(exist_ok=True)
                if written:
                    (self.folder / folder / "x.log").write_text("\n".join(written))
            done = self.compare("a", name)
            self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (1, "1 tests, 1 differ"))
            self.assertIn({"order": "another order", "changed": "line 2:\n  - two\n  + 2", "more": "line 4", "gone": "is missing"}[name], done.stdout)


if __name__ == "__main__":
    GLURAY, CLIENT = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
