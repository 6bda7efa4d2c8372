"""A hub, a program and a client on three hosts: hub_test.py LINK GLURAY WORKER CLIENT, with an X server at hand. Exits with 77 where there can be no such
network."""
import json
import time

from case import Case, main
from jobs import wait_for

PORT = 4500
STALL = 1  # seconds that frames may wait for


class Hub(Case):
    def setUp(self):
        super().setUp()
        self.net = self.network(3)
        key, self.address = str(self.folder / "key"), f"{self.net.hosts[0].address}:{PORT}"
        self.reach = ["--hub", self.address, "--key", key]
        self.assertEqual(self.command("hub", "--new-key", key).returncode, 0)
        hub = self.spawn(*self.net.hosts[0].command(self.gluray, "hub", "--listen", self.address, "--key", key))
        self.assertIn("the hub listens", hub.stderr.readline())

    def program(self):
        """A program on the second host, which has drawn."""
        self.said = self.log()
        with self.said.open("w") as file:
            self.painter = self.spawn(*self.net.hosts[1].command(self.gluray, "--set", f"hub={self.address}", "--set", f"hub-key={self.reach[-1]}", "--",
                                                                 self.client, "always", "10"), stderr=file)
        self.frame(self.painter)

    def said_at(self, host, *words):
        process = self.spawn(*self.net.hosts[host].command(*words))
        out, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (0, ""), words)
        return out

    def listed(self):
        """Programs that the client on the third host sees."""
        process = self.spawn(*self.net.hosts[2].command(self.gluray, "list", "--json", *self.reach))
        out, _ = process.communicate(timeout=60)
        return len(json.loads(out)) if process.returncode == 0 else 0

    def check_goes_on(self, seconds):
        """The program draws all the time."""
        end, before = time.monotonic() + seconds, self.frames(self.painter)
        while time.monotonic() < end:
            time.sleep(STALL)
            now = self.frames(self.painter)
            self.assertGreater(now, before)
            before = now

    def check_set(self, value):
        before = self.net.bytes()
        self.said_at(2, self.gluray, "set", *self.reach, f"spp={value}")
        results = json.loads(self.said_at(2, self.gluray, "get", "--live", "--json", *self.reach, "spp"))
        self.assertIn(str(value), json.dumps(results))
        after = self.net.bytes()
        for one, other in ((0, 1), (1, 0), (0, 2), (2, 0)):
            self.assertGreater(after[one][other], before[one][other])

    def test_settings_cross_the_network(self):
        self.program()
        for microseconds, lost in ((200, 0), (2000, 0), (200, 0.05)):
            with self.subTest(microseconds=microseconds, lost=lost):
                self.net.delay(microseconds)
                self.net.drop(1, lost)
                self.assertTrue(wait_for(lambda: self.listed() == 1))
                self.check_set(2)
                self.check_set(4)
        self.assertEqual(self.said.read_text(), "")

    def test_the_network_is_cut_and_comes_back(self):
        self.program()
        self.assertTrue(wait_for(lambda: self.listed() == 1))
        self.net.cable(1, False)
        self.check_goes_on(8)
        self.net.cable(1, True)
        self.assertTrue(wait_for(lambda: self.listed() == 1, 60))
        self.check_set(3)
        self.check_goes_on(2)

    def test_the_hub_is_not_reached_at_first(self):
        """The program begins while the hub's cable is out."""
        self.net.cable(0, False)
        start = time.monotonic()
        self.program()
        self.assertLess(time.monotonic() - start, 10)
        self.check_goes_on(6)
        self.net.cable(0, True)
        self.assertTrue(wait_for(lambda: self.listed() == 1, 60))
        self.check_set(2)


if __name__ == "__main__":
    main(Hub)
