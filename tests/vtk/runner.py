"""Draws states one after the other, inside the program that they are for.

    pvbatch runner.py FOLDER NAME ...      states for ParaView
    python3 runner.py FOLDER NAME ...      states for VTK

Writes the images of each state to FOLDER, and NAME.json: its time, the error it ended with, and, if
VTK_STATES_REPORT names a report that GLuRay is writing, the counts while the state was drawn.
"""
import ctypes
import json
import os
import pathlib
import sys
import time
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import registry  # noqa: E402
import stages  # noqa: E402

PAUSE = 0.12  # seconds: reports are at least 0.1 apart


class Counts:
    """The counts of GLuRay's report, updated by swapping the buffers of the current window."""

    def __init__(self, path):
        self.path = pathlib.Path(path) if path else None
        self.last = {}
        if self.path:
            self.glx = ctypes.CDLL("libGLX.so.0")
            for name in ("glXGetCurrentDisplay", "glXGetCurrentDrawable"):
                getattr(self.glx, name).restype = ctypes.c_void_p
            self.glx.glXSwapBuffers.argtypes = [ctypes.c_void_p, ctypes.c_void_p]

    def stamp(self):
        try:
            status = self.path.stat()
            return status.st_ino, status.st_mtime_ns
        except FileNotFoundError:
            return None

    def fresh(self):
        """Numbers by dotted name since the start of the process; None without a report or a current window."""
        if not self.path:
            return None
        display, drawable = self.glx.glXGetCurrentDisplay(), self.glx.glXGetCurrentDrawable()
        if not display or not drawable:
            return None
        time.sleep(PAUSE)  # whatever an earlier swap makes it write is there
        before, deadline = self.stamp(), time.monotonic() + 5
        self.glx.glXSwapBuffers(display, drawable)
        while self.stamp() == before:
            if time.monotonic() > deadline:
                return None
            time.sleep(0.01)
        flat = {}

        def walk(value, name):
            if isinstance(value, dict):
                for key, below in value.items():
                    walk(below, f"{name}.{key}" if name else key)
            elif isinstance(value, (int, float)) and not isinstance(value, bool):
                flat[name] = value

        walk(json.loads(self.path.read_text()), "")
        return flat

    def since_last(self):
        now = self.fresh()
        if now is None:
            return None
        seen = {name: value - self.last.get(name, 0) for name, value in now.items()}
        self.last = now
        return {name: value for name, value in seen.items() if value}


def main():
    folder = pathlib.Path(sys.argv[1])
    states = registry.load()
    counts = Counts(os.environ.get("VTK_STATES_REPORT"))
    for name in sys.argv[2:]:
        (folder / f"{name}.begun").touch()
        start, error, seen, steady = time.monotonic(), None, None, None
        try:
            stage = stages.open_stage(states[name].program, folder, name)
            stage.counts = counts
            try:
                states[name].draw(stage)
                seen, steady = counts.since_last(), stage.steady
            finally:
                stage.end()
        except Exception:
            error = traceback.format_exc()
        result = {"seconds": time.monotonic() - start, "error": error, "counts": seen, "steady": steady}
        (folder / f"{name}.json").write_text(json.dumps(result) + "\n")
    sys.stdout.flush()


main()
