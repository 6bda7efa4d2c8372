"""Lines that ParaView and VTK draw by geometry shaders, because OpenGL does not draw them so wide.

    wide_lines.py --gluray GLURAY --out FOLDER

Needs an X server of its own (tests/doors/with_display.py). As tubes, lines of width 7 equal lines of width 1 under `lines.width=7`; with
`lines` off all pictures are those without GLuRay. The pictures are in FOLDER/wide_lines. Exit code 77: ParaView, VTK or numpy is not installed.
"""
import pathlib
import shutil
import subprocess
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parents[1] / "tools"))
sys.dont_write_bytecode = True
import batch  # noqa: E402
from command_line import Parser  # noqa: E402
from compare import read_png  # noqa: E402
from wide_line_scenes import SCENES  # noqa: E402

WIDTH = {"pvbatch": 7, "vtk": 300}  # pixels; plain VTK leaves up to 255 to Mesa
FAMILY = "wide lines: "             # the end of the families' names in what gluray explain prints


def draw(folder, program, width, names, *launcher):
    """Draws scenes, and returns what the process printed."""
    folder.mkdir(parents=True, exist_ok=True)
    words, more = batch.command(program, launcher, None)
    command = [*words, str(HERE / "wide_line_scenes.py"), str(folder), str(width), *names]
    done = subprocess.run(command, env=batch.environment(folder / "home", **more), capture_output=True, text=True, timeout=batch.SECONDS)
    if done.returncode:
        raise RuntimeError(f"exit code {done.returncode}: {' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def faults_of(out, program, gluray):
    names = [name for name in SCENES if name.startswith("vtk_") == (program == "vtk")]
    width = WIDTH[program]
    draw(out / "own", program, width, names)
    explained = draw(out / "off", program, width, names, gluray, "explain", "--engine", "always", "--")
    tubes = (gluray, "explain", "--engine", "always", "--set", "lines=tubes")
    round_ = draw(out / "round", program, width, names, *tubes, "--")
    draw(out / "asked", program, 1, names, *tubes, "--set", f"lines.width={width}", "--")
    if "rasterised: lines" not in explained:
        yield f"{program}: gluray explain does not say that lines are rasterised because they are lines:\n{explained}"
    known = [line.strip() for line in round_.splitlines() if FAMILY in line]
    if len(known) < 2 or any(" 0 rasterised" not in line for line in known):
        yield f"{program}: not all shader programs of wide lines are traced: {known}"
    for name in names:
        own, off, round_, asked = (read_png(out / folder / f"{name}.png").astype(int) for folder in ("own", "off", "round", "asked"))
        if not np.array_equal(own, off):
            yield f"{name}: {int((own != off).any(axis=2).sum())} pixels differ while lines are the program's"
        if not np.array_equal(round_, asked):
            yield f"{name}: {int((round_ != asked).any(axis=2).sum())} pixels differ from lines.width={width}"
        if (np.abs(round_ - own).max(axis=2) > 20).mean() < 0.01:
            yield f"{name}: no tubes are seen"


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    out = options.out / "wide_lines"
    shutil.rmtree(out, ignore_errors=True)
    try:
        faults = [fault for program in WIDTH for fault in faults_of(out, program, options.gluray)]
    except batch.Skipped as why:
        print("skipped:", why)
        return 77
    print("\n".join(faults) if faults else f"{len(SCENES)} scenes of wide lines are as they should be")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
