"""Jobs of workers over hosts, and programs on some of them: job_test.py LINK GLURAY WORKER CLIENT, with an X server at hand. Exits with 77 where
there can be no such network."""
import time

from case import Case, main
from jobs import wait_for

FRAMES = 40
LIGHT = ("--set", "ao=on", "--set", "ao.samples=4")
LEAST = 5_000  # bytes of a frame that cross cables: 160 x 120 pixels with colours and depths in tiles, of which each rank traces some


class OpenMpi(Case):
    def check_images(self, net, host, *options):
        """Images of a program on a host are those without workers, and parts of them came from other hosts."""
        expected = self.images(FRAMES, *options)
        process, said = self.drawing(net, host, *options)
        found, before, start = [self.frame(process)], net.bytes(), time.monotonic()
        found += [self.frame(process) for _ in expected[1:]]
        took, crossed = time.monotonic() - start, net.crossed(before)
        self.assertEqual(found, expected)
        self.end(process)
        self.assertEqual(said.read_text(), "")
        self.assertGreater(crossed / (FRAMES - 1), LEAST)
        print(f"program on host {host}: {1000 * took / (FRAMES - 1):.1f} ms and {crossed / (FRAMES - 1):.0f} bytes a frame", flush=True)

    def check_job(self, count, setting=lambda net: None, options=()):
        """A program on the first host, which has rank 0, and then one on the last."""
        net = self.network(count)
        setting(net)
        _, log = self.hosts_job(net, count)
        for host in (0, count - 1):
            self.check_images(net, host, *options)
        self.assertTrue(wait_for(lambda: log.read_text().count("is connected") == 2), log.read_text())

    def test_two_hosts(self):
        self.check_job(2)

    def test_three_hosts_with_occlusion(self):
        self.check_job(3, options=LIGHT)

    def test_a_host_without_a_rank(self):
        """Programs there trace by themselves and say so: they reach workers of their own host alone."""
        net = self.network(3)
        self.hosts_job(net, 2)
        process, said = self.drawing(net, 2)
        self.assertEqual([self.frame(process) for _ in range(FRAMES)], self.images(FRAMES))
        self.assertEqual(said.read_text(), "gluray: workers = test: no gluray-worker --job test runs on this machine; this process traces in the meantime\n")

    def test_delays(self):
        for microseconds in (20, 200, 2000):
            with self.subTest(microseconds=microseconds):
                self.check_job(2, lambda net: net.delay(microseconds))

    def test_rates(self):
        for megabits in (100, 1000, 10000):
            with self.subTest(megabits=megabits):
                self.check_job(2, lambda net: net.rate(1e6 * megabits))

    def test_lost_frames(self):
        """TCP repeats them."""
        self.check_job(2, lambda net: net.drop(1, 0.01))


class Mpich(OpenMpi):
    launcher = "mpiexec.mpich"


if __name__ == "__main__":
    main(OpenMpi)
