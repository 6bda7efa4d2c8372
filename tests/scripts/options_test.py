#!/usr/bin/env python3
"""Every script prints its usage with --help, and refuses an unknown option in one line; it does nothing else.

The scripts run in a copy of the checkout, each in an empty folder, which is its home, too. Programs that change something are replaced by
stand-ins that leave a file there.
"""
import concurrent.futures
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = (".ci", "scripts", "tools", "bench", "tests", "spec")
STAND_INS = ("apt-get", "cmake", "ctest", "cpack", "ninja", "debootstrap", "unshare", "sudo", "clang-format", "clang-format-14", "Xvfb", "pvbatch")
MAIN = re.compile(r'^(if __name__ == "__main__":|main\()', re.MULTILINE)
UNKNOWN = "--no-such-option"
# These import numpy and VTK, which not every Python has.
WITH_MODULES = [] if all(importlib.util.find_spec(name) for name in ("numpy", "vtk")) else ["live", "streams", "vtk"]
# Each with an option or argument that the script does not know, but in another place than the first.
REFUSED = [("scripts/build release --no-such-option", "--no-such-option"), ("scripts/build fastest", "fastest"),
           ("scripts/demo --osg --no-such-option", "--no-such-option"), ("scripts/format --check --no-such-option", "--no-such-option"),
           ("scripts/fuzz --mesa --no-such-option", "--no-such-option"), ("scripts/fuzz --calls many", "many"),
           ("scripts/fuzz --scenes 10 --calls 10", "--calls"), ("scripts/fuzz --control many", "many"), ("scripts/fuzz --seed", "--seed"),
           ("scripts/package one two", "two"), ("scripts/package tree one two", "two"), ("scripts/release --quick", "--quick"), ("scripts/release one two", "two"), ("scripts/progress name log", "too few"), ("scripts/setup --all --no-such-option", "--no-such-option"),
           ("scripts/package source-deb one two", "two"), ("scripts/setup --all --build-depends", "--build-depends"),
           ("scripts/test --all --no-such-option", "--no-such-option"), ("scripts/test --quick", "--quick"), ("scripts/test --root --no-such-option", "--no-such-option"),
           ("scripts/root bookworm --no-such-option", "--no-such-option"), ("scripts/bench guesses", "guesses"),
           ("scripts/bench compare --no-such-option one two", "--no-such-option"), (".ci/run --all", "--all")]


def scripts(root):
    """The command lines of all scripts that people run."""
    for path in sorted([*(root / "scripts").iterdir(), *(root / ".ci").iterdir()]):
        yield [path]
    for path in sorted((root / "bench" / "suites").glob("*.py")):
        yield [root / "scripts" / "bench", path.stem]
    for path in sorted(path for folder in ("tools", "bench", "tests") for path in (root / folder).rglob("*")):
        if path.name.endswith("_test.py") or not path.is_file():
            continue
        is_test = path.is_relative_to(root / "tests")
        if is_test and path.relative_to(root / "tests").parts[0] in WITH_MODULES:
            continue
        if path.suffix == ".py" and MAIN.search(path.read_text()) and (not is_test or "import Parser" in path.read_text()):
            yield [sys.executable, path]
        elif not path.suffix and os.access(path, os.X_OK):
            yield [path]


def state(folder):
    """Sizes and dates of all files below, and the folders."""
    return {path: () if path.is_dir() else (path.stat().st_size, path.stat().st_mtime_ns) for path in folder.rglob("*")}


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="gluray-options-")
        cls.addClassCleanup(folder.cleanup)
        cls.place = pathlib.Path(folder.name)
        cls.root = cls.place / "checkout"
        for name in FOLDERS:
            shutil.copytree(ROOT / name, cls.root / name, ignore=shutil.ignore_patterns("__pycache__", "results"))
        cls.before = state(cls.root)
        (cls.place / "bin").mkdir()
        for name in STAND_INS:
            (cls.place / "bin" / name).write_text(f'#!/bin/sh\ntouch "$HOME/{name} ran"\n')
            (cls.place / "bin" / name).chmod(0o755)

    def run_in_empty_folder(self, command):
        """The finished process, and the files that it left."""
        with tempfile.TemporaryDirectory(dir=self.place) as folder:
            plain = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "XDG_CACHE_HOME", "XDG_CONFIG_HOME")}
            environment = plain | {"HOME": folder, "TMPDIR": folder, "PATH": f"{self.place / 'bin'}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}
            words = [os.path.relpath(word, folder) if isinstance(word, pathlib.Path) else word for word in command]
            done = subprocess.run(words, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
            return done, sorted(path.name for path in pathlib.Path(folder).rglob("*"))

    def run_all(self, commands, check):
        """Calls check(done, i) for each command; they may leave nothing."""
        with concurrent.futures.ThreadPoolExecutor(2 * len(os.sched_getaffinity(0))) as several:
            outcomes = list(several.map(self.run_in_empty_folder, commands))
        for i, (done, files) in enumerate(outcomes):
            with self.subTest(" ".join(map(str, commands[i]))):
                self.assertEqual(files, [])
                check(done, i)
        changed = {path for path, _ in self.before.items() ^ state(self.root).items()}
        self.assertEqual(changed, set(), "the checkout has changed")

    def check_refusal(self, done, word):
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertRegex(done.stderr, rf"^\S+( \S+)?: .*{re.escape(word)}")
        self.assertRegex(done.stderr, "; (use|see) ")

    def test_help_prints_the_usage(self):
        def check(done, _):
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertGreater(len(done.stdout), 40)
        commands = [[*command, "--help"] for command in scripts(self.root)]
        self.assertGreater(len(commands), 50)
        self.run_all(commands, check)

    def test_unknown_options_are_refused(self):
        self.run_all([[*command, UNKNOWN] for command in scripts(self.root)], lambda done, _: self.check_refusal(done, UNKNOWN))

    def test_unknown_words_are_refused_wherever_they_stand(self):
        commands = [[self.root / line.split()[0], *line.split()[1:]] for line, _ in REFUSED]
        self.run_all(commands, lambda done, i: self.check_refusal(done, REFUSED[i][1]))


if __name__ == "__main__":
    unittest.main()
