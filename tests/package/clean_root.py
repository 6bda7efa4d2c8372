"""A minimal Debian in a folder, and what the tests of packages do in it."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))
import package_mirrors  # noqa: E402

SKIPPED = 77


def fail(what: str) -> None:
    sys.exit(f"package: {what}")


def run(*command, **more) -> subprocess.CompletedProcess:
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        fail(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done


def check_report(file: pathlib.Path) -> None:
    report = json.loads(file.read_text())
    traced = report["triangles"]["traced"] if "triangles" in report else report["trianglesTraced"]
    if not traced:
        fail(f"nothing was traced: {file.read_text()[:500]}")


def mirrors() -> list[str]:
    return os.environ.get("GLURAY_MIRROR", "").split() or package_mirrors.mirrors(pathlib.Path("/etc"))


def impossible() -> str:
    """Why no such system can be made here; empty: one can."""
    if os.geteuid() != 0 or not shutil.which("debootstrap"):
        return "needs root and debootstrap"
    return "" if mirrors() else "no package source of this system names a mirror of its release"


def own_release() -> str:
    return run("sh", "-c", ". /etc/os-release; echo $VERSION_CODENAME").stdout.strip()


class CleanRoot:
    """A minimal Debian in a folder."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder
        self.mounts: list[pathlib.Path] = []

    def make(self, release: str) -> None:
        mirror = mirrors()[0]
        proxy = package_mirrors.proxy(mirror)
        run("debootstrap", "--variant=minbase", "--include=ca-certificates", release, self.folder, mirror,
            env={**os.environ, "http_proxy": proxy, "https_proxy": proxy})
        for name in ("proc", "dev"):
            target = self.folder / name
            run("mount", "--bind", f"/{name}", target)
            self.mounts.append(target)
        shutil.copy("/etc/resolv.conf", self.folder / "etc/resolv.conf")
        if proxy:
            lines = [f'Acquire::{scheme}::Proxy "{proxy}";\n' for scheme in ("http", "https")]
            (self.folder / "etc/apt/apt.conf.d/90proxy").write_text("".join(lines))

    def run(self, *command: str) -> str:
        return run("chroot", self.folder, "env", "DEBIAN_FRONTEND=noninteractive", "HOME=/root",
                   "PATH=/usr/sbin:/usr/bin:/sbin:/bin", *command).stdout

    def remove(self) -> None:
        for target in reversed(self.mounts):
            subprocess.run(["umount", target], check=False)
        if not any(os.path.ismount(m) for m in self.mounts):
            shutil.rmtree(self.folder, ignore_errors=True)


def gears(root: CleanRoot, *gluray: str) -> None:
    """glxgears on a screen of its own for three seconds."""
    root.run("sh", "-c", "Xvfb :77 -noreset -screen 0 640x480x24 >/dev/null 2>&1 & screen=$!; sleep 2; export DISPLAY=:77;"
             f"timeout 4 {' '.join(gluray)} glxgears >/gears.txt 2>&1; kill $screen; wait; grep -q frames /gears.txt || test -s /report.json || true")
