#!/usr/bin/env python3
"""Makes the pictures of docs/guide/light.md again: the program's own beside those that the page's commands make.

The commands are read from the page: those that stand above a picture make it. The program is bench/guide/draw.py, with VTK.

python3 bench/guide/images.py [--build build/release] [--only NAME,...]
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "bench" / "guide"
sys.path.insert(0, str(ROOT / "bench"))
sys.dont_write_bytecode = True
from support.display import NoDisplay, display  # noqa: E402
from support.options import Parser  # noqa: E402

PAGE = ROOT / "docs" / "guide" / "light.md"
OUT = PAGE.parent / "light"
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK and Pillow
PATIENCE = 1800  # seconds for one picture
OWN = []  # the program without GLuRay
# The scene of each picture (bench/guide/scenes.py).
SCENES = {
    "presentation": "head", "figure": "bars", "poster": "bars_detail", "streamlines": "star", "molecule": "helix", "metal": "bearing", "outdoor": "mountains",
    "honest": "cut", "volume": "orbital", "ospray": "impact_side_lit", "draft": "impact", "quality": "helix_detail", "occlusion": "tubes", "key": "impact", "paths": "impact",
    "balls": "balls", "ground": "bearing", "catcher": "head_from_afar", "lens": "helix_along",
}
WITHOUT_OWN = {"draft", "quality"}  # show the commands' pictures alone


def commands_of_pictures(text):
    """(name of the picture, command lines above it) for each picture of a page."""
    block, last = [], ""
    for line in text.splitlines():
        if line.startswith("    "):
            if not last.startswith("    "):
                block = []
            continued = block and block[-1].endswith("\\")
            block = [*block[:-1], block[-1][:-1] + line.strip()] if continued else [*block, line.strip()]
        for name in re.findall(r"!\[[^\]]*\]\(light/([\w-]+)\.png\)", line):
            yield name, list(block)
        last = line


def words_of(command):
    """The options of a line `gluray OPTIONS PROGRAM`."""
    words = shlex.split(command)
    if words[0] != "gluray" or words[-1] != "PROGRAM":
        raise ValueError(f"not 'gluray OPTIONS PROGRAM': {command}")
    return words[1:-1]


def draw(build, scene, options, out, screen):
    """Draws a scene under GLuRay, which smooths edges itself, or, without options, without it, multisampled. Returns whether it worked."""
    command = [PYTHON, str(HERE / "draw.py"), scene, str(out)]
    if options:
        command = [str(build / "apps" / "gluray" / "gluray"), *options, "--", *command, "--samples", "0"]
    return subprocess.run(command, cwd=HERE, env={**os.environ, "DISPLAY": screen}, timeout=PATIENCE, check=False).returncode == 0


def make(build, name, commands, screen):
    began = time.monotonic()
    panels = [words_of(command) for command in commands]
    if name not in WITHOUT_OWN:
        panels.insert(0, OWN)
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"{number}.png" for number in range(len(panels))]
        done = all(draw(build, SCENES[name], options, file, screen) for options, file in zip(panels, files))
        done = done and subprocess.run([PYTHON, str(HERE / "beside.py"), str(OUT / f"{name}.png"), *map(str, files)], check=False).returncode == 0
    print(f"{name}: {f'{time.monotonic() - began:.0f} s' if done else 'failed'}", flush=True)
    return done


def main():
    parser = Parser(__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--only", default="", help=f"make these pictures alone ({','.join(SCENES)})")
    options = parser.parse_args()
    pictures = dict(commands_of_pictures(PAGE.read_text()))
    names = options.only.split(",") if options.only else list(pictures)
    OUT.mkdir(parents=True, exist_ok=True)
    try:
        with display() as screen:
            return 0 if all([make(options.build.resolve(), name, pictures[name], screen) for name in names]) else 1
    except NoDisplay as error:
        print(f"images: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
