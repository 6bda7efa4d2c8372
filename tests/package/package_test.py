"""The Debian package. package_test.py --build DIR --client PROGRAM unpacked|root

unpacked   unpacked into a folder with a space in its name and run from there
root       installed, run and removed in a root of its own, which debootstrap makes; needs a mirror and root
"""
import argparse
import gzip
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time

import clean_root
from clean_root import SKIPPED, CleanRoot, check_report, fail, gears, run


def make_package(build: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    # dpkg-deb compresses quickly: nobody keeps these packages.
    quick = {**os.environ, "DPKG_DEB_COMPRESSOR_TYPE": "gzip", "DPKG_DEB_COMPRESSOR_LEVEL": "1"}
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=build, env=quick)
    (package,) = folder.glob("gluray_*.deb")
    return package


def check_control(package: pathlib.Path) -> None:
    control = run("dpkg-deb", "--field", package).stdout
    depends = next(line for line in control.splitlines() if line.startswith("Depends:"))
    for name in ("libgl1", "libc6"):
        if name not in depends:
            fail(f"does not depend on {name}: {depends}")


def check_lintian(folder: pathlib.Path) -> None:
    """Debian's checks of packages, if they are installed: no errors."""
    if shutil.which("lintian"):
        run("lintian", "--fail-on", "error", "--no-cfg", "--allow-root", *sorted(folder.glob("*.deb")))


def check_licences(prefix: pathlib.Path) -> None:
    """Of the libraries whose copies are installed."""
    copies = {path.name.removesuffix("-gluray") for path in (prefix / "lib/gluray/private").iterdir()}
    texts = {path.stem for path in (prefix / "share/doc/gluray/licences").iterdir() if path.stat().st_size > 100}
    if not copies or copies != texts:
        fail(f"licences of {sorted(texts)} for copies of {sorted(copies)}")


OPTION = r"(?<![\w-])--?[A-Za-z][\w-]*"


def options_of(*command) -> set[str]:
    """The options that its --help lists, short ones too."""
    shown = run(*command, "--help", env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}).stdout
    return {option for line in re.findall(r"^  (-[^\s,]+(?:, ?-[^\s,]+)*)", shown, re.MULTILINE) for option in re.findall(OPTION, line)}


def commands_of(gluray: pathlib.Path) -> set[str]:
    """The commands that its --help lists."""
    return set(re.findall(r"gluray ([a-z]+(?:-[a-z]+)*)", run(gluray, "--help").stdout.split("\nCommands, ")[1]))


def check_page(page: pathlib.Path, options: set[str] | None = None) -> None:
    """A manual page without warnings; of a program with these options, it names all of them and describes no others."""
    done = run("man", "--warnings", "-l", page, env={**os.environ, "MANROFFOPT": "-ww", "LC_ALL": "C.UTF-8", "MANWIDTH": "100"})
    if done.stderr:
        fail(f"{page.name}: {done.stderr}")
    if "NAME" not in done.stdout or "SEE ALSO" not in done.stdout:
        fail(f"{page.name} is not a manual page:\n{done.stdout[:300]}")
    if options is None:
        return
    text = re.sub(r"\\f[BIPR]|\\(?=-)", "", gzip.decompress(page.read_bytes()).decode())
    if not options or (missing := options - set(re.findall(OPTION, text))):
        fail(f"{page.name} does not name {missing}")
    heads = re.findall(r"^\.TP\n(\.B.*)", text.split("\n.SH OPTIONS")[1].split("\n.SH ")[0], re.MULTILINE)
    if surplus := set(re.findall(OPTION, "\n".join(heads))) - options:
        fail(f"{page.name} describes {surplus}, which it does not take")


def check_man(prefix: pathlib.Path) -> None:
    """Of the main package."""
    pages, gluray = prefix / "share/man", prefix / "bin/gluray"
    check_page(pages / "man5/gluray.toml.5.gz")
    check_page(pages / "man7/gluray.7.gz")
    check_page(pages / "man1/gluray-worker.1.gz", options_of(prefix / "bin/gluray-worker"))
    options = {command: options_of(gluray, command) for command in sorted(commands_of(gluray))}
    check_page(pages / "man1/gluray.1.gz", options_of(gluray).union(*options.values()))
    for command in options.keys() - {"panel"}:  # whose page is in the panel's package
        check_page(pages / f"man1/gluray-{command}.1.gz", options[command])


def check_panel(packages: pathlib.Path, folder: pathlib.Path) -> None:
    """The package of the panel, if there is one."""
    for package in packages.glob("gluray-panel_*.deb"):
        run("dpkg-deb", "-x", package, folder)
        check_page(folder / "usr/share/man/man1/gluray-panel.1.gz", options_of(folder / "usr/bin/gluray-panel"))


def check_osmesa(packages: pathlib.Path, folder: pathlib.Path) -> None:
    """The package of OSMesa, if there is one: the library where the launcher looks for it, and nothing of GLuRay that it needs."""
    for package in packages.glob("gluray-osmesa_*.deb"):
        run("dpkg-deb", "-x", package, folder)
        if not (folder / "usr/lib/gluray/osmesa/libOSMesa.so.8").exists():
            fail("gluray-osmesa lacks libOSMesa.so.8")
        if "gluray" in run("dpkg-deb", "-f", package, "Depends").stdout:
            fail("gluray-osmesa depends on GLuRay")


def completions(file: pathlib.Path, *words: str) -> list[str]:
    """The completions of the last of `words`."""
    script = f"""source '{file}'; COMP_WORDS=({' '.join(f"'{w}'" for w in words)}); COMP_CWORD={len(words) - 1}
                 _gluray; printf '%s\\n' "${{COMPREPLY[@]}}\""""
    return run("bash", "--norc", "-c", script).stdout.split()


def check_completion(file: pathlib.Path, gluray: pathlib.Path) -> None:
    cases = [(("gluray", "--bv"), "--bvh"), (("gluray", "--bvh", "co"), "compact"), (("gluray", "ru"), "run"),
             (("gluray", "--threads", "4", "dpkg-de"), "dpkg-deb"), (("gluray", "run", "--of"), "--off"), (("gluray", "explain", "--ht"), "--html"),
             (("gluray", "doct"), "doctor"), (("gluray", "doctor", "--js"), "--json"), (("gluray", "timeline", "t.json", "--fr"), "--from"),
             (("gluray", "set", "ao.sam"), "ao.samples="), (("gluray", "unset", "ao.sam"), "ao.samples"), (("gluray", "watch", "--st"), "--state")]
    for words, wanted in cases:
        if wanted not in (got := completions(file, *words)):
            fail(f"'{' '.join(words)}' is completed to {got}, not to {wanted}")
    for command in ("run", "explain", "doctor", "quirks", "settings", "timeline", "environment", "uninstall", "report-bug", "list", "set", "unset", "preset", "undo", "redo", "watch", "top", "hub", "view"):
        help_text = run(gluray, command, "--help").stdout
        options = set(re.findall(r"(?:^ +|,)(--[a-z-]+)", help_text, re.MULTILINE))
        offered = completions(file, "gluray", command, "--")
        if not options or (missing := options - set(offered) - {"--help", "--version"}):
            fail(f"completion of gluray {command} does not know {missing}")
        if surplus := set(offered) - options - {"--help", "--version"}:
            fail(f"completion of gluray {command} offers {surplus}, which it does not take")


def unpacked(build: pathlib.Path, client: pathlib.Path, folder: pathlib.Path) -> None:
    package = make_package(build, folder / "cpack")
    check_control(package)
    check_lintian(package.parent)
    tree = folder / "moved away"
    run("dpkg-deb", "-x", package, tree)
    gluray = tree / "usr/bin/gluray"
    if "gluray" not in run(gluray, "--version").stdout:
        fail("--version does not name it")
    for door in ("vendor", "preload"):
        if door == "preload":  # LD_PRELOAD holds no spaces: gluray makes a link
            said = run(gluray, "--door", door, "--report", folder / "spaced.json", "--", client, "surfaceless").stderr
            if said:
                fail(f"preloading from a folder with a space in its name: {said}")
            check_report(folder / "spaced.json")
            tree = tree.rename(folder / "moved-again")
            gluray = tree / "usr/bin/gluray"
        report = folder / f"{door}.json"
        run(gluray, "--door", door, "--report", report, "--", client, "surfaceless")
        check_report(report)
    check_licences(tree / "usr")
    check_man(tree / "usr")
    check_panel(package.parent, folder / "panel")
    check_osmesa(package.parent, folder / "osmesa")
    check_completion(tree / "usr/share/bash-completion/completions/gluray", gluray)


def in_root(build: pathlib.Path, folder: pathlib.Path) -> int:
    if why := clean_root.impossible():
        print(f"package: {why}")
        return SKIPPED
    package = make_package(build, folder / "cpack")
    root = CleanRoot(folder / "root")
    try:
        root.make(clean_root.own_release())
        shutil.copy(package, root.folder / "gluray.deb")
        root.run("apt-get", "-qq", "update")
        root.run("apt-get", "-qq", "install", "--no-install-recommends", "-y", "xvfb", "mesa-utils", "libgl1-mesa-dri")
        before = set(root.run("find", "/usr", "/etc", "-xdev", "-path", "*gluray*").split())
        root.run("apt-get", "-qq", "install", "--no-install-recommends", "-y", "/gluray.deb")
        if "Runs an OpenGL program" not in root.run("gluray", "--help"):
            fail("gluray --help says something else")
        # glxgears is killed: the report may lack its last second.
        gears(root, "gluray", "--report", "/report.json")
        check_report(root.folder / "report.json")
        root.run("dpkg", "--purge", "gluray")
        left = set(root.run("find", "/usr", "/etc", "-xdev", "-path", "*gluray*").split()) - before
        if left:
            fail(f"left behind: {' '.join(sorted(left))}")
        gears(root)
        if "frames" not in (root.folder / "gears.txt").read_text() and (root.folder / "gears.txt").stat().st_size > 0:
            fail(f"after removal glxgears says: {(root.folder / 'gears.txt').read_text()[:300]}")
    finally:
        root.remove()
    return 0


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--client", type=pathlib.Path, required=True)
    parser.add_argument("what", choices=("unpacked", "root"))
    options = parser.parse_args()
    os.environ.setdefault("DISPLAY", ":none")  # needs no screen, but gluray prints a hint if DISPLAY is unset
    start = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="gluray-package-") as name:
        folder = pathlib.Path(name)
        result = unpacked(options.build, options.client, folder) if options.what == "unpacked" else in_root(options.build, folder)
    print(f"package: {options.what} in {time.monotonic() - start:.0f} s")
    return result or 0


if __name__ == "__main__":
    sys.exit(main())
