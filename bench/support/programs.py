"""Runs the measured programs and reads the line of JSON each prints."""
import contextlib
import json
import os
import pathlib
import signal
import statistics
import subprocess
import tempfile


class Failed(RuntimeError):
    """A program ended badly or printed no measurement."""


def run(command, environment, timeout):
    """Runs `command` with `environment` added to ours, in a process group of its own that ends with us: (exit code, stdout,
    stderr). Failed where it takes longer than `timeout` seconds."""
    with subprocess.Popen([str(part) for part in command], env={**os.environ, **environment}, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True) as program:
        try:
            out, err = program.communicate(timeout=timeout)
            return program.returncode, out, err
        except subprocess.TimeoutExpired as error:
            raise Failed(f"more than {timeout} s: {' '.join(map(str, command))}") from error
        finally:
            with contextlib.suppress(ProcessLookupError):  # what it started, too; also where we are interrupted
                os.killpg(program.pid, signal.SIGKILL)


def measure(command, environment, timeout=900):
    """Runs `command` with `environment` added to ours; returns its measurement as a dictionary."""
    line = " ".join(str(part) for part in command)
    code, out, err = run(command, environment, timeout)
    if code != 0:
        raise Failed(f"exit code {code}: {line}\n{err.strip()}")
    try:
        return json.loads(out.strip().splitlines()[-1])
    except (IndexError, json.JSONDecodeError) as error:
        raise Failed(f"no measurement from: {line}\n{out}{err}") from error


def measure_with_gluray(gluray, options, command, environment, engine="always", timeout=900):
    """The same under `gluray`, which traces however small the scene is; the launcher's own report is added as "report" (None where it wrote none)."""
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        report = pathlib.Path(folder) / "report.json"
        out = measure([gluray, "--engine", engine, "--report", report, *options, "--", *command], environment, timeout)
        out["report"] = json.loads(report.read_text()) if report.exists() else None
        return out


def combined(rounds):
    """One measurement from several rounds of the same program: medians of times, the largest memory."""
    out = dict(rounds[0])
    for key in ("first_image_s", "frame_s", "build_s"):
        out[key] = statistics.median(r[key] for r in rounds)
    for key in ("rss_bytes", "peak_bytes"):
        out[key] = max(r[key] for r in rounds)
    out["rounds"] = [{key: r[key] for key in ("first_image_s", "frame_s", "rss_bytes")} for r in rounds]
    return out
