#!/usr/bin/env python3
"""tools/package_mirrors.py on fictional package sources and proxies, and on those of this machine."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "package_mirrors.py"
LINES = """# deb http://commented.example/debian trixie main
deb cdrom:[Debian GNU/Linux 13 _Trixie_ - Official amd64]/ trixie main
deb-src http://source.example/debian trixie main
deb http://security.example/debian-security trixie-security main
deb http://other.example/debian bookworm main
deb http://programs.example/linux/debian trixie stable
deb [ arch=amd64 signed-by=/usr/share/keyrings/some.gpg ] http://first.example/debian/ trixie main contrib # ours
deb\thttp://second.example/debian  trixie   main
"""
STANZAS = """
Types: deb deb-src
# http://commented.example/debian
URIs: http://first.example/debian
# between the fields
 https://third.example/debian
Suites: trixie trixie-updates
components: main
 contrib
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg

Enabled: no
Types: deb
URIs: http://disabled.example/debian
Suites: trixie
Components: main

Types: deb-src
URIs: http://source.example/debian
Suites: trixie
Components: main
"""


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.etc = pathlib.Path(folder.name)
        (self.etc / "apt" / "sources.list.d").mkdir(parents=True)
        self.write("os-release", 'ID=debian\nVERSION_CODENAME="trixie"\n')

    def write(self, name, text):
        (self.etc / name).write_text(text)

    def run_tool(self, *arguments, **variables):
        plain = {name: value for name, value in os.environ.items() if not name.lower().endswith("_proxy")}
        return subprocess.run([sys.executable, "-B", TOOL, *arguments], env={**plain, **variables}, capture_output=True, text=True, timeout=60)


class Mirrors(Case):
    def mirrors(self):
        done = self.run_tool("--etc", str(self.etc))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_lines(self):
        self.write("apt/sources.list", LINES)
        self.assertEqual(self.mirrors(), ["http://first.example/debian", "http://second.example/debian"])

    def test_stanzas(self):
        self.write("apt/sources.list.d/debian.sources", STANZAS)
        self.assertEqual(self.mirrors(), ["http://first.example/debian", "https://third.example/debian"])

    def test_all_files_count(self):
        self.write("apt/sources.list", LINES)
        self.write("apt/sources.list.d/debian.sources", STANZAS)
        self.write("apt/sources.list.d/a.list", "deb http://fourth.example/debian trixie main\n")
        self.write("apt/sources.list.d/a.list.save", "deb http://saved.example/debian trixie main\n")
        self.assertEqual(self.mirrors(), [f"http://{name}.example/debian" for name in ("first", "second", "fourth")] + ["https://third.example/debian"])

    def test_mirrors_of_debian_come_before_other_archives(self):
        self.write("apt/sources.list", "deb http://programs.example/apt trixie main\ndeb http://first.example/debian trixie main\n")
        self.assertEqual(self.mirrors(), ["http://first.example/debian", "http://programs.example/apt"])

    def test_a_release_without_its_codename_in_the_sources(self):
        self.write("apt/sources.list", "deb http://other.example/debian bookworm main\ndeb http://first.example/debian unstable main\n")
        self.assertEqual(self.mirrors(), ["http://first.example/debian"])
        self.write("os-release", "ID=debian\n")
        self.assertEqual(self.mirrors(), ["http://first.example/debian"])

    def test_a_list_of_mirrors(self):
        self.write("mirrors.list", "# ours\nhttps://first.example/debian\tpriority:1\nhttp://second.example/debian/\nftp://third.example/debian\n")
        self.write("apt/sources.list", f"deb mirror+file://{self.etc}/mirrors.list trixie main\n")
        self.assertEqual(self.mirrors(), ["https://first.example/debian", "http://second.example/debian"])

    def test_no_mirror(self):
        self.write("apt/sources.list", "deb file:/srv/debian trixie main\ndeb http://other.example/debian bookworm main\n"
                   f"deb mirror+file:{self.etc}/no-such-file trixie main\n")
        done = self.run_tool("--etc", str(self.etc))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_the_sources_of_this_machine(self):
        release = pathlib.Path("/etc/os-release")
        if not release.exists() or "ID=debian\n" not in release.read_text():
            self.skipTest("this is no Debian")
        done = self.run_tool()
        if done.returncode:
            self.skipTest(done.stderr.strip())
        for uri in done.stdout.split():
            self.assertRegex(uri, r"^https?://[^/\s]+(/\S*)?$")


@unittest.skipUnless(shutil.which("apt-config"), "there is no apt")
class Proxies(Case):
    def proxy(self, uri, configuration="", **variables):
        alone = f'Dir::Etc::parts "{self.etc}/none"; Dir::Etc::main "{self.etc}/none";'  # nothing of this machine's
        self.write("apt.conf", f"{alone} {configuration}")
        done = self.run_tool("--proxy", uri, APT_CONFIG=str(self.etc / "apt.conf"), **variables)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.strip()

    def test_of_apt(self):
        lines = 'Acquire::http::Proxy "http://all.example:3128"; Acquire::http::Proxy::one.example "http://one.example:1";' \
                'Acquire::http::Proxy::near.example "DIRECT";'
        environment = {"http_proxy": "http://environment.example:2"}
        self.assertEqual(self.proxy("http://far.example/debian", lines, **environment), "http://all.example:3128")
        self.assertEqual(self.proxy("https://far.example/debian", lines), "http://all.example:3128")
        self.assertEqual(self.proxy("http://near.example/debian", lines, **environment), "")
        self.assertEqual(self.proxy("http://one.example/debian", lines), "http://one.example:1")
        self.assertEqual(self.proxy("https://far.example/debian", f'{lines} Acquire::https::Proxy "DIRECT";'), "")

    def test_that_a_program_finds(self):
        self.write("detect", "#!/bin/sh\necho http://found.example:8\n")
        (self.etc / "detect").chmod(0o755)
        self.etc.chmod(0o755)  # apt runs it as another user
        self.assertEqual(self.proxy("http://far.example/debian", f'Acquire::http::Proxy-Auto-Detect "{self.etc}/detect";'), "http://found.example:8")

    def test_of_the_environment(self):
        environment = {"http_proxy": "http://environment.example:2", "no_proxy": "near.example"}
        self.assertEqual(self.proxy("http://far.example/debian", **environment), "http://environment.example:2")
        self.assertEqual(self.proxy("http://near.example/debian", **environment), "")
        self.assertEqual(self.proxy("https://far.example/debian", **environment), "")


if __name__ == "__main__":
    unittest.main()
