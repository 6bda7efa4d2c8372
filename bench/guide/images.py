#!/usr/bin/env python3
"""Makes the pictures of docs/gallery.md and docs/guide/light.md again: the program's own beside those that the pages' commands make.

bench/guide/pictures.toml has the scene, the command and the size of each picture. --pages writes its commands into the pages, and makes no picture.

python3 bench/guide/images.py [--build build/release] [--only NAME,...]
python3 bench/guide/images.py --pages
"""
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "bench" / "guide"
sys.path[:0] = [str(HERE), str(ROOT / "bench")]
sys.dont_write_bytecode = True
import pictures  # noqa: E402
from support.display import NoDisplay, display  # noqa: E402
from support.options import Parser  # noqa: E402

PYTHON = "/usr/bin/python3"  # Debian's, which has VTK and Pillow
PATIENCE = 1800  # seconds for one picture


def own_command(row, out):
    """The command that draws a picture without GLuRay, multisampled; of a program that writes no file, GLuRay saves the window as the real OpenGL draws it."""
    program = pictures.program_of(row, out)
    if "{out}" in row.get("program", pictures.DRAW):
        return program.replace("--samples 0", "--samples 8")
    return f"gluray run --engine never --shot {out} --quit -- {program}"


def run(command, build, screen):
    """Runs a command of a page. Returns whether it worked."""
    begin = {"gluray": str(build / "apps" / "gluray" / "gluray"), "python3": PYTHON}
    words = [begin.get(word, word) for word in shlex.split(command)]
    return subprocess.run(words, cwd=ROOT, env={**os.environ, "DISPLAY": screen, "PATH": "/usr/bin:/bin"}, timeout=PATIENCE, check=False).returncode == 0


def make(build, row, screen):
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        own = row.get("own", True)
        files = [f"{folder}/{number}.png" for number in range(own + len(row["commands"]))]
        commands = [own_command(row, files[0])] if own else []
        commands += pictures.commands_of(row, files[own:])
        done = all(run(command, build, screen) for command in commands)
        out = pictures.DOCS / f"{row['file']}.png"
        out.parent.mkdir(parents=True, exist_ok=True)
        done = done and subprocess.run([PYTHON, str(HERE / "beside.py"), str(out), *files], check=False).returncode == 0
    print(f"{row['file']}: {f'{time.monotonic() - began:.0f} s' if done else 'failed'}", flush=True)
    return done


def main():
    parser = Parser(__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--only", default="", help="make these pictures alone (light/metal,gallery/rock)")
    parser.add_argument("--pages", action="store_true", help="write the pages alone")
    options = parser.parse_args()
    if options.pages:
        for page, _, text in pictures.pages():
            page.write_text(text)
        return 0
    rows = {row["file"].removeprefix("guide/"): row for row in pictures.table().values() if "made_by" not in row}
    names = options.only.split(",") if options.only else list(rows)
    try:
        with display() as screen:
            return 0 if all([make(options.build.resolve(), rows[name], screen) for name in names]) else 1
    except NoDisplay as error:
        print(f"images: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
