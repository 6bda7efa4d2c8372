"""bench/results holds what documents name, and nothing else."""
import pathlib
import re
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "bench" / "results"
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
PAPER = {"paper/small.json", "paper/full/full.json"}  # what scripts/bench paper draws its pages from
PATH = re.compile(r"bench/results/([\w/]*\w\.\w+)")


def goals():
    """The words of the last column of the table of goals, the first of its page, which names results without their suffix."""
    table = (ROOT / "docs" / "performance.md").read_text().split("\n## ")[0]
    rows = [line for line in table.splitlines() if line.startswith("|")]
    return {word for row in rows for word in re.findall(r"[\w/]+", row.rsplit("|", 2)[1])}


class Results(unittest.TestCase):
    def test_results_that_documents_name_exist(self):
        for page in PAGES:
            for name in PATH.findall(page.read_text()):
                if name != "NAME.json":
                    self.assertTrue((RESULTS / name).exists(), f"{page.relative_to(ROOT)} names bench/results/{name}")

    def test_documents_name_all_results(self):
        listed = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "--", "."], cwd=RESULTS, capture_output=True, text=True)
        if listed.returncode:
            self.skipTest("no checkout of git")  # results of one's own may be there, too
        text = "\n".join(page.read_text() for page in PAGES)
        named = set(re.findall(r"(?<![\w/])\w+\.json", text)) | set(PATH.findall(text)) | {f"{word}.json" for word in goals()} | PAPER
        self.assertEqual([name for name in listed.stdout.split() if name not in named and (RESULTS / name).exists()], [])


if __name__ == "__main__":
    unittest.main()
