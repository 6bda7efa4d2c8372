"""The tree that runs from any folder: scripts/package tree. tree_test.py unpacked|roots|release --client PROGRAM

unpacked   in a folder with a space in its name; all that it needs is in it
roots      in minimal systems of older and newer releases of Debian, as a user without rights
release    two runs of scripts/release make the same files
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import clean_root
from clean_root import ROOT, SKIPPED, CleanRoot, check_report, fail, run

RELEASES = ("bullseye", "trixie")
# Those of packaging/recipes, and glxgears.
PACKAGES = ("libgl1", "libegl1", "libopengl0", "libglx-mesa0", "libegl-mesa0", "libgl1-mesa-dri", "xvfb", "xauth", "mesa-utils")
NOBODY = 65534


def make_tree(folder: pathlib.Path) -> pathlib.Path:
    """The archive."""
    done = subprocess.run([ROOT / "scripts/package", "tree", folder], capture_output=True, text=True)
    if done.returncode:
        fail(f"scripts/package tree failed: {done.stderr[-2000:]}")
    return pathlib.Path(done.stdout.strip().splitlines()[-1])


def unpack(archive: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    folder.mkdir(parents=True)
    run("tar", "-xf", archive, "-C", folder)
    (tree,) = folder.iterdir()
    return tree


def unpacked(client: pathlib.Path, folder: pathlib.Path) -> int:
    tree = unpack(make_tree(folder / "archive"), folder / "moved away")
    texts = {path.name.removesuffix(".txt") for path in (tree / "share/doc/gluray/licences").iterdir() if path.stat().st_size > 100}
    copies = {path.name.removesuffix("-gluray") for path in (tree / "lib/gluray/private").glob("*-gluray")}
    if not copies or copies != texts:
        fail(f"licences of {sorted(texts)} for copies of {sorted(copies)}")
    for door in ("vendor", "preload"):
        report = folder / f"{door}.json"
        run(tree / "bin/gluray", "--engine", "always", "--door", door, "--report", report, "--", client, "surfaceless")
        check_report(report)
    if "gluray-worker" not in run(tree / "bin/gluray-worker", "--version").stdout:
        fail("the worker does not start")
    return 0


def in_roots(folder: pathlib.Path) -> int:
    if why := clean_root.impossible():
        print(f"package: {why}")
        return SKIPPED
    archive = make_tree(folder)
    for release in RELEASES:
        root = CleanRoot(folder / release)
        try:
            root.make(release)
            root.run("apt-get", "-qq", "update")
            root.run("apt-get", "-qq", "install", "--no-install-recommends", "-y", *PACKAGES)
            tree = unpack(archive, root.folder / "opt/a folder")
            inside = f"/opt/a folder/{tree.name}"
            (root.folder / "home/user").mkdir(parents=True)
            os.chown(root.folder / "home/user", NOBODY, NOBODY)
            script = ("cd; export HOME=/home/user; Xvfb :78 -noreset -screen 0 640x480x24 >/dev/null 2>&1 & screen=$!; sleep 2; export DISPLAY=:78;"
                      f"'{inside}/bin/gluray' --engine always --report /home/user/report.json timeout 5 glxgears; kill $screen; unset DISPLAY;"
                      f"'{inside}/bin/gluray-worker' --version; '{inside}/bin/gluray' doctor")
            said = subprocess.run(["chroot", "--userspec", f"{NOBODY}:{NOBODY}", root.folder, "env", "HOME=/home/user",
                                   "PATH=/usr/bin:/bin", "sh", "-c", script], capture_output=True, text=True)
            check_report(root.folder / "home/user/report.json")
            if "gluray-worker" not in said.stdout or "test image    ok       traced" not in said.stdout:
                fail(f"{release}: {said.stdout}{said.stderr}")
            print(f"package: {release}: traced")
        finally:
            root.remove()
    return 0


def release(folder: pathlib.Path) -> int:
    sums = []
    for name in ("once", "twice"):
        done = subprocess.run([ROOT / "scripts/release", "--draft", "--no-wheel", folder / name], capture_output=True, text=True)
        if done.returncode:
            fail(f"scripts/release failed: {done.stderr[-2000:]}")
        run("sha256sum", "--check", "--strict", "SHA256SUMS", cwd=folder / name)
        sums.append(dict(reversed(line.split()) for line in (folder / name / "SHA256SUMS").read_text().splitlines()))
    if changed := [name for name in sums[0] if sums[0][name] != sums[1].get(name)]:
        fail(f"two runs make different {', '.join(changed)}")
    for part in (".deb", "-linux-", ".spdx.json", ".tar.xz"):
        if not any(part in name for name in sums[0]):
            fail(f"no {part} in {sorted(sums[0])}")
    (bill,) = (folder / "once").glob("*.spdx.json")
    if not any(package["name"].startswith("libembree") for package in json.loads(bill.read_text())["packages"]):
        fail("the bill of materials lacks Embree")
    return 0


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=("unpacked", "roots", "release"))
    parser.add_argument("--client", type=pathlib.Path, required=True)
    options = parser.parse_args()
    os.environ.setdefault("DISPLAY", ":none")  # needs no screen, but gluray prints a hint if DISPLAY is unset
    if not shutil.which("ccache"):
        print("package: builds without ccache, which takes long")
    with tempfile.TemporaryDirectory(prefix="gluray-package-") as name:
        folder = pathlib.Path(name)
        if options.what == "release":
            return release(folder)
        return unpacked(options.client, folder) if options.what == "unpacked" else in_roots(folder)


if __name__ == "__main__":
    sys.exit(main())
