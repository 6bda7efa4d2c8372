"""ParaView's window with and without GLuRay: two render views and a spreadsheet, before and after the mouse has turned one.

    gui.py --gluray GLURAY --out FOLDER

Needs an X server of its own (tests/doors/with_display.py). Leaves gui-NUMBER-off.png, -on.png and -difference.png in
FOLDER. Exit code 77: ParaView or xdotool is not installed.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import time

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "live"))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import batch  # noqa: E402
import images  # noqa: E402
from command_line import Parser  # noqa: E402

BEYOND = 0.005      # share of the window's pixels that may differ by more than 8 of 255: it shows lines and text over surfaces
START_SECONDS = 100  # until the script has run, on a machine that is busy with other things
REST_SECONDS = 1.5   # without a change: the window is finished
STATUS_ROWS = 40     # at the bottom of the window: how much memory is used
VIEW = (500, 400)    # a point of the first render view


def at_rest():
    """The screen once it has not changed for a while."""
    last, since, deadline = None, time.monotonic(), time.monotonic() + START_SECONDS
    while time.monotonic() < deadline:
        now = without_status(images.grab())
        if last is None or now.shape != last.shape or not np.array_equal(now, last):
            last, since = now, time.monotonic()
        elif time.monotonic() - since > REST_SECONDS:
            return now
        time.sleep(0.2)
    raise RuntimeError(f"the window does not come to rest within {START_SECONDS} s")


def without_status(screen):
    image = screen[images.window_box(screen)]
    return image[:-STATUS_ROWS]


def drag(by):
    """The left button pressed at VIEW and moved in steps: a trackball adds them up, however many of them arrive."""
    x, y = VIEW
    steps = [("mousemove", x, y), ("mousedown", 1), ("mousemove", x + by[0], y + by[1]), ("mouseup", 1), ("mousemove", 2, 2)]
    for step in steps:
        subprocess.run(["xdotool", *map(str, step)], check=True)
        time.sleep(0.4)


def run(launcher, folder):
    """The images of one run."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    ready = folder / "ready"
    settings = batch.environment(folder / "home", QT_QPA_PLATFORM="xcb", VTK_GUI_READY=str(ready), XDG_RUNTIME_DIR=str(folder))
    with open(folder / "log", "w") as log:
        process = subprocess.Popen([*launcher, "paraview", "--disable-registry", f"--script={HERE / 'gui_script.py'}"], env=settings,
                                   stdout=log, stderr=log, cwd=folder)
    try:
        deadline = time.monotonic() + START_SECONDS
        while not ready.exists():
            if process.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError(f"its script does not end: see {folder / 'log'}")
            time.sleep(0.1)
        seen = [at_rest()]
        for by in ((60, 25), (-30, 40)):
            drag(by)
            seen.append(at_rest())
        if process.poll() is not None:
            raise RuntimeError(f"it ended with {process.returncode}: see {folder / 'log'}")
        return seen
    finally:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", required=True)
    given = parser.parse_args()
    for program in ("paraview", "xdotool"):
        if not shutil.which(program):
            print(f"skipped: {program} is not installed")
            return 77
    out, gluray = pathlib.Path(given.out).resolve() / "gui", str(pathlib.Path(given.gluray).resolve())
    out.mkdir(parents=True, exist_ok=True)
    off = run([], out / "plain")
    report = out / "report.json"
    report.unlink(missing_ok=True)
    on = run([gluray, "run", *batch.always(gluray), "--report", str(report), "--"], out / "traced")

    wrong = []
    if report.exists():
        counted = json.loads(report.read_text())
        print(json.dumps({name: counted[name] for name in ("triangles", "draws", "frames", "mesh")}))
        if counted["triangles"]["traced"] == 0:
            wrong.append("nothing was traced")
    else:
        wrong.append("GLuRay wrote no report")
    for i, (a, b) in enumerate(zip(off, on)):
        images.write_png(out / f"gui-{i}-off.png", np.ascontiguousarray(a))
        images.write_png(out / f"gui-{i}-on.png", np.ascontiguousarray(b))
        if a.shape != b.shape:
            wrong.append(f"image {i}: {b.shape[1]}x{b.shape[0]} instead of {a.shape[1]}x{a.shape[0]}")
            continue
        images.write_png(out / f"gui-{i}-difference.png", images.difference_image(a, b))
        share = images.share_beyond(a, b)
        print(f"image {i}: {share:.4%} differs")
        if share > BEYOND:
            wrong.append(f"image {i}: {share:.4%} of its pixels differ by more than {images.VISIBLE}/255, at most {BEYOND:.4%} may; see {out}")
    moved = [images.share_beyond(a, b) for a, b in zip(off, off[1:]) if a.shape == b.shape]
    if len(moved) < 2 or min(moved) < 0.01:
        wrong.append(f"the mouse does not turn the view: {moved}")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
