"""Runs the measured programs and reads the line of JSON each prints."""
import json
import os
import pathlib
import statistics
import subprocess
import tempfile


class Failed(RuntimeError):
    """A program ended badly or printed no measurement."""


def measure(command, environment, timeout=900):
    """Runs `command` with `environment` added to ours; returns its measurement as a dictionary."""
    line = " ".join(str(part) for part in command)
    try:
        done = subprocess.run([str(part) for part in command], env={**os.environ, **environment}, text=True,
                              capture_output=True, timeout=timeout)
    except subprocess.TimeoutExpired as error:
        raise Failed(f"more than {timeout} s: {line}") from error
    if done.returncode != 0:
        raise Failed(f"exit code {done.returncode}: {line}\n{done.stderr.strip()}")
    try:
        return json.loads(done.stdout.strip().splitlines()[-1])
    except (IndexError, json.JSONDecodeError) as error:
        raise Failed(f"no measurement from: {line}\n{done.stdout}{done.stderr}") from error


def measure_with_gluray(gluray, options, command, environment):
    """The same under `gluray`, which traces however small the scene is; the launcher's own report is added as "report" (None where it wrote none)."""
    with tempfile.TemporaryDirectory(prefix="gluray-bench-") as folder:
        report = pathlib.Path(folder) / "report.json"
        out = measure([gluray, "--engine", "always", "--report", report, *options, "--", *command], environment)
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
