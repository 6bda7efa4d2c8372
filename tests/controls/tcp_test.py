"""Programs whose hub is on another machine, reached by TCP: tcp_test.py GLURAY CLIENT PYTHON_FOLDER, with an X server at hand."""
import os
import sys
import unittest

from fake_programs import wait_for
from parts import Parts


class Tcp(Parts):
    def setUp(self):
        super().setUp()
        self.key = self.new_key("key")
        self.hub, self.address = self.listening("127.0.0.1:0")

    def listening(self, address):
        """A hub, and the address where it listens."""
        hub = self.spawn(self.gluray, "hub", "--listen", address, "--key", self.key)
        return hub, hub.stderr.readline().split()[-1]

    def new_key(self, name):
        path = str(self.folder / name)
        self.assertEqual(self.command("hub", "--new-key", path).returncode, 0)
        return path

    def far(self, name, *options):
        """A program that shares nothing with the hub's machine but its address; and its log."""
        self.environment["GLURAY_RUNTIME"] = str(self.folder / "far")
        log = self.folder / f"{name}.log"
        path = self.folder / name
        path.symlink_to(self.client)
        with log.open("w") as file:
            process = self.spawn(self.gluray, *options, "--", str(path), "always", "10", stderr=file)
        self.environment["GLURAY_RUNTIME"] = str(self.runtime)
        self.frame(process)
        return process, log

    def test_a_program_is_changed_from_another_machine(self):
        painter, _ = self.far("painter", "--set", f"hub={self.address}", "--set", f"hub-key={self.key}")
        self.listed(1)
        self.assertEqual(self.results("set", "spp=4")["painter"]["values"], {"spp": 4})
        self.assertEqual(self.values("spp"), {"painter": 4})
        self.assertEqual(self.results("undo", "-p", "painter")["painter"]["values"], {"spp": 1})
        before = self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before + 5))
        # As a client of the hub from a machine without it.
        self.environment["GLURAY_RUNTIME"] = str(self.folder / "third")
        done = self.command("set", "--hub", self.address, "--key", self.key, "ao=on")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.environment["GLURAY_RUNTIME"] = str(self.runtime)
        self.assertEqual(self.values("ao"), {"painter": True})

    def test_without_the_key_a_program_draws_and_says_why(self):
        other = self.new_key("other")
        painter, log = self.far("painter", "--set", f"hub={self.address}", "--set", f"hub-key={other}")
        self.assertTrue(wait_for(lambda: "key" in log.read_text()), "one line")
        before = self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before + 20))
        self.assertEqual(log.read_text().count("\n"), 1, log.read_text())
        self.assertEqual(self.listed(0), {})

    def test_a_hub_that_ends_does_not_stop_programs(self):
        painter, _ = self.far("painter", "--set", f"hub={self.address}", "--set", f"hub-key={self.key}")
        self.listed(1)
        self.results("set", "ao.samples=3")
        self.kill(self.hub)
        before = self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before + 20))
        self.listening(self.address)
        self.listed(1)
        self.assertEqual(self.values("ao.samples"), {"painter": 3})


if __name__ == "__main__":
    Parts.gluray, Parts.client = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
