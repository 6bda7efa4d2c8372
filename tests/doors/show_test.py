"""The quirk software-show: windows and buffers have the same contents as without it.

    show_test.py GLURAY DOOR PROGRAM [CASE ...]

PROGRAM CASE draws and writes what its window shows and what it reads as PPMs to standard output; without a case it names
them all. Needs an X server (with_display.py).
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from compare_images import images

ALONE = {"moving", "unchanged", "smaller_viewport", "far_plane"}  # cases in which every frame can be shown without the back buffer
NOISE = 2 / 100  # of the pixels may differ from the real OpenGL's: edges, and lines at surfaces


def run(command, **environment):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=100, check=False,
                          env={**os.environ, **environment})
    if done.returncode:
        raise SystemExit(f"{' '.join(command)} ended with {done.returncode}: {done.stderr.decode()[-500:]}")
    return images(done.stdout), done.stderr.decode()


def different(a, b):
    """Share of pixels that differ by more than two steps in a channel."""
    (width, height, one), (_, _, two) = a, b
    if (width, height) != b[:2]:
        return 1
    count = sum(any(abs(one[3 * i + c] - two[3 * i + c]) > 2 for c in range(3)) for i in range(width * height))
    return count / (width * height)


def problems_of(gluray, door, program, case):
    """The errors of one case, one a line."""
    with tempfile.NamedTemporaryFile() as log, tempfile.NamedTemporaryFile() as report:
        def traced(quirk):
            got, _ = run([gluray, "--door", door, "--engine", "always", "--quirk", f"software-show={quirk}",
                          "--report", report.name, "--", program, case], GLURAY_LOG=log.name, GLURAY_LOG_LEVEL="info")
            return got
        without, real = traced("off"), run([program, case])[0]
        if b"software-show is active" in log.read():
            yield "the quirk is off and at work"
        shown = traced("on")
        log.seek(0)
        if b"software-show is active" not in log.read():
            yield "the quirk has done nothing"
        if case == "unchanged" and json.loads(pathlib.Path(report.name).read_text())["repeated"] < 2:
            yield "frames in which nothing changes are traced again"
    if len(shown) != len(without) or len(shown) != len(real) or not shown:
        yield f"{len(shown)} images, {len(without)} without the quirk, {len(real)} without GLuRay"
    for i, (a, b, c) in enumerate(zip(shown, without, real)):
        if a != b:
            yield f"image {i}: differs from that without the quirk in {different(a, b):.2%} of the pixels"
        if case in ALONE and i == 0 and different(a, c) > NOISE:
            yield f"image {i}: differs from the real OpenGL's in {different(a, c):.2%} of the pixels"


def main():
    gluray, door, program, *cases = sys.argv[1:]
    if not cases:
        cases = subprocess.run([program], stderr=subprocess.PIPE, check=False).stderr.decode().split()
    bad = 0
    for case in cases:
        problems = list(problems_of(gluray, door, program, case))
        print(case, "differs:" if problems else "is the same", "; ".join(problems))
        bad += bool(problems)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
