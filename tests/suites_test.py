#!/usr/bin/env python3
"""Fails if a test that scripts/test must run uses a program that its target does not build: there it would be
left out without a word, since a suite that was not built has no tests with labels.

suites_test.py CTEST BUILD    BUILD holds suites/TARGET.txt: the files that each target builds (cmake/GluraySuites.cmake)
"""
import json
import pathlib
import subprocess
import sys

# Target, and the labels of the tests whose programs it must build. scripts/test builds and runs them.
SUITES = {"address_suites": {"unit", "variant", "link", "fuzz", "long"}, "thread_suites": {"thread"},
          "release_suites": {"unit", "variant", "link", "thread", "reference", "stream", "style", "live"}}


def labels(test):
    return {label for p in test.get("properties", []) if p["name"] == "LABELS" for label in p["value"]}


def programs(test, build):
    """The built files in the test's command: the program itself, and files within the build folder."""
    for position, word in enumerate(test.get("command", [])):
        path = pathlib.Path(word)
        if path.is_relative_to(build) and (position == 0 or path.is_file()):
            yield path


def main():
    ctest, build = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    listing = subprocess.run([ctest, "--show-only=json-v1"], cwd=build, check=True, capture_output=True, text=True).stdout
    tests = json.loads(listing)["tests"]
    failures = 0
    for target, wanted in SUITES.items():
        built = {pathlib.Path(line) for line in (build / "suites" / f"{target}.txt").read_text().split("\n") if line}
        chosen = [test for test in tests if labels(test) & wanted]
        lost = {(test["name"], path) for test in chosen for path in programs(test, build) if path not in built}
        for name, path in sorted(lost):
            print(f"{name} runs {path.relative_to(build)}, which {target} does not build (cmake/GluraySuites.cmake)")
        print(f"{target}: {len(chosen)} tests, {len(built)} programs and libraries, {len(lost)} lost")
        failures += len(lost)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
