"""Debian's source package: scripts/package source-deb. source_deb_test.py --build DIR [--release CODENAME] [--built FOLDER]

In a new system with the packages of Build-Depends and nothing else, without a network, dpkg-buildpackage makes the packages that CPack makes
of the build DIR: the same names, files, rights and fields. --built compares packages that are already built.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import clean_root
from clean_root import ROOT, SKIPPED, CleanRoot, fail, run
from package_test import check_lintian, make_package

FIELDS = ("Package", "Version", "Architecture", "Section", "Recommends", "Suggests", "Description")


def listed(package: pathlib.Path) -> set[tuple[str, str]]:
    """Rights and name of all that is in the package."""
    lines = [line.split(None, 5) for line in run("dpkg-deb", "--contents", package).stdout.splitlines()]
    return {(words[0], words[5].rstrip("/")) for words in lines if words[5] != "./"}


def depends(package: pathlib.Path) -> set[str]:
    """Names of the packages that it needs. Versions depend on what dpkg-shlibdeps knows of libraries that lie beside it."""
    return {re.split(r"[\s:(]", one.strip())[0] for one in run("dpkg-deb", "--field", package, "Depends").stdout.split(",")}


def scripts(package: pathlib.Path) -> set[str]:
    """Those that dpkg runs."""
    return set(re.findall(r"\b(?:pre|post)(?:inst|rm)\b", run("dpkg-deb", "--info", package).stdout))


def check_same(packed: pathlib.Path, built: pathlib.Path) -> None:
    """The packages of two folders."""
    names = {path.name for path in packed.glob("*.deb")}
    if names != (others := {path.name for path in built.glob("*.deb")}):
        fail(f"CPack makes {sorted(names)}, the source package {sorted(others)}")
    for name in sorted(names):
        one, other = packed / name, built / name
        if listed(one) != listed(other):
            fail(f"{name} has other files: only CPack's {sorted(listed(one) - listed(other))}, only the source package's {sorted(listed(other) - listed(one))}")
        for field in FIELDS:
            texts = [run("dpkg-deb", "--field", package, field).stdout for package in (one, other)]
            if texts[0] != texts[1]:
                fail(f"{name} has another {field}: {texts}")
        if depends(one) != depends(other):
            fail(f"{name} needs {sorted(depends(one))} or {sorted(depends(other))}")
        if scripts(one) != scripts(other):
            fail(f"{name} has scripts {scripts(one)} or {scripts(other)}")
    check_lintian(built)
    print(f"package: {len(names)} packages with the same files and fields")


def build(root: CleanRoot, folder: pathlib.Path) -> pathlib.Path:
    """The folder of the packages that are built in the root."""
    inside = root.folder / "build"
    inside.mkdir()
    for name in run(ROOT / "scripts/package", "source-deb", folder).stdout.split():
        shutil.copy(name, inside)
    if shutil.which("lintian"):
        run("lintian", "--fail-on", "error", "--no-cfg", "--allow-root", *inside.glob("*.dsc"))
    root.run("apt-get", "-qq", "install", "--no-install-recommends", "-y", "dpkg-dev")
    root.run("sh", "-c", "cd /build && dpkg-source --extract *.dsc source && cd source && apt-get -qq build-dep --no-install-recommends -y ./")
    done = subprocess.run(["unshare", "--net", "chroot", root.folder, "env", "-i", "HOME=/root", "LANG=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
                           "sh", "-c", "cd /build/source && dpkg-buildpackage -us -uc -b"], capture_output=True, text=True, errors="replace")
    if done.returncode:
        fail(f"dpkg-buildpackage ended with {done.returncode}: {done.stdout[-3000:]}{done.stderr[-3000:]}")
    return inside


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--release", default=clean_root.own_release())
    parser.add_argument("--built", type=pathlib.Path)
    options = parser.parse_args()
    if not options.built and (why := clean_root.impossible()):
        print(f"package: {why}")
        return SKIPPED
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="gluray-source-") as name:
        folder = pathlib.Path(name)
        packed = make_package(options.build, folder / "cpack").parent
        if options.built:
            check_same(packed, options.built)
            return 0
        root = CleanRoot(folder / "root")
        try:
            root.make(options.release)
            root.run("apt-get", "-qq", "update")
            check_same(packed, build(root, folder / "source"))
        finally:
            root.remove()
    print(f"package: source package in {time.monotonic() - start:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
