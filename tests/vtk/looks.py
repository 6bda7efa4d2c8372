"""The looks that GLuRay ships (presets) keep data readable: twelve scenes by VTK, compared with the program's own pictures.

    looks.py --gluray GLURAY --out FOLDER LOOK...

Needs an X server of its own (tests/doors/with_display.py). The figures and their limits are those of bench/looks/measure.py. The pictures stay in FOLDER/looks.
Exit code 77: VTK, numpy or Pillow is not installed.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "bench" / "looks")]
sys.dont_write_bytecode = True
from command_line import Parser  # noqa: E402

try:
    import vtkmodules  # noqa: F401
    from measure import figures_of
    from scenes import SCENES
except ImportError as missing:
    print(f"skipped: {missing} ({sys.executable})")
    sys.exit(77)

SIZE = "320x240"


def draw(folder, *before, values=False):
    command = [*before, "/usr/bin/python3", "-B", str(ROOT / "bench" / "looks" / "draw.py"), str(folder), SIZE, *(["--values"] if values else [])]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=550)
    if done.returncode:
        sys.exit(f"exit code {done.returncode}: {' '.join(command)}\n{done.stderr}")


def faults(out, look):
    for scene in SCENES:
        figures = figures_of(out / "own", out / look, scene)
        for name in figures.misses():
            yield f"{look}, {scene}: {name} is {getattr(figures, name):.3f}, beyond {figures.LIMITS[name]}"


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("looks", nargs="+")
    options = parser.parse_args()
    out = options.out / "looks"
    draw(out / "own", values=True)
    found = []
    for look in options.looks:
        draw(out / look, options.gluray, "--preset", look, "--")
        found += faults(out, look)
    print("\n".join(found) if found else f"{len(options.looks) * len(SCENES)} pictures within all limits")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
