"""Compares pictures of vispy that GLuRay traces with those that the real OpenGL draws: equal to 2 of 255 but for silhouettes. Also those that it leaves to the real OpenGL.

A script of states draws each group, "traced" and "untraced". Ends with 77 where vispy is not installed. Needs an X server of its own (tests/doors/with_display.py).
"""
import dataclasses
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[1] / "tools"))
from command_line import Parser  # noqa: E402

BEYOND, FAR = 2, 4      # of 255
AT_ONCE = 16            # states of a process: each has a window and a context of its own
MOST_BEYOND = 0.002     # share of pixels: silhouettes, where OpenGL rounds corners


@dataclasses.dataclass(frozen=True)
class Kind:
    """What is drawn: the module of its states, the least triangles of a state, and a reason for which the real OpenGL draws none that are traced."""
    doc: str
    module: str
    triangles: int
    refused: str


def arguments(kind):
    parser = Parser(kind.doc)
    parser.add_argument("--gluray", type=pathlib.Path, required=True, help="the launcher")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for pictures")
    parser.add_argument("--python", default="/usr/bin/python3", help="the interpreter that has vispy")
    parser.add_argument("states", nargs="*", help="states (all)")
    return parser.parse_args()


def run(command, out):
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "XDG_RUNTIME_DIR": str(out)}
    subprocess.run([str(word) for word in command], check=True, timeout=500, env=environment)


def states(options, kind, group):
    """Names of the group's states that this version has."""
    code = "import sys, importlib; sys.path.append(sys.argv[1]); print('\\n'.join(importlib.import_module(sys.argv[2]).groups()[sys.argv[3]]))"
    listed = subprocess.run([options.python, "-c", code, str(HERE), kind.module, group], capture_output=True, text=True, check=True).stdout.splitlines()
    return [name for name in listed if name and (name in options.states or not options.states)]


def drawn(options, kind, group, names):
    """Pictures without GLuRay and with it, and its report."""
    import numpy as np  # after the options are read: a Python may lack it
    script = [options.python, HERE / f"{kind.module}.py", group]
    off, on, report = (options.out / f"{kind.module}-{group}-{name}" for name in ("off.npz", "on.npz", "report.json"))
    run([*script, off, *names], options.out)
    run([options.gluray, "--engine", "always", "--report", report, "--", *script, on, *names], options.out)
    return np.load(off), np.load(on), json.loads(report.read_text())


def differing(off, on):
    """Shares of pixels that differ by more than BEYOND and FAR, and whether the picture shows something."""
    import numpy as np
    most = np.abs(off.astype(int) - on.astype(int)).max(axis=2)
    shown = (np.abs(off.astype(int) - off[0, 0].astype(int)).max(axis=2) > BEYOND).mean()
    return (most > BEYOND).mean(), (most > FAR).mean(), shown


def compared(options, kind, group, names):
    off, on, report = drawn(options, kind, group, names)
    failed = 0
    for name in off.files:
        beyond, far, shown = differing(off[name], on[name])
        bad = beyond > MOST_BEYOND or shown < 0.02
        failed += bad
        print(f"{group:9} {name:28} beyond {BEYOND}: {100 * beyond:.3f} %, beyond {FAR}: {100 * far:.3f} %, shown {100 * shown:.0f} %{'  FAILED' if bad else ''}", flush=True)
    traced, because = report["triangles"]["traced"], report["draws"]["rasterised"]
    least = kind.triangles * len(off.files) if group == "traced" else 0
    if traced < least or (group == "traced" and kind.refused in because) or (group != "traced" and traced):
        print(f"{group}: {traced} triangles traced; by the real OpenGL: {because}")
        failed += 1
    return failed


def of_group(options, kind, group):
    names = states(options, kind, group)
    return sum(compared(options, kind, group, names[i:i + AT_ONCE]) for i in range(0, len(names), AT_ONCE))


def main(kind):
    options = arguments(kind)
    options.out.mkdir(parents=True, exist_ok=True)
    if subprocess.run([options.python, "-c", "import vispy"], capture_output=True, check=False).returncode:
        print("vispy is not installed")
        return 77
    groups = [group for group in ("traced", "untraced") if states(options, kind, group)]
    failed = sum(of_group(options, kind, group) for group in groups)
    return 1 if failed or not groups else 0
