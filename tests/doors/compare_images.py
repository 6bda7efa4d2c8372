"""Runs a program that writes PPM images to standard output, without GLuRay and through a door, and compares them.

    compare_images.py --gluray GLURAY --door DOOR -- PROGRAM [ARGUMENTS]

At most 0.5 % of the pixels may differ by more than 8 of 255, and something must have been traced.
"""
from __future__ import annotations

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

DIFFERENT, SHARE = 8, 0.005
SKIPPED = 77


def images(data: bytes) -> list[tuple[int, int, bytes]]:
    """Width, height and RGB bytes of each image of a stream."""
    found = []
    while data:
        magic, size, depth, rest = data.split(b"\n", 3)
        assert magic == b"P6" and depth == b"255", "not a PPM image"
        width, height = map(int, size.split())
        found.append((width, height, rest[:width * height * 3]))
        data = rest[width * height * 3:]
    return found


def differing(a: bytes, b: bytes) -> int:
    """Pixels of which some channel differs too much."""
    return sum(any(abs(a[i + c] - b[i + c]) > DIFFERENT for c in range(3)) for i in range(0, len(a), 3))


def main() -> int:
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--door", choices=["vendor", "preload"], required=True)
    parser.add_argument("program", nargs="+")
    options = parser.parse_args()

    def run(*arguments: str) -> list[tuple[int, int, bytes]]:
        done = subprocess.run([options.gluray, *arguments, "--", *options.program], stdout=subprocess.PIPE,
                              timeout=100)
        if done.returncode == SKIPPED and "--off" in arguments:  # the real OpenGL has no such windows
            sys.exit(SKIPPED)
        done.check_returncode()
        return images(done.stdout)

    plain = run("--off")
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        ours = run("--door", options.door, "--shading", "vertex", "--report", str(report))
        seen = json.loads(report.read_text())
    problems = []
    if len(plain) != len(ours) or not plain:
        problems.append(f"{len(plain)} images without, {len(ours)} with")
    for i, (a, b) in enumerate(zip(plain, ours)):
        if len(set(a[2])) < 10:
            problems.append(f"image {i}: nothing is to be seen without GLuRay")
        if a[:2] != b[:2]:
            problems.append(f"image {i}: {a[0]}x{a[1]} without, {b[0]}x{b[1]} with")
            continue
        count = differing(a[2], b[2])
        print(f"image {i}: {count} of {a[0] * a[1]} pixels differ by more than {DIFFERENT}")
        if count > SHARE * a[0] * a[1]:
            problems.append(f"image {i} differs")
    if seen["triangles"]["traced"] == 0:
        problems.append("nothing was traced")
    print("\n".join(problems), file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
