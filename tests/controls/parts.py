"""The real parts for tests: programs under `gluray`, hubs, and commands, in a runtime directory of the test's own."""
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest

from fake_programs import Peer, wait_for

COMMAND_SECONDS = 60


def plain_environment():
    """Without settings, but with the engine that tests choose."""
    return {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_") or k == "GLURAY_ENGINE"}


class Parts(unittest.TestCase):
    gluray = client = ""  # paths of the programs

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.runtime = self.folder / "run"
        self.environment = plain_environment() | {"XDG_CONFIG_HOME": "/nowhere", "GLURAY_RUNTIME": str(self.runtime), "GLURAY": self.gluray}

    def spawn(self, *words, **more):
        """A process that ends with the test, even where it is stopped."""
        process = subprocess.Popen(words, cwd=self.folder, env=self.environment, text=True, stdin=subprocess.PIPE,
                                   **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more})
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout, process.stderr):
            if pipe:
                pipe.close()

    def program(self, name, *mode):
        """A program of that name, which has drawn."""
        path = self.folder / name
        path.symlink_to(self.client)
        process = self.spawn(self.gluray, "--", str(path), *mode, stderr=subprocess.DEVNULL)
        self.frame(process)
        return process

    def two(self):
        """One that draws all the time, one that draws when its window is exposed."""
        return self.program("painter", "always", "10"), self.program("sleeper", "exposed")

    @staticmethod
    def frame(process):
        print("frame", file=process.stdin, flush=True)
        return process.stdout.readline().strip()

    @staticmethod
    def frames(process):
        """How many frames a program that draws all the time has drawn."""
        print("count", file=process.stdin, flush=True)
        return int(process.stdout.readline().split()[0])

    def hub(self):
        """A hub that listens."""
        process = self.spawn(self.gluray, "hub", stdout=subprocess.DEVNULL)
        self.assertIn("the hub listens", process.stderr.readline())
        return process

    def kill(self, process):
        process.send_signal(signal.SIGKILL)
        process.wait()

    def listed(self, count):
        """Waits until the hub knows so many programs, with all their ranks; they are returned by name."""
        def known():
            peer = Peer(self.runtime)
            try:
                return peer.ask("list")["programs"]
            finally:
                peer.close()
        wait_for(lambda: len(found := known()) == count and all(one["connected"] == one["ranks"] for one in found))
        programs = known()
        self.assertEqual(len(programs), count, programs)
        return {program["name"]: program for program in programs}

    def command(self, *words):
        return subprocess.run([self.gluray, *words], capture_output=True, text=True, cwd=self.folder, env=self.environment, timeout=COMMAND_SECONDS)

    def results(self, *words):
        """What a command prints with --json, by the program's name."""
        done = self.command(*words, "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return {one["name"]: one for one in json.loads(done.stdout)}

    def refusal(self, *words):
        """The one line with which a command fails."""
        done = self.command(*words)
        self.assertEqual((done.returncode, done.stdout, done.stderr[:8], done.stderr.count("\n")), (1, "", "gluray: ", 1), done)
        return done.stderr[8:-1]

    def values(self, name):
        """A setting in each program, by the program's name; through the hub that runs."""
        peer = Peer(self.runtime)
        try:
            names = {p["program"]: p["name"] for p in peer.ask("list")["programs"]}
            results = peer.ask("get", program="all", names=[name])["results"]
            return {names.get(result["program"]): result["values"][name]["value"] for result in results if "values" in result}
        finally:
            peer.close()
