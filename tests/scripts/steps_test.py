#!/usr/bin/env python3
"""The steps of scripts/test and .ci/run, with stand-ins for the other scripts and for ctest."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
OTHERS = ("setup", "format", "build", "root")
# Lists its name and arguments; fails with the exit code in the file fails/NAME-FIRST_ARGUMENT.
STAND_IN = """#!/bin/sh
name=$(basename "$0")
echo "$name $*" >>"$PLACE/calls"
mkdir -p build/asan build/tsan
if [ "$name" = ctest ]; then echo "100% tests passed, of $2"; fi
if [ -e "$PLACE/fails/$name-$1" ]; then exit "$(cat "$PLACE/fails/$name-$1")"; fi
"""
ADDRESS = ["build asan address_suites", "ctest build/asan ^(unit|variant|link|fuzz)$"]
THREAD = ["build tsan thread_suites", "ctest build/tsan ^thread$"]
RELEASE = ["build release release_suites", "ctest build/release not ^(long|network|package|piglit|program)$"]
LONG_ADDRESS = ["build asan address_suites", "ctest build/asan ^(unit|variant|link|fuzz|long)$"]


def short(call):
    """A call; of ctest only its folder and labels."""
    name, *words = call.split()
    if name != "ctest":
        return call.strip()
    labels = [("not " if words[i] == "-LE" else "") + words[i + 1] for i in range(len(words)) if words[i] in ("-L", "-LE")]
    return " ".join([name, words[1], *labels])


class Steps(unittest.TestCase):
    def run_with(self, *command, fails=None, release="bookworm"):
        """The calls of the stand-ins, and the finished process."""
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            for name in ("scripts/test", ".ci/run"):
                (place / "checkout" / name).parent.mkdir(parents=True)
                shutil.copy(ROOT / name, place / "checkout" / name)
            text = (place / "checkout/scripts/test").read_text().replace("/etc/os-release", str(place / "os-release"))
            (place / "checkout/scripts/test").write_text(text)
            (place / "os-release").write_text(f"ID=debian\nVERSION_CODENAME={release}\n")
            (place / "bin").mkdir()
            for path in [*(place / "checkout" / "scripts" / name for name in OTHERS), place / "bin" / "ctest"]:
                path.write_text(STAND_IN)
                path.chmod(0o755)
            (place / "fails").mkdir()
            for name, code in (fails or {}).items():
                (place / "fails" / name).write_text(str(code))
            environment = {**os.environ, "PATH": f"{place / 'bin'}:{os.environ['PATH']}", "PLACE": str(place)}
            done = subprocess.run([place / "checkout" / command[0], *command[1:]], env=environment, capture_output=True, text=True, timeout=60)
            calls = place / "calls"
            return [short(call) for call in calls.read_text().splitlines()] if calls.exists() else [], done

    def check(self, command, calls, **more):
        made, done = self.run_with(*command, **more)
        self.assertEqual((done.returncode, made), (0, calls), done.stderr)
        self.assertEqual(done.stdout.splitlines()[-1], "100% tests passed, of build/release")

    def test_the_default_is_the_release_suite(self):
        self.check(["scripts/test"], ["setup", "format --check", *RELEASE])

    def test_sanitizers_come_before_the_release_suite(self):
        calls = ["setup", "format --check", *ADDRESS, *THREAD, *RELEASE]
        self.check(["scripts/test", "--sanitizers"], calls)
        self.check([".ci/run"], calls)

    def test_all(self):
        for release, other in (("bookworm", "trixie"), ("trixie", "bookworm"), ("forky", "trixie")):
            calls = ["setup --all", "format --check", *LONG_ADDRESS, *THREAD, "build clang", f"root {other}", "build release", "ctest build/release"]
            self.check(["scripts/test", "--all"], calls, release=release)

    def test_a_fresh_system(self):
        for options in (["trixie"], ["trixie", "--sanitizers"]):
            made, done = self.run_with("scripts/test", "--root", *options)
            self.assertEqual((done.returncode, made), (0, [f"root {' '.join(options)}"]))

    @unittest.skipIf(os.getuid() != 0, "it takes root")
    def test_a_network(self):
        self.check(["scripts/test", "--network"], ["setup", "format --check", "build release network_suites", "ctest build/release ^network$"])

    def test_a_network_without_root(self):
        lower = ["setpriv", "--reuid=65534", "--clear-groups"] if os.getuid() == 0 else []
        done = subprocess.run([*lower, ROOT / "scripts/test", "--network"], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (77, "test: skipped: hosts with networks of their own need root\n", ""))

    def test_the_first_failure_ends_it(self):
        for failing, code, last in (("setup-", 1, "setup"), ("format---check", 1, "format --check"), ("build-asan", 3, ADDRESS[0]),
                                    ("build-release", 4, RELEASE[0])):
            made, done = self.run_with("scripts/test", "--sanitizers", fails={failing: code})
            self.assertEqual((done.returncode, made[-1]), (code, last))
        made, done = self.run_with("scripts/test", "--all", fails={"root-trixie": 1})
        self.assertEqual((done.returncode, made[-1]), (1, "root trixie"))

    def test_a_suite_that_fails(self):
        made, done = self.run_with("scripts/test", "--sanitizers", fails={"ctest---test-dir": 8})
        self.assertEqual((done.returncode, made[-1]), (1, ADDRESS[1]))
        self.assertIn("tests passed", done.stdout)
        made, done = self.run_with("scripts/test", fails={"ctest---test-dir": 8})
        self.assertEqual((done.returncode, made[-1]), (8, RELEASE[1]))

    def test_no_fresh_system_can_be_made(self):
        made, done = self.run_with("scripts/test", "--all", fails={"root-trixie": 77})
        self.assertEqual((done.returncode, made[-1]), (0, "ctest build/release"))
        self.assertIn("test: not run\n", done.stdout)


if __name__ == "__main__":
    unittest.main()
