"""Geometry larger than the memory of each host's rank: paged_test.py LINK GLURAY WORKER CLIENT, where CLIENT is the program of tests/engine, with an X
server at hand. Exits with 77 where there can be no such network."""
from case import Case, main

TRIANGLES = 300_000  # 72 bytes each
MEMORY = "42MB"      # the geometry alone takes 22 MB
FRAMES = "4"
LIGHT = ("--set", "ao=on", "--set", "ao.samples=4")
PAGES = 10_000_000   # bytes of geometry that reach the other host at least


class OpenMpi(Case):
    def sums(self, command, *options):
        """The sum of the colours of the last frame, and what the program said."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*command, self.gluray, "--engine", "always", "--bvh", "full", *options, "--", self.client, "vbo", str(TRIANGLES), FRAMES,
                                 stderr=file)
        out, _ = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 0, path.read_text())
        return [line.split()[:2] for line in out.splitlines()], path.read_text()

    def test_pages_cross_the_network(self):
        net = self.network(2)
        net.delay(200)
        net.rate(1e9)
        _, log = self.hosts_job(net, 2, "--memory", MEMORY)
        for options in ((), LIGHT):
            expected, _ = self.sums((), *options)
            self.assertEqual(len(expected), 1)
            before = net.bytes()
            self.assertEqual(self.sums(net.hosts[0].command(), "--workers", "test", *options), (expected, ""), log.read_text())
            got = net.bytes()[0][1] - before[0][1]
            print(f"{got / 1e6:.0f} MB to the other host", flush=True)
            self.assertGreater(got, PAGES)
        self.assertEqual(log.read_text().count("larger than the memory of a rank"), 2, log.read_text())


class Mpich(OpenMpi):
    launcher = "mpiexec.mpich"


if __name__ == "__main__":
    main(OpenMpi)
