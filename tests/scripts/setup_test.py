#!/usr/bin/env python3
"""scripts/setup on fictional distributions: stand-ins for dpkg and apt list installed and available packages."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

SETUP = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "setup"
# Every name in `known` can be installed; `removed` are names that apt still shows, as Debian 13 does with exit
# code 0. The file `installed` lists installed packages.
STAND_INS = {
    "id": "echo 0",
    "dpkg-query": r"""for name in $(cat "$ROOT/installed"); do
  for last; do :; done
  case $last in -*) matches=1 ;; *) case $name in $last) matches=1 ;; *) matches= ;; esac ;; esac
  [ -z "$matches" ] || echo "installed $name $(case $2 in *Version*) echo 1 ;; esac)"
done | sed 's/ $//'""",
    "apt-cache": r"""case $1 in
  pkgnames) cat "$ROOT/known" "$ROOT/removed" | grep "^$2" ;;
  policy) if grep -qxF "$2" "$ROOT/known"; then echo "$2:"; echo "  Installed: (none)"; echo "  Candidate: 1.0"; sleep 0.01
            printf '%s\n' "  Version table:" "     1.0 500" "        500 http://mirror stable/main Packages" || exit 100
          elif grep -qxF "$2" "$ROOT/removed"; then echo "$2:"; echo "  Candidate: (none)"; fi ;;
  show) echo "N: anything" >&2 ;;
esac""",
    "apt-get": r"""echo "$*" >>"$ROOT/apt.log"
for word; do case $word in install) on=1 ;; -*) ;; *) [ -z "${on:-}" ] || echo "$word" >>"$ROOT/installed" ;; esac; done""",
}


def entries():
    """The packages that scripts/setup installs."""
    arrays = re.findall(r"packages\+?=\(\n(.*?)\n *\)", SETUP.read_text(), re.S)
    return [word for text in arrays[:3] for word in text.split()]


class Setup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in STAND_INS.items():
            (self.root / name).write_text(f"#!/bin/bash\n{text}\n")
            (self.root / name).chmod(0o755)
        self.plain = [name.split("/")[0] for name in entries() if "%" not in name]
        self.write("installed", ["bash"])
        self.write("removed", [])
        self.write("known", [*self.plain, "libvtk9.1", "libvtk9.1-qt"])

    def write(self, name, lines):
        (self.root / name).write_text("".join(f"{line}\n" for line in lines))

    def lines(self, name):
        file = self.root / name
        return file.read_text().splitlines() if file.exists() else []

    def run_setup(self, *options):
        environment = {**os.environ, "PATH": f"{self.root}:{os.environ['PATH']}", "ROOT": str(self.root), "HOME": str(self.root),
                       "XDG_CACHE_HOME": str(self.root / "cache")}
        return subprocess.run([str(SETUP), *options], env=environment, capture_output=True, text=True, timeout=60)

    def test_installs_everything_once(self):
        done = self.run_setup()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLessEqual({*self.plain, "libvtk9.1", "libvtk9.1-qt"}, set(self.lines("installed")))
        calls = [line for line in self.lines("apt.log") if "download" not in line]
        self.assertIn("all packages are installed", self.run_setup().stdout)
        self.assertEqual(calls, [line for line in self.lines("apt.log") if "download" not in line])

    def test_takes_the_newest_version_that_can_be_installed(self):
        self.write("known", [*self.plain, "libvtk9.1", "libvtk9.1-qt", "libvtk9.3", "libvtk9.10t64", "libvtk9.10t64-qt", "libvtk-dev"])
        self.write("removed", ["libvtk9.11"])
        self.assertEqual(self.run_setup().returncode, 0)
        chosen = {name for name in self.lines("installed") if "vtk" in name} - set(self.plain)
        self.assertEqual(chosen, {"libvtk9.10t64", "libvtk9.10t64-qt"})

    def test_does_without_programs_that_do_not_exist(self):
        self.write("known", [name for name in self.plain if name not in ("geomview", "meshlab")])
        self.write("removed", ["geomview"])
        done = self.run_setup()
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("geomview", "meshlab", "libvtk%"):
            self.assertIn(f"package {name} does not exist here", done.stdout)
        calls = len(self.lines("apt.log"))
        self.assertIn("geomview", self.run_setup().stdout)
        self.assertEqual(len(self.lines("apt.log")), calls, "the lists were read again")

    def test_names_what_it_cannot_do_without(self):
        self.write("known", [name for name in self.plain if name != "libembree-dev"])
        self.write("removed", ["libembree-dev"])
        done = self.run_setup()
        self.assertEqual(done.returncode, 1)
        self.assertIn("libembree-dev does not exist", done.stderr)

    def test_prints_what_packages_are_built_with(self):
        done = self.run_setup("--build-depends")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [line.split(" | ")[0] for line in done.stdout.splitlines()]
        self.assertLess(set(names), set(self.plain))
        self.assertIn("libembree-dev", names)
        self.assertFalse({"ccache", "git", "clang", "libgtest-dev", "build-essential", "xvfb"} & set(names))
        self.assertEqual(self.lines("apt.log"), [])


if __name__ == "__main__":
    unittest.main()
