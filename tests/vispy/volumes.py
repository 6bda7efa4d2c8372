"""Compares volumes of vispy that GLuRay traces with those that the real OpenGL draws: equal to 2 of 255 but for silhouettes. Also those that it leaves to the real OpenGL.

Ends with 77 where vispy is not installed. Needs an X server of its own (tests/doors/with_display.py).
"""
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[1] / "tools"))
from command_line import Parser  # noqa: E402


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", type=pathlib.Path, required=True, help="the launcher")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for pictures")
    parser.add_argument("--python", default="/usr/bin/python3", help="the interpreter that has vispy")
    parser.add_argument("states", nargs="*", help="states (all)")
    return parser.parse_args()


OPTIONS = arguments()  # before the import of what a Python may lack
import numpy as np  # noqa: E402

BEYOND, FAR = 2, 4      # of 255
MOST_BEYOND = 0.002     # share of pixels: silhouettes, where OpenGL rounds corners
TRIANGLES = 12          # of a volume's box
REFUSED = "volume with state or values that are not traced"


def run(command, out):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "XDG_RUNTIME_DIR": str(out)}
    subprocess.run([str(word) for word in command], check=True, timeout=500, env=environment)


def states(options, group):
    """Names of the group's states that this version has."""
    code = "import sys; sys.path.append(sys.argv[1]); import volume_states; print('\\n'.join(volume_states.groups()[sys.argv[2]]))"
    listed = subprocess.run([options.python, "-c", code, str(HERE), group], capture_output=True, text=True, check=True).stdout.splitlines()
    return [name for name in listed if name and (name in options.states or not options.states)]


def drawn(options, group):
    """Pictures without GLuRay and with it, and its report."""
    script = [options.python, HERE / "volume_states.py", group]
    off, on, report = (options.out / f"{group}-{name}" for name in ("off.npz", "on.npz", "report.json"))
    names = states(options, group)
    run([*script, off, *names], options.out)
    run([options.gluray, "--engine", "always", "--report", report, "--", *script, on, *names], options.out)
    return np.load(off), np.load(on), json.loads(report.read_text())


def differing(off, on):
    """Shares of pixels that differ by more than BEYOND and FAR, and whether the picture shows something."""
    most = np.abs(off.astype(int) - on.astype(int)).max(axis=2)
    shown = (np.abs(off.astype(int) - off[0, 0].astype(int)).max(axis=2) > BEYOND).mean()
    return (most > BEYOND).mean(), (most > FAR).mean(), shown


def compared(options, group):
    off, on, report = drawn(options, group)
    failed = 0
    for name in off.files:
        beyond, far, shown = differing(off[name], on[name])
        bad = beyond > MOST_BEYOND or shown < 0.02
        failed += bad
        print(f"{group:9} {name:28} beyond {BEYOND}: {100 * beyond:.3f} %, beyond {FAR}: {100 * far:.3f} %, shown {100 * shown:.0f} %{'  FAILED' if bad else ''}", flush=True)
    traced, because = report["triangles"]["traced"], report["draws"]["rasterised"]
    least = TRIANGLES * len(off.files) if group == "traced" else 0
    if traced < least or (group == "traced" and REFUSED in because) or (group != "traced" and traced):
        print(f"{group}: {traced} triangles traced; by the real OpenGL: {because}")
        failed += 1
    return failed


def main(options):
    options.out.mkdir(parents=True, exist_ok=True)
    if subprocess.run([options.python, "-c", "import vispy"], capture_output=True, check=False).returncode:
        print("vispy is not installed")
        return 77
    groups = [group for group in ("traced", "untraced") if states(options, group)]
    failed = sum(compared(options, group) for group in groups)
    return 1 if failed or not groups else 0


if __name__ == "__main__":
    sys.exit(main(OPTIONS))
