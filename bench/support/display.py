"""An X display for the programs of a benchmark: the user's, or an Xvfb of our own."""
import contextlib
import os
import shutil
import subprocess


class NoDisplay(RuntimeError):
    """There is no display and none could be started."""


@contextlib.contextmanager
def display(own=False, width=1400, height=1100):
    """Yields the DISPLAY to use: the environment's, or with `own`, or if there is none, that of an Xvfb which lives as
    long as the block."""
    if os.environ.get("DISPLAY") and not own:
        yield os.environ["DISPLAY"]
        return
    if not shutil.which("Xvfb"):
        raise NoDisplay("no DISPLAY and no Xvfb; run scripts/setup")
    read_end, write_end = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-noreset", "-nolisten", "tcp", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24"],
        pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write_end)
    try:
        with os.fdopen(read_end) as numbers:
            number = numbers.readline().strip()  # Xvfb writes it once it is ready, or ends
        if not number:
            raise NoDisplay("Xvfb did not start")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()
