"""Debian's packages in a system of their own, which debootstrap makes: installed, used, upgraded and removed in several orders.

    installed_test.py --build DIR [--release CODENAME]

After each removal the system is as it was before the installation: files, alternatives, diversions, scripts of dpkg. dpkg finds no package
that is broken. Needs root, debootstrap and a mirror; takes packages from there.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import clean_root
from clean_root import SKIPPED, CleanRoot, check_report, fail, gears, run
from package_test import check_lintian, make_package
from root_state import differences, state

HELPERS = ("xvfb", "mesa-utils", "libgl1-mesa-dri")
OLDER = "0.0.1-1"
ONLY_IN_OLDER = "usr/lib/gluray/private/libolder.so.1-gluray"
MAIN, OSMESA = "gluray", "gluray-osmesa"


class Packages:
    """Those of a folder, and the same with a lower version and a file that is gone in the newer one."""

    def __init__(self, folder: pathlib.Path, root: CleanRoot):
        self.root = root
        self.inside = {"newer": [], "older": []}
        self.names = []
        for package in sorted(folder.glob("*.deb")):
            self.names.append(run("dpkg-deb", "--field", package, "Package").stdout.strip())
            for version, file in (("newer", package), ("older", self.repacked(package, folder / "older"))):
                target = root.folder / "packages" / version / file.name
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, target)
                self.inside[version].append(f"/{target.relative_to(root.folder)}")

    @staticmethod
    def repacked(package: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
        tree = folder / package.stem
        folder.mkdir(exist_ok=True)
        run("dpkg-deb", "--raw-extract", package, tree)
        control = tree / "DEBIAN/control"
        version = re.search(r"^Version: (.*)$", control.read_text(), re.MULTILINE)[1]
        control.write_text(control.read_text().replace(version, OLDER))
        if (tree / ONLY_IN_OLDER).parent.is_dir():
            (tree / ONLY_IN_OLDER).write_bytes(b"older")
        run("dpkg-deb", "--root-owner-group", "-Znone", "--build", tree, made := folder / f"{package.name.split('_')[0]}.deb")
        return made

    def apt(self, *words: str) -> str:
        return self.root.run("apt-get", "-qq", "--no-install-recommends", "-y", *words)

    def install(self, version: str = "newer", *words: str) -> None:
        self.apt("install", *words, *self.inside[version])
        self.check_sound(installed=self.names)

    def install_what_they_need(self) -> None:
        """All that apt would install with them."""
        planned = self.root.run("apt-get", "--no-install-recommends", "-s", "install", *self.inside["newer"])
        others = set(re.findall(r"^Inst (\S+)", planned, re.MULTILINE)) - set(self.names)
        if others:
            self.apt("install", *sorted(others))

    def check_sound(self, installed: list[str]) -> None:
        """No package is broken, these are installed, and all their files are as packed."""
        if said := self.root.run("dpkg", "--audit"):
            fail(f"dpkg --audit: {said}")
        self.root.run("apt-get", "-qq", "check")
        said = self.root.run("dpkg-query", "--show", "--showformat", "${db:Status-Status} ${Package}\\n")
        there = {line.removeprefix("installed ") for line in said.splitlines() if line.startswith("installed ") and MAIN in line}
        if there != set(installed):
            fail(f"installed are {sorted(there)}, not {sorted(installed)}")
        for name in installed:
            if said := self.root.run("dpkg", "--verify", name):
                fail(f"files of {name} are changed: {said}")


def use(root: CleanRoot) -> None:
    """All that the packages bring runs, as root, who may write where it is installed."""
    if "gluray" not in root.run("gluray", "--version") or "gluray-worker" not in root.run("gluray-worker", "--version"):
        fail("--version does not name the program")
    said = subprocess.run(["chroot", root.folder, "env", "HOME=/tmp", "PATH=/usr/bin:/bin", "gluray", "doctor"], capture_output=True, text=True)
    if "Debian's package" not in said.stdout or "test image" not in said.stdout:
        fail(f"gluray doctor says {said.stdout}{said.stderr}")
    (root.folder / "report.json").unlink(missing_ok=True)
    gears(root, "gluray", "--engine", "always", "--report", "/report.json")
    check_report(root.folder / "report.json")
    for file in ("report.json", "gears.txt"):
        (root.folder / file).unlink()
    # Python keeps what it compiles beside the module, unless it is told not to.
    root.run("env", "--unset=PYTHONDONTWRITEBYTECODE", "python3", "-c", "import gluray, ctypes; ctypes.CDLL('/usr/lib/gluray/osmesa/libOSMesa.so.8')")
    if not list((root.folder / "usr/lib/python3/dist-packages/gluray").rglob("*.pyc")):
        fail("Python compiles nothing")
    if "--help" not in root.run("env", "QT_QPA_PLATFORM=offscreen", "gluray-panel", "--help"):
        fail("gluray-panel --help says something else")
    for name in ("openmpi", "mpich"):
        if "not found" in (said := root.run("ldd", f"/usr/lib/gluray/libgluray-mpi-{name}.so")):
            fail(f"gluray-{name} lacks libraries: {said}")


def check_gone(packages: Packages, before: dict[str, str], how: str) -> None:
    packages.check_sound(installed=[])
    if left := differences(before, state(packages.root)):
        fail(f"{how}: {len(left)} differences remain:\n" + "\n".join(left[:20]))
    print(f"package: {how}: nothing remains", flush=True)


def refuses_to_break(packages: Packages) -> None:
    """dpkg does not remove what others need, and says so."""
    done = subprocess.run(["chroot", packages.root.folder, "env", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "dpkg", "--remove", MAIN], capture_output=True, text=True)
    if done.returncode == 0 or "dependency problems" not in done.stderr:
        fail(f"dpkg removed {MAIN}, which others need: {done.stdout}{done.stderr}")
    packages.check_sound(installed=packages.names)


def one_by_one(packages: Packages, order: list[str], *, removed_first: bool) -> None:
    left = set(packages.names)
    for name in order:
        if removed_first:
            packages.root.run("dpkg", "--remove", name)
        packages.root.run("dpkg", "--purge", name)
        packages.check_sound(installed=sorted(left := left - {name}))


def removals(packages: Packages, before: dict[str, str]) -> None:
    others = [name for name in packages.names if name != MAIN]
    packages.install()
    use(packages.root)
    refuses_to_break(packages)
    one_by_one(packages, [*others, MAIN], removed_first=True)
    check_gone(packages, before, "removed and purged one by one")
    packages.install()
    one_by_one(packages, [*reversed([name for name in others if name != OSMESA]), MAIN, OSMESA], removed_first=False)
    check_gone(packages, before, "purged in another order")
    packages.install()
    use(packages.root)
    packages.apt("purge", MAIN)
    packages.check_sound(installed=[OSMESA])
    packages.apt("purge", OSMESA)
    check_gone(packages, before, "purged with all that need it")


def upgrades(packages: Packages, before: dict[str, str]) -> None:
    packages.install("older")
    use(packages.root)
    if not (packages.root.folder / ONLY_IN_OLDER).exists():
        fail("the older package lacks the file that the newer one does not have")
    packages.install()
    if (packages.root.folder / ONLY_IN_OLDER).exists():
        fail("a file of the older version remains after an upgrade")
    use(packages.root)
    upgraded = state(packages.root)
    packages.install("newer", "--reinstall")
    if changed := differences(upgraded, state(packages.root)):
        fail("a second installation changes:\n" + "\n".join(changed[:20]))
    packages.install("older", "--allow-downgrades")
    packages.install()
    packages.apt("purge", *packages.names)
    check_gone(packages, before, "upgraded, installed again, downgraded, upgraded and purged")


def check(packages_folder: pathlib.Path, root: CleanRoot) -> None:
    """In a root whose package lists are there."""
    os.environ.update(MESA_SHADER_CACHE_DISABLE="true", XDG_CACHE_HOME="/tmp")  # Mesa's shaders in the home folder are none of ours
    packages = Packages(packages_folder, root)
    packages.apt("install", *HELPERS)
    packages.install_what_they_need()
    before = state(root)
    removals(packages, before)
    upgrades(packages, before)
    gears(root)
    if "frames" not in (text := (root.folder / "gears.txt").read_text()) and text:
        fail(f"after removal glxgears says: {text[:300]}")


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--release", default=clean_root.own_release())
    options = parser.parse_args()
    if why := clean_root.impossible():
        print(f"package: {why}")
        return SKIPPED
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="gluray-installed-") as name:
        folder = pathlib.Path(name)
        package = make_package(options.build, folder / "cpack")
        check_lintian(package.parent)
        root = CleanRoot(folder / "root")
        try:
            root.make(options.release)
            root.run("apt-get", "-qq", "update")
            check(package.parent, root)
        finally:
            root.remove()
    print(f"package: installed in {time.monotonic() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
