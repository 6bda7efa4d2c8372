#!/usr/bin/env python3
"""If scripts/root lacks something, it says so in one line and changes nothing."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "root"
CANNOT = 77  # exit code: such a system cannot be made here


# Lists its arguments and proxy, and fails.
DEBOOTSTRAP = 'echo "$http_proxy|$*" >>"$(dirname "$0")/calls"; echo "E: no network"; exit 1'
MIRRORS = "http://first.example/debian http://second.example/debian"


class Root(unittest.TestCase):
    def run_with(self, stand_ins, *arguments, **variables):
        """The finished process; debootstrap knows trixie and, of Ubuntu, jammy. Its calls are in self.calls."""
        with tempfile.TemporaryDirectory() as folder:
            place = pathlib.Path(folder)
            for name, text in stand_ins.items():
                (place / name).write_text(f"#!/bin/bash\n{text}\n")
                (place / name).chmod(0o755)
            (place / "scripts").mkdir()
            for name in ("sid", "gutsy"):
                (place / "scripts" / name).touch()
            for name, target in (("trixie", "sid"), ("jammy", "gutsy")):
                (place / "scripts" / name).symlink_to(target)
            (place / "none.conf").write_text(f'Dir::Etc::parts "{place}/none"; Dir::Etc::main "{place}/none";')
            environment = {**os.environ, "PATH": f"{place}:{os.environ['PATH']}", "GLURAY_ROOTS": str(place / "roots"), "GLURAY_MIRROR": MIRRORS,
                           "DEBOOTSTRAP_DIR": str(place), "APT_CONFIG": str(place / "none.conf"), **variables}
            done = subprocess.run([str(ROOT), *arguments], env=environment, capture_output=True, text=True, timeout=60)
            self.assertEqual(list(place.glob("roots/*/*")), [])
            calls = place / "calls"
            self.calls = calls.read_text().replace(folder, "FOLDER").splitlines() if calls.exists() else []
        return done

    def test_lists_out_of_date_are_taken_where_they_are_here(self):
        for word, kept in (('Acquire::Check-Valid-Until "false";', 'Acquire::Check-Valid-Until "false";\n'), ("", "")):
            with tempfile.TemporaryDirectory() as folder:
                place = pathlib.Path(folder)
                apt = place / "trixie" / "etc" / "apt"
                for made in (place / "none", apt / "apt.conf.d", place / "trixie" / "root", place / "trixie" / "usr" / "sbin"):
                    made.mkdir(parents=True)
                (apt / "sources.list").write_text("deb http://first.example/debian trixie main\n")
                (place / "apt.conf").write_text(f'Dir::Etc::parts "{place}/none"; Dir::Etc::main "{place}/none"; {word}')
                stand_ins = {"id": "echo 0", "unshare": "exit 0", "debootstrap": DEBOOTSTRAP, "git": "exit 1"}
                done = self.run_with(stand_ins, "trixie", GLURAY_ROOTS=folder, APT_CONFIG=str(place / "apt.conf"))
                self.assertEqual((done.returncode, done.stderr, self.calls), (1, "root: cloning failed\n", []))
                self.assertEqual((apt / "apt.conf.d" / "90valid-until").read_text(), kept)

    def run_as_root(self, *arguments, **variables):
        return self.run_with({"id": "echo 0", "unshare": "exit 0", "debootstrap": DEBOOTSTRAP}, *arguments, **variables)

    def test_takes_root(self):
        done = self.run_with({"id": "echo 1000"}, "trixie")
        self.assertEqual(done.returncode, CANNOT)
        self.assertEqual(done.stderr, "root: making a system in a folder takes root: run it with sudo\n")

    def test_tries_all_mirrors(self):
        done = self.run_as_root("trixie", http_proxy="http://proxy.example:3128", no_proxy="second.example")
        self.assertEqual(done.returncode, CANNOT)
        self.assertIn("debootstrap failed", done.stderr)
        self.assertIn("E: no network", done.stderr)
        self.assertEqual(self.calls, ["http://proxy.example:3128|trixie FOLDER/roots/trixie.new http://first.example/debian",
                                      "|trixie FOLDER/roots/trixie.new http://second.example/debian"])

    def test_takes_the_mirror_of_this_system(self):
        listed = subprocess.run([sys.executable, "-B", ROOT.parents[1] / "tools" / "package_mirrors.py"], capture_output=True, text=True, timeout=60)
        self.assertEqual(self.run_as_root("trixie", GLURAY_MIRROR="").returncode, CANNOT)
        self.assertEqual([re.search(r"https?://\S+", call)[0] for call in self.calls], listed.stdout.split())

    def test_the_system_gets_certificates_for_a_mirror_by_https(self):
        self.run_as_root("trixie", GLURAY_MIRROR="https://first.example/debian")
        self.assertIn("--include=ca-certificates trixie ", self.calls[0])

    def test_releases_that_debootstrap_does_not_know(self):
        for codename in ("forky", "duke"):
            self.assertEqual(self.run_as_root(codename).returncode, CANNOT)
            self.assertTrue(self.calls[0].endswith(" http://first.example/debian FOLDER/scripts/sid"), self.calls)

    def test_other_systems_are_refused(self):
        for word in ("bullseye", "jammy", "13", "../trixie", ""):
            done = self.run_as_root(word)
            self.assertEqual((done.returncode, len(done.stderr.splitlines()), self.calls), (2, 1, []), word)
            self.assertIn("use the codename of Debian 12 or a later release", done.stderr)
        self.assertEqual(self.run_as_root("trixie", "--all").returncode, 2)


if __name__ == "__main__":
    unittest.main()
