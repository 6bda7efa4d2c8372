"""Runs one real program without and with ambient occlusion, and compares the images in its window.

    light.py --gluray GLURAY --freeze FREEZE.SO --out FOLDER NAME

Occlusion darkens what stands close together and nothing else: no pixel may become brighter, and some must become darker. Needs an X server of
its own (tests/doors/with_display.py). Leaves NAME-plain.png and NAME-ao.png in FOLDER. Exit code 77: the program is not installed.
"""
import dataclasses
import pathlib
import sys

import run
import numpy as np
import images

BRIGHTER = 0.002  # share of pixels that may be brighter by more than VISIBLE: noise of moving frames, and edges
DARKER = 0.002    # least share of pixels that are darker by more than that
FRAMES = {"superquadrics": 100}  # its solid of frame 40 is convex: nothing occludes it
OCCLUSION = ("--set", "ao=on", "--set", "ao.radius=0.2")


def check(name, plain, lit, report):
    box = images.window_box(np.maximum(plain, lit))
    change = lit[box].astype(np.int16) - plain[box].astype(np.int16)
    brighter, darker = float((change.max(axis=2) > images.VISIBLE).mean()), float((change.min(axis=2) < -images.VISIBLE).mean())
    print(f"{name}: {brighter:.4%} of its pixels are brighter, {darker:.2%} darker; {report and report['light']}")
    wrong = []
    if brighter > BRIGHTER:
        wrong.append(f"{name}: occlusion makes {brighter:.4%} of its pixels brighter")
    if darker < DARKER:
        wrong.append(f"{name}: occlusion makes only {darker:.4%} of its pixels darker")
    return wrong


def main():
    given, program, out = run.begin(run.Parser(__doc__))
    program = dataclasses.replace(program, frame=FRAMES.get(given.name, program.frame))
    launcher, place = [str(pathlib.Path(given.gluray).resolve())], out / f"{given.name}-light.home"
    plain, _ = run.run(program, launcher, given.freeze, place)
    lit, report = run.run(program, [*launcher, *OCCLUSION], given.freeze, place)
    box = images.window_box(np.maximum(plain, lit))
    for kind, image in (("plain", plain), ("ao", lit)):
        images.write_png(out / f"{given.name}-{kind}.png", image[box])
    wrong = check(given.name, plain, lit, report)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
