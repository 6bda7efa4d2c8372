"""Geometry larger than the memory of each rank, under real MPI: paged_test.py GLURAY WORKER CLIENT, with an X server at hand."""
import os
import sys
import unittest

from jobs import Jobs, wait_for

TRIANGLES = 300000  # 72 bytes each
MEMORY = "42MB"  # the geometry alone takes 22 MB
LIGHT = ["--set", "ao=on", "--set", "ao.samples=4"]


class Paged(Jobs):
    def images(self, *options):
        """The sum of the colours of the fourth frame, and what the program said."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(self.gluray, "--engine", "always", "--bvh", "full", *options, "--", self.client, "vbo", str(TRIANGLES), "4",
                                 stderr=file)
        out, _ = process.communicate(timeout=150)
        self.assertEqual(process.returncode, 0, path.read_text())
        return [line.split()[:2] for line in out.splitlines()], path.read_text()

    def check(self, *launcher):
        _, log = self.job(*launcher, options=("--memory", MEMORY))
        for options in ([], LIGHT):
            expected, _ = self.images(*options)
            self.assertEqual(len(expected), 1)
            self.assertEqual(self.images("--workers", "test", *options), (expected, ""), log.read_text())
        said = log.read_text()
        self.assertTrue(wait_for(lambda: log.read_text().count("is connected") == 2), said)
        self.assertEqual(said.count("larger than the memory of a rank"), 2, said)
        self.assertNotIn("does not", said)

    def test_one_rank(self):
        self.check()

    def test_ranks_of_open_mpi(self):
        self.check(*self.openmpi(ranks=2))

    def test_ranks_of_mpich(self):
        self.check(*self.mpi("mpich", ranks=2))


if __name__ == "__main__":
    Jobs.gluray, Jobs.worker, Jobs.client = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
