#!/usr/bin/env python3
"""Records what becomes of every draw and every batch while tests run, and compares two records: versions that decide alike write the same lines.
  tools/decisions.py record BUILD FOLDER [--tests REGEX]   runs tests of a build folder, one file in FOLDER for each test
  tools/decisions.py compare BEFORE AFTER                  differing tests and their first lines; exits with 1 if there are some
Tests run one at a time, because lines of several processes of one test stand in one file. Lines depend on measured times where the setting `engine` or
culling chooses by them: such tests differ from run to run."""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys

from command_line import Parser

# Tests whose programs draw by OpenGL; the others decide nothing.
DRAWING = r"^(reference|vtk|stream|fuzz|live|light|doors\.(scenes|forks)|lag|refine|piglit|program|threads|examples|engine)\."


def tests_of(build, pattern):
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], stdout=subprocess.PIPE, check=True)
    chosen = [test for test in json.loads(listed.stdout)["tests"] if re.search(pattern, test["name"]) and "command" in test]
    return [(test["name"], test["command"], {p["name"]: p["value"] for p in test.get("properties", [])}) for test in chosen]


def file_of(folder, name):
    return folder / (re.sub(r"[^\w.-]", "_", name) + ".log")


def record(build, folder, pattern):
    folder.mkdir(parents=True, exist_ok=True)
    failed = []
    for name, command, properties in tests_of(build, pattern):
        path = file_of(folder, name)
        path.unlink(missing_ok=True)
        environment = dict(os.environ, GLURAY_LOG=str(path.resolve()), GLURAY_LOG_LEVEL="trace")
        environment.update(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
        try:
            code = subprocess.run(command, cwd=properties.get("WORKING_DIRECTORY"), env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  timeout=properties.get("TIMEOUT", 1500) * 2, check=False).returncode
        except subprocess.TimeoutExpired:
            code = "timeout"
        lines = path.read_text(errors="replace").count("\n") if path.exists() else 0
        print(f"{name}: {lines} lines" + (f", exit code {code}" if code not in (0, 77) else ""), flush=True)
        if code not in (0, 77):
            failed.append(name)
    return failed


def lines_of(path):
    return path.read_text(errors="replace").splitlines()


def difference(before, after):
    """The first line that differs, or whether the lines are the same in another order; empty: equal."""
    if before == after:
        return ""
    if collections.Counter(before) == collections.Counter(after):
        return "the same lines in another order"
    for number, pair in enumerate(zip(before + [""], after + [""]), 1):
        if pair[0] != pair[1]:
            return f"line {number}:\n  - {pair[0]}\n  + {pair[1]}"
    return f"{len(before)} lines, then {len(after)}"


def compare(before, after):
    names = sorted({path.name for folder in (before, after) for path in folder.glob("*.log")})
    differing = 0
    for name in names:
        files = [folder / name for folder in (before, after)]
        missing = [str(path) for path in files if not path.exists()]
        found = f"{missing[0]} is missing" if missing else difference(*map(lines_of, files))
        if found:
            differing += 1
            print(f"{name}: {found}")
    print(f"{len(names)} tests, {differing} differ")
    return differing == 0


def main():
    parser = Parser(__doc__)
    parser.add_argument("command", choices=("record", "compare"))
    parser.add_argument("first", type=pathlib.Path, metavar="BUILD|BEFORE")
    parser.add_argument("second", type=pathlib.Path, metavar="FOLDER|AFTER")
    parser.add_argument("--tests", default=DRAWING, metavar="REGEX", help="regular expression of the names of the tests to record")
    arguments = parser.parse_args()
    if not arguments.first.is_dir():
        parser.error(f"{arguments.first} is no folder")
    if arguments.command == "record":
        return 1 if record(arguments.first, arguments.second, arguments.tests) else 0
    if not arguments.second.is_dir():
        parser.error(f"{arguments.second} is no folder")
    return 0 if compare(arguments.first, arguments.second) else 1


if __name__ == "__main__":
    sys.exit(main())
