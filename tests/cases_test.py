#!/usr/bin/env python3
"""Fails if ctest runs fewer cases of a GoogleTest program than the program has, or one of them twice under one label.

cases_test.py CTEST BUILD    Programs that are not built, as under a sanitizer, are left out.

Each test names its cases by --gtest_filter and their number by --cases; the program itself fails where another number runs.
"""
import fnmatch
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cmake"))
from list_tests import cases


def option(command, name):
    """Value of --NAME=VALUE in a command; None without it."""
    return next((word.removeprefix(f"--{name}=") for word in command if word.startswith(f"--{name}=")), None)


def labels(test):
    return tuple(label for p in test.get("properties", []) if p["name"] == "LABELS" for label in p["value"])


def problems(program, every, tests):
    """The errors in the tests of one program, one a line. `tests`: (name, labels, filter, number)."""
    chosen_by = {}
    for name, label, patterns, number in tests:
        chosen = [case for case in every if any(fnmatch.fnmatchcase(case, pattern) for pattern in patterns.split(":"))]
        if len(chosen) != number:
            yield f"{name} says that it runs {number} cases, its filter chooses {len(chosen)}"
        for case in chosen:
            chosen_by.setdefault(case, []).append((name, label))
    for case in every:
        runs = chosen_by.get(case, [])
        if not runs:
            yield f"{program}: ctest does not run {case}"
        if len(runs) != len({label for _, label in runs}):
            yield f"{program}: {case} runs twice, in {' and '.join(name for name, _ in runs)}"


def self_test():
    """The check sees a case that no test runs, one that two run, and a wrong number."""
    every = ["A.one", "A.two", "B/C.one/0"]
    whole = [("A", ("unit",), "A.*", 2), ("B/C", ("unit",), "B/C.*", 1), ("A", ("thread",), "A.two", 1)]
    assert list(problems("p", every, whole)) == []
    assert len(list(problems("p", every, whole[:1]))) == 1
    assert len(list(problems("p", every, [*whole, ("A.one", ("unit",), "A.one", 1)]))) == 1
    assert len(list(problems("p", every, [("A", ("unit",), "A.*", 3), whole[1]]))) == 1


def main():
    self_test()
    ctest, build = sys.argv[1:3]
    listing = subprocess.run([ctest, "--show-only=json-v1"], cwd=build, check=True, capture_output=True, text=True).stdout
    programs = {}
    for test in json.loads(listing)["tests"]:
        command = test.get("command", [])
        number = option(command, "cases")
        if number is not None and pathlib.Path(command[0]).exists():
            tests = programs.setdefault(command[0], [])
            tests.append((test["name"], labels(test), option(command, "gtest_filter"), int(number)))
    found, total, processes = [], 0, 0
    for program, tests in programs.items():
        every = [f"{suite}.{name}" for suite, names in cases(program).items() for name in names]
        total += len(every)
        processes += len(tests)
        found += problems(pathlib.Path(program).name, every, tests)
    print("\n".join(found))
    print(f"{len(programs)} programs, {total} cases in {processes} tests")
    return 1 if found or not programs else 0


if __name__ == "__main__":
    sys.exit(main())
