"""two result files side by side: scripts/bench compare OLD NEW

Compares rows of the same name number by number and prints NEW/OLD, and differences in machine and versions. OLD and NEW are
files, or names of files in bench/results/.
"""
import json
import pathlib
import sys

from support.options import Parser

RESULTS = pathlib.Path(__file__).resolve().parent.parent / "results"
NAMES = ("suite", "stream", "program", "scene", "path", "millions", "look", "ranks", "repeated")  # the keys that identify a row


class Unreadable(RuntimeError):
    """The file is not a result of scripts/bench."""


def read(name):
    path = next((p for p in (pathlib.Path(name), RESULTS / name, RESULTS / f"{name}.json") if p.is_file()), None)
    if path is None:
        raise Unreadable(f"there is no {name}, neither here nor in bench/results")
    try:
        result = json.loads(path.read_text())
        if not isinstance(result["rows"], list):
            raise TypeError
        return result
    except (ValueError, KeyError, TypeError) as error:
        raise Unreadable(f"{path} is not a result of scripts/bench") from error


def name_of(row):
    return " ".join(f"{row[key]}M" if key == "millions" else str(row[key]) for key in NAMES if key in row and row[key] is not True) or "-"


def figures(row, prefix=""):
    """Numbers of a row, those within its tables, too."""
    for key, value in row.items():
        if isinstance(value, dict):
            yield from figures(value, f"{prefix}{key}.")
        elif isinstance(value, (int, float)) and not isinstance(value, bool) and key not in NAMES:
            yield prefix + key, value


def differences(old, new, prefix=""):
    """Lines about differences in machine and versions."""
    for key in sorted(set(old) | set(new)):
        a, b = old.get(key), new.get(key)
        if isinstance(a, dict) and isinstance(b, dict):
            yield from differences(a, b, f"{prefix}{key}.")
        elif a != b and not key.startswith("load"):
            yield f"{prefix}{key}: {a} -> {b}"


def compare(old, new):
    """Lines to be printed."""
    lines = [line for part in ("machine", "versions") for line in differences(old.get(part, {}), new.get(part, {}))]
    before = {name_of(row): dict(figures(row)) for row in old["rows"]}
    after = {name_of(row): dict(figures(row)) for row in new["rows"]}
    table = [("row", "figure", "old", "new", "new/old")]
    for name in before:
        for key in [k for k in before[name] if k in after.get(name, {})]:
            a, b = before[name][key], after[name][key]
            table.append((name, key, f"{a:.4g}", f"{b:.4g}", f"{b / a:.3f}" if a else "-"))
    widths = [max(len(line[i]) for line in table) for i in range(5)]
    lines += ["  ".join(cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(line, widths))) for line in table]
    for title, names in (("only in the old one", before.keys() - after.keys()), ("only in the new one", after.keys() - before.keys())):
        if names:
            lines.append(f"{title}: {', '.join(sorted(names))}")
    return lines


def main(argv):
    parser = Parser(__doc__, prog="scripts/bench compare")
    parser.add_argument("old")
    parser.add_argument("new")
    options = parser.parse_args(argv)
    try:
        print("\n".join(compare(read(options.old), read(options.new))))
    except Unreadable as error:
        print(f"bench: {error}", file=sys.stderr)
        return 1
    return 0
