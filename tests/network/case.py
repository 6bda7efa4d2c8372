"""Jobs of workers over hosts of a network, for tests."""
import os
import shutil
import sys
import unittest

import network
from jobs import Jobs, wait_for

ONE_BY_ONE = ("always", "1000000000")  # the program draws a frame only when it is asked to, and turns
WORK = ("--set", "spp=4")


class Case(Jobs):
    """`launcher`: "mpirun.openmpi" or "mpiexec.mpich"."""

    launcher = "mpirun.openmpi"
    link = ""  # path of the program
    expected = {}  # checksums of the frames of a program without workers, by their number and its options

    def setUp(self):
        super().setUp()
        if not shutil.which(self.launcher):
            self.skipTest(f"{self.launcher} is not installed")
        # The hwloc of launchers asks all X servers of the machine about GPUs, and ends where one of them does.
        self.environment["HWLOC_COMPONENTS"] = "-gl"

    def network(self, count, **more):
        net = network.Switched(count, self.folder, self.link, **more)
        self.addCleanup(net.end)
        return net

    def launch(self, net, count, *words):
        return (net.mpiexec if "mpich" in self.launcher else net.mpirun)(count, *words)

    def hosts_job(self, net, count, *options):
        """A rank on each of the first hosts: the launcher's process, and the file of messages."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*self.launch(net, count, self.worker, "--job", "test", "--threads", "1", *options), stderr=file, stdout=file)
        self.assertTrue(wait_for(lambda: "programs join with" in path.read_text() or process.poll() is not None), path.read_text())
        self.assertIsNone(process.poll(), path.read_text())
        return process, path

    def images(self, frames, *options):
        """Of a program without workers, in this process's own network."""
        if (frames, options) not in self.expected:
            process = self.spawn(self.gluray, "--engine", "always", *WORK, *options, "--", self.client, *ONE_BY_ONE)
            self.expected[frames, options] = [self.frame(process) for _ in range(frames)]
            self.end(process)
        return self.expected[frames, options]

    def drawing(self, net, host, *options):
        """A program on a host of that number, and the file of its messages."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*net.hosts[host].command(self.gluray, "--engine", "always", *WORK, *options, "--workers", "test", "--", self.client,
                                                          *ONE_BY_ONE), stderr=file)
        return process, path


def main(case, *more):
    """Runs the tests of a script: LINK GLURAY WORKER CLIENT, and as many paths as `more` names members of `case`."""
    if why := network.why_not():
        print(why)
        sys.exit(77)
    paths = list(map(os.path.abspath, sys.argv[1:5 + len(more)]))
    Case.link, Jobs.gluray, Jobs.worker, Jobs.client = paths[:4]
    for name, path in zip(more, paths[4:]):
        setattr(case, name, path)
    unittest.main(argv=sys.argv[:1] + sys.argv[5 + len(more):], verbosity=2)
