"""Writes a GoogleTest program's tests as a file that ctest includes:

    list_tests.py PROGRAM FILE --prefix PREFIX --alone=PATTERN;... --only=PATTERN;... --except=PATTERN;... --properties NAME VALUE ...

One test a suite; one a case where a pattern of --alone matches. cmake/GlurayTests.cmake calls it.
"""
from __future__ import annotations

import argparse
import fnmatch
import pathlib
import subprocess


def cases(program: str) -> dict[str, list[str]]:
    """Names of the cases by suite, in the program's order, without those that are disabled."""
    listing = subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True, text=True, timeout=60).stdout
    found: dict[str, list[str]] = {}
    suite = ""
    for line in listing.splitlines():
        name = line.split("#")[0].rstrip()
        if name.startswith("  "):
            if "DISABLED_" not in suite + name:
                found.setdefault(suite, []).append(name.strip())
        elif name.endswith("."):
            suite = name[:-1]
    return found


def matches(name: str, patterns: list[str]) -> bool:
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)


def registered(found: dict[str, list[str]], alone: list[str], only: list[str], left: list[str]) -> list[tuple[str, str, int]]:
    """Name, filter and number of cases of each test."""
    tests = []
    for suite, names in found.items():
        wanted = [name for name in names if (not only or matches(f"{suite}.{name}", only)) and not matches(f"{suite}.{name}", left)]
        single = [name for name in wanted if matches(f"{suite}.{name}", alone)]
        common = [name for name in wanted if name not in single]
        if common == names:
            tests.append((suite, f"{suite}.*", len(names)))
        elif common:
            tests.append((suite, ":".join(f"{suite}.{name}" for name in common), len(common)))
        tests += [(f"{suite}.{name}", f"{suite}.{name}", 1) for name in single]
    return tests


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("file")
    parser.add_argument("--prefix", required=True)
    parser.add_argument("--alone", default="")
    parser.add_argument("--only", default="")
    parser.add_argument("--except", default="", dest="left")
    parser.add_argument("--properties", nargs=argparse.REMAINDER, default=[])
    given = parser.parse_args()
    properties = " ".join(f"[==[{word}]==]" for word in given.properties)
    alone, only, left = ([word for word in text.split(";") if word] for text in (given.alone, given.only, given.left))
    lines = []
    for name, chosen, count in registered(cases(given.program), alone, only, left):
        # Suites of many cases begin first where nothing is known of their times.
        test = f"[==[{given.prefix}{name}]==]"
        lines.append(f"add_test({test} [==[{given.program}]==] [==[--gtest_filter={chosen}]==] --cases={count})\n"
                     f"set_tests_properties({test} PROPERTIES {properties} COST {count})\n")
    pathlib.Path(given.file).write_text("".join(lines))


if __name__ == "__main__":
    main()
