"""Runs one real program with GLuRay switched off and on, in the same way, and compares the images in its window.

    run.py --gluray GLURAY --freeze FREEZE.SO --out FOLDER [--shading vertex|pixel] [--door DOOR] NAME

Needs an X server of its own (tests/doors/with_display.py). Leaves NAME-off.png, NAME-on.png, NAME-difference.png (eight
times as bright) and NAME.json in FOLDER. Exit code 77: the program is not installed.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

import images
import programs

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

START_SECONDS = 100  # until the image is there, on a busy machine
REPORT_SECONDS = 20  # until its frame is in the report: the disk may be slow


class Failed(RuntimeError):
    pass


class Run:
    """A program under `gluray OPTIONS`, until its image is taken."""

    def __init__(self, program, command, options, folder, freeze):
        self.program = program
        self.report = folder / "report.json"
        self.ready, self.go = folder / "ready", folder / "go"
        environment = dict(os.environ, HOME=str(folder), QT_QPA_PLATFORM="xcb", LC_ALL="C") | program.environment
        if program.frame:
            environment |= {"LD_PRELOAD": str(pathlib.Path(freeze).resolve()), "LIVE_FRAME": str(program.frame), "LIVE_READY": str(self.ready),
                            "LIVE_GO": str(self.go)}
        self.log = open(folder / "log", "w+")
        self.process = subprocess.Popen([*options, "--report", str(self.report), "--", *command], env=environment,
                                        cwd=folder, stdout=self.log, stderr=self.log, start_new_session=True)

    def told(self):
        self.log.seek(0)
        return self.log.read()[-2000:]

    def image(self):
        deadline = time.monotonic() + START_SECONDS
        last, since = None, time.monotonic()
        while time.monotonic() < deadline:
            time.sleep(0.25)
            if self.process.poll() is not None:
                raise Failed(f"ended with {self.process.returncode} before its image was there\n{self.told()}")
            if self.program.frame:
                if self.ready.exists():
                    return images.grab()
                continue
            now = images.grab()
            if last is None or not np.array_equal(now, last):
                last, since = now, time.monotonic()
            elif time.monotonic() - since > self.program.rest and images.color_count(now) >= self.program.colors:
                return now
        raise Failed(f"no image within {START_SECONDS} s\n{self.told()}")

    def await_report(self):
        """Waits until the report holds a frame or a draw. Programs write it beside their work, so an image may be shown before."""
        deadline = time.monotonic() + REPORT_SECONDS
        while time.monotonic() < deadline and self.process.poll() is None:
            if self.report.exists():
                report = json.loads(self.report.read_text())
                if report["frames"] or report["draws"]["traced"] or report["draws"]["rasterised"]:
                    return
            time.sleep(0.1)

    def end(self):
        """Ends the program as its user would. Returns its report, or None."""
        if self.program.frame:
            self.go.touch()
        else:
            self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            pass
        finally:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)  # its session
            except ProcessLookupError:
                pass
            self.process.wait()
        return json.loads(self.report.read_text()) if self.report.exists() else None


def run(program, options, freeze, place):
    """Its image and report. `place` is its home: new each time, but with the same name, because programs show file names."""
    shutil.rmtree(place, ignore_errors=True)
    folder = pathlib.Path(place).resolve()
    folder.mkdir(parents=True)
    try:
        command = program.command(folder)
        started = Run(program, command, options, folder, freeze)
        try:
            image = started.image()
            started.await_report()
        finally:
            report = started.end()
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return image, report


def rate(traced, rasterised):
    return traced / (traced + rasterised) if traced + rasterised else 0.0


def check(name, program, seen, report):
    """The errors, one a line."""
    wrong = []
    if report is None:
        return [f"{name}: no report"]
    if seen["largest_off_edges"] > program.largest and seen["beyond_off_edges"] > program.beyond:
        wrong.append(f"{name}: {seen['largest_off_edges']}/255 off edges on {seen['beyond_off_edges']:.4%} of its pixels, "
                     f"at most {program.largest}/255 or {program.beyond:.4%} are allowed ({program.reason})")
    if seen["beyond"] > program.beyond_all:
        wrong.append(f"{name}: {seen['beyond']:.4%} of its pixels differ, at most {program.beyond_all:.4%} may")
    if seen["visible"] > program.visible:
        wrong.append(f"{name}: {seen['visible']:.4%} of its pixels differ by more than {images.VISIBLE}/255, at most "
                     f"{program.visible:.4%} may")
    if program.exact and seen["largest"] > 0:
        wrong.append(f"{name}: pixels differ by up to {seen['largest']}/255, none may")
    if report["culled"]["draws"] < program.culled:
        wrong.append(f"{name}: {report['culled']['draws']} of its draws are culled, at least {program.culled} should be")
    if seen["traced"] < program.traced:
        wrong.append(f"{name}: {seen['traced']:.2%} of its triangles are traced, at least {program.traced:.2%} should be")
    return wrong


def begin(parser):
    """Parses the command line, to which it adds what all scripts take, and makes the folder. Returns the arguments, the program and the folder. Ends
    with exit code 77 if the program is not installed."""
    for option in ("gluray", "freeze", "out"):
        parser.add_argument(f"--{option}", required=True)
    parser.add_argument("name", choices=[*programs.PROGRAMS, *programs.MORE])
    given = parser.parse_args()
    program = (programs.PROGRAMS | programs.MORE)[given.name]
    with tempfile.TemporaryDirectory() as folder:
        why = programs.missing(program, pathlib.Path(folder))
    if why:
        print(f"skipped: {why}")
        sys.exit(77)
    out = pathlib.Path(given.out)
    out.mkdir(parents=True, exist_ok=True)
    return given, program, out


def main():
    parser = Parser(__doc__)
    parser.add_argument("--shading", default="vertex")
    parser.add_argument("--door", default="auto")
    given, program, out = begin(parser)

    launcher = [str(pathlib.Path(given.gluray).resolve()), "--door", given.door]
    place = out / f"{given.name}.home"
    off, _ = run(program, [*launcher, "--off"], given.freeze, place)
    on, report = run(program, [*launcher, "--shading", given.shading], given.freeze, place)
    difference = images.difference_image(off, on)
    box = images.window_box(np.maximum(off, on))
    for kind, image in (("off", off), ("on", on), ("difference", difference)):
        images.write_png(out / f"{given.name}-{kind}.png", image[box])

    seen = images.compare(off, on)
    if report:
        triangles, draws = report["triangles"], report["draws"]
        seen |= {"traced": rate(triangles["traced"], triangles["rasterised"]), "triangles": triangles, "draws": draws,
                 "culled": report["culled"], "frames": report["frames"]}
    (out / f"{given.name}.json").write_text(json.dumps({"seen": seen, "report": report}, indent=2) + "\n")
    print(json.dumps(seen))
    wrong = check(given.name, program, seen, report)
    if images.color_count(off[box]) < min(16, program.colors):
        wrong.append(f"{given.name}: its image is empty")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
