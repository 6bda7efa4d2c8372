"""Runs the measured programs and reads the line of JSON each prints."""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import statistics
import subprocess
import tempfile
import threading
import time


class Failed(RuntimeError):
    """A program ended badly or printed no measurement."""


def free_bytes():
    """Memory that the system reports as available."""
    for line in pathlib.Path("/proc/meminfo").read_text().splitlines():
        if line.startswith("MemAvailable:"):
            return int(line.split()[1]) * 1024
    return float("inf")


def _communicate(program, command, timeout, least_free):
    end = time.monotonic() + timeout
    while True:
        try:
            return program.communicate(timeout=0.2 if least_free else timeout)
        except subprocess.TimeoutExpired as error:
            if time.monotonic() >= end:
                raise Failed(f"more than {timeout} s: {' '.join(map(str, command))}") from error
            if free_bytes() < least_free:
                raise Failed(f"the machine ran out of memory: {' '.join(map(str, command))}") from error


def require(*programs):
    """Raises Failed, with one line that says what to do, unless all exist."""
    for program in programs:
        if not (os.path.isfile(program) or shutil.which(str(program))):
            raise Failed(f"{program} is missing: run scripts/build release first")


@contextlib.contextmanager
def _interrupts_deferred():
    """Delays Ctrl-C until the block ends: within Popen it would leave an unknown child process."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pending = []
    before = signal.signal(signal.SIGINT, lambda *_: pending.append(True))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if pending:
        signal.raise_signal(signal.SIGINT)


def run(command, environment, timeout, least_free=0):
    """Runs `command` with `environment` added to ours, in a process group of its own that ends with us: (exit code, stdout,
    stderr). Failed where there is no such program, it takes longer than `timeout` seconds, or it leaves the machine less than
    `least_free` bytes."""
    require(command[0])
    program = None
    try:
        with _interrupts_deferred():
            program = subprocess.Popen([str(part) for part in command], env={**os.environ, **environment}, text=True,
                                       stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        out, err = _communicate(program, command, timeout, least_free)
        return program.returncode, out, err
    finally:
        if program:
            with contextlib.suppress(ProcessLookupError):  # with its children; also if we are interrupted
                os.killpg(program.pid, signal.SIGKILL)
            with program:
                pass  # its pipes are closed, and it is waited for


def measure(command, environment, timeout=900, least_free=0):
    """Runs `command` with `environment` added to ours; returns its measurement as a dictionary. Otherwise as run()."""
    line = " ".join(str(part) for part in command)
    code, out, err = run(command, environment, timeout, least_free)
    if code != 0:
        raise Failed(f"exit code {code}: {line}\n{err.strip()}")
    try:
        return json.loads(out.strip().splitlines()[-1])
    except (IndexError, json.JSONDecodeError) as error:
        raise Failed(f"no measurement from: {line}\n{out}{err}") from error


def measure_with_gluray(gluray, options, command, environment, engine="always", timeout=900, least_free=0):
    """The same under `gluray`, which traces small scenes, too; the launcher's report is added as "report" (None if there is none)."""
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        report = pathlib.Path(folder) / "report.json"
        out = measure([gluray, "--engine", engine, "--report", report, *options, "--", *command], environment, timeout, least_free)
        out["report"] = json.loads(report.read_text()) if report.exists() else None
        return out


def combined(rounds):
    """One measurement from several rounds of the same program: medians of times, the largest memory."""
    out = dict(rounds[0])
    for key in {"first_image_s", "early_frame_s", "frame_s", "build_s"} & rounds[0].keys():
        out[key] = statistics.median(r[key] for r in rounds)
    for key in ("rss_bytes", "peak_bytes"):
        out[key] = max(r[key] for r in rounds)
    out["rounds"] = [{key: r[key] for key in ("first_image_s", "frame_s", "rss_bytes")} for r in rounds]
    return out


def in_turn(ways, rounds, alternate=False):
    """Calls each of `ways`, functions by name, once a round, in their order; if `alternate`, in every second round backwards. What they return, by name."""
    found = {way: [] for way in ways}
    for number in range(rounds):
        for way in reversed(ways) if alternate and number % 2 else ways:
            found[way].append(ways[way]())
    return found
