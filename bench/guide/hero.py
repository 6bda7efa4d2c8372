#!/usr/bin/env python3
"""Makes the first picture of README.md: a large scene in a window of VTK without GLuRay, with it, and with light, and how many frames a second each shows while
the camera turns.

The rates are medians of rounds in turn; the picture with light is that of the window at rest.

python3 bench/guide/hero.py [--build build/release] [--rounds 3]
"""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "bench" / "guide"
sys.path[:0] = [str(HERE), str(ROOT / "bench")]
sys.dont_write_bytecode = True
import pictures  # noqa: E402
from support.display import NoDisplay, display  # noqa: E402
from support import machine  # noqa: E402
from support.options import Parser  # noqa: E402

OUT = ROOT / "docs" / "guide" / "hero.png"
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK and Pillow
ROW = pictures.table()["guide/hero"]
SCENE, SIZE, FRAMES = ROW["scene"], ROW["size"], 5
LIGHT = pictures.words_of(ROW["commands"][1])
PATIENCE = 600  # seconds


def draw(screen, out, launcher, *options):
    """Draws the scene. Returns what the program prints."""
    command = [*launcher, PYTHON, str(HERE / "draw.py"), SCENE, str(out), SIZE, *options]
    return subprocess.run(command, cwd=HERE, env={"DISPLAY": screen, "PATH": "/usr/bin:/bin"}, timeout=PATIENCE, check=True, capture_output=True, text=True).stdout


def figure(rate):
    """Two digits."""
    return f"{rate:.2f}" if rate < 1 else f"{rate:.1f}" if rate < 10 else f"{rate:.0f}"


def panels(launcher):
    """Name, command before the program, samples of the framebuffer, and text, of each panel."""
    return [("OpenGL", [], "8", "OpenGL (Mesa, {} cores): {} frames a second"),
            ("GLuRay", [*launcher, "--"], "8", "GLuRay, the same cores: {1} frames a second"),
            ("light", [*launcher, *LIGHT, "--"], "0", "GLuRay with light: {1} frames a second")]


def main():
    parser = Parser(__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    shown = panels([str(options.build.resolve() / "apps" / "gluray" / "gluray")])
    rates = {name: [] for name, *_ in shown}
    result = {"suite": "hero", "command": f"bench/guide/hero.py --rounds {options.rounds}", **machine.describe(ROOT)}
    try:
        with display() as screen, tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder) / f"{name}.png" for name, *_ in shown]
            for _ in range(options.rounds):
                for (name, command, samples, _), file in zip(shown, files):
                    rates[name].append(float(draw(screen, file, command, "--samples", samples, "--rate", str(FRAMES))))
            for (_, command, samples, _), file in zip(shown, files):
                draw(screen, file, command, "--samples", samples)
            labels = [text.format(len(os.sched_getaffinity(0)), figure(statistics.median(rates[name]))) for name, _, _, text in shown]
            result["rows"] = [{"scene": SCENE, "path": name, "fps": statistics.median(of), "fps_of_rounds": of} for name, of in rates.items()]
            machine.write(ROOT, "hero", result)
            print(*labels, sep="\n")
            subprocess.run([PYTHON, str(HERE / "beside.py"), str(OUT), *map(str, files), "--labels", *labels], check=True)
    except NoDisplay as error:
        print(f"hero: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
