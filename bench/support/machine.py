"""The context of a result: machine, versions and date."""
import datetime
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess


def _output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=20).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return ""


def field(path, name):
    match = re.search(rf"^{name}\s*:\s*(.+)$", pathlib.Path(path).read_text(), re.MULTILINE)
    return match.group(1) if match else "unknown"


def package_version(*names):
    """Version of the first of these Debian packages that is installed."""
    for name in names:
        version = _output("dpkg-query", "-W", "-f=${Version}", name)
        if version:
            return f"{name} {version}"
    return "unknown"


def describe(root):
    """A dictionary for the head of a result file; `root` is the source tree."""
    git = ["git", "-c", "safe.directory=*", "-C", str(root)]
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "machine": {
            "cpu": field("/proc/cpuinfo", "model name"),
            "cores": len(os.sched_getaffinity(0)),
            "memory": field("/proc/meminfo", "MemTotal"),
            "load_before": os.getloadavg()[0],
            "system": platform.platform(),
        },
        "versions": {
            "source": _output(*git, "rev-parse", "--short", "HEAD") or "unknown",
            "source_modified": bool(_output(*git, "status", "--porcelain", "--untracked-files=no")),
            "embree": package_version("libembree4-4", "libembree3-3"),
            "mesa": package_version("libgl1-mesa-dri"),
            "compiler": _output(shutil.which("c++") or "c++", "--version").split("\n")[0],
        },
    }


def write(root, name, result):
    """Writes a suite's result, with the load after it, to bench/results/NAME.json, and says so."""
    result["machine"]["load_after"] = os.getloadavg()[0]
    out = root / "bench" / "results" / f"{name}.json"
    out.parent.mkdir(exist_ok=True)
    out.write_text(json.dumps(result, indent=1) + "\n")
    print(f"written: {out.relative_to(root)}")
