"""Time per frame that a program's own thread spends in GLuRay's library, without tracing; by sampling (Linux perf)."""
import collections
import os
import pathlib
import shutil
import subprocess
import tempfile

FREQUENCY = 5000  # samples a second
TRACING = ("gluray::render", "gluray::accel", "embree", "tbb::")  # the program's thread as one of the tracing threads


class Missing(RuntimeError):
    """perf is not installed, or not allowed."""


def _samples(gluray, options, command, environment):
    """Samples of the program's first thread in our libraries, by function."""
    if not shutil.which("perf"):
        raise Missing("perf is missing (package linux-perf)")
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        data = pathlib.Path(folder) / "perf.data"
        done = subprocess.run([str(part) for part in ["perf", "record", "-q", "-e", "cpu-clock:u", "-F", FREQUENCY, "-o", data, "--", gluray,
                                                      "--engine", "always", *options, "--", *command]],
                              env={**os.environ, **environment}, text=True, capture_output=True, timeout=900)
        if done.returncode or not data.exists():
            raise Missing(f"perf record: {done.stderr.strip().splitlines()[-1:]}")
        script = subprocess.run(["perf", "script", "-i", data, "-F", "pid,tid,ip,sym,dso"], text=True, capture_output=True, timeout=900)
    found = collections.Counter()
    for line in script.stdout.splitlines():
        ids, _, rest = line.strip().partition(" ")
        pid, _, tid = ids.partition("/")
        if pid == tid and "libgluray" in rest and not any(name in rest for name in TRACING):
            found[rest.strip().split(" ", 1)[-1].rsplit(" (", 1)[0]] += 1
    return found


def per_frame(gluray, options, command_of, frames, environment):
    """Milliseconds of each frame, and the five functions that take the most of them. command_of(n): the program that draws n
    frames; what runs of different length have in common, its start, is left out."""
    short, long = (_samples(gluray, options, command_of(n), environment) for n in (frames, 3 * frames))
    scale = 1000 / FREQUENCY / (2 * frames)
    most = {name: (long[name] - short[name]) * scale for name in long}
    top = sorted(most.items(), key=lambda item: -item[1])[:5]
    return (sum(long.values()) - sum(short.values())) * scale, {name: round(ms, 4) for name, ms in top}
