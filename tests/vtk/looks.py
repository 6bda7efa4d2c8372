"""The looks that GLuRay ships (presets) keep data readable: twelve scenes by VTK, compared with the program's own pictures.

    looks.py --gluray GLURAY --out FOLDER LOOK...

Needs an X server of its own (tests/doors/with_display.py). The figures are those of bench/looks/measure.py, their limits those of bench/looks/rules.py. The pictures stay in FOLDER/looks-LOOK of the first look.
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
    from rules import LIMITS, PURPOSE, SMOOTH, misses
    from scenes import SCENES
except ImportError as missing:
    print(f"skipped: {missing} ({sys.executable})")
    sys.exit(77)

SIZE = "320x240"


def scenes_of(look):
    """Looks that are made for some scenes are tested on these."""
    return PURPOSE.get(look, list(SCENES))


def draw(folder, *before, values=False, samples=0, scenes=()):
    program = [str(ROOT / "bench" / "looks" / "draw.py"), *(["--values"] if values else []), "--samples", str(samples), str(folder), SIZE, *scenes]
    command = [*before, "/usr/bin/python3", "-B", *program]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=550)
    if done.returncode:
        sys.exit(f"exit code {done.returncode}: {' '.join(command)}\n{done.stderr}")


def faults(out, look):
    for scene in scenes_of(look):
        figures = vars(figures_of(out / ("smooth" if look in SMOOTH else "own"), out / look, scene, out / "own"))
        for name in misses(look, scene, figures):
            yield f"{look}, {scene}: {name} is {figures[name]:.3f}, beyond {LIMITS[name]}"


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("looks", nargs="+")
    options = parser.parse_args()
    out = options.out / f"looks-{options.looks[0]}"
    draw(out / "own", values=True)
    if any(look in SMOOTH for look in options.looks):
        draw(out / "smooth", values=True, samples=8)
    found = []
    for look in options.looks:
        draw(out / look, options.gluray, "--preset", look, "--", scenes=scenes_of(look))
        found += faults(out, look)
    print("\n".join(found) if found else f"{sum(len(scenes_of(look)) for look in options.looks)} pictures within all limits")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
