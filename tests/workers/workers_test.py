"""Programs whose images gluray-worker traces: workers_test.py GLURAY WORKER CLIENT, with an X server at hand. Jobs of many ranks
use the launchers that are installed."""
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from jobs import Jobs, wait_for

LIGHT = ["--set", "ao=on", "--set", "ao.samples=4", "--set", "shadows=on"]
STALL = 2.5  # seconds that an image may take when a worker is gone


class Workers(Jobs):
    def client_of(self, *options, mode=()):
        """A program that traces everything, and the file of its messages."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(self.gluray, "--engine", "always", *options, "--", self.client, *mode, stderr=file)
        return process, path

    def checksum(self, *options):
        process, path = self.client_of(*options)
        found = self.frame(process)
        self.end(process)
        return found, path.read_text()

    def check_images(self, log):
        for options in ([], LIGHT, ["--set", "spp=4"]):
            expected, _ = self.checksum(*options)
            self.assertEqual(self.checksum("--workers", "test", *options), (expected, ""), options)
        self.assertTrue(wait_for(lambda: log.read_text().count("is connected") == 3), log.read_text())

    def test_one_worker(self):
        _, log = self.job()
        self.check_images(log)

    def test_ranks_of_open_mpi(self):
        _, log = self.job(*self.openmpi())
        self.assertIn("3 ranks", log.read_text())
        self.assertIn("Open MPI", log.read_text())
        self.check_images(log)

    def test_ranks_of_mpich(self):
        _, log = self.job(*self.mpi("mpich"))
        self.assertIn("3 ranks", log.read_text())
        self.assertRegex(log.read_text(), r", MPICH \d")
        self.check_images(log)

    def test_without_a_job_the_program_traces_and_says_so(self):
        expected, _ = self.checksum(*LIGHT)
        found, said = self.checksum("--workers", "test", *LIGHT)
        self.assertEqual(found, expected)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertIn("gluray-worker --job test", said)

    def check_goes_on(self, painter):
        start, before = time.monotonic(), self.frames(painter)
        self.assertTrue(wait_for(lambda: self.frames(painter) > before + 3))
        self.assertLess(time.monotonic() - start, STALL)

    def painter(self):
        return self.client_of("--workers", "test", mode=("always", "10"))

    def test_a_job_that_is_killed_and_comes_back(self):
        job, log = self.job()
        painter, said = self.painter()
        self.check_goes_on(painter)
        self.kill(job)
        self.check_goes_on(painter)
        self.assertTrue(wait_for(lambda: said.read_text().count("\n") == 1), said.read_text())
        self.assertIn("this process traces in the meantime", said.read_text())
        _, log = self.job()
        self.assertTrue(wait_for(lambda: "is connected" in log.read_text()))
        self.check_goes_on(painter)

    def test_a_worker_that_is_stopped(self):
        job, log = self.job()
        painter, said = self.painter()
        self.check_goes_on(painter)
        job.send_signal(signal.SIGSTOP)
        self.check_goes_on(painter)
        self.assertIn("does not answer", said.read_text())
        job.send_signal(signal.SIGCONT)
        self.assertTrue(wait_for(lambda: log.read_text().count("is connected") > 1), log.read_text())
        self.check_goes_on(painter)

    def test_a_worker_that_is_stopped_and_then_killed(self):
        """One line: that it is lost."""
        job, _ = self.job()
        painter, said = self.painter()
        self.check_goes_on(painter)
        job.send_signal(signal.SIGSTOP)
        self.check_goes_on(painter)
        self.assertTrue(wait_for(lambda: "does not answer" in said.read_text()), said.read_text())
        self.kill(job)
        time.sleep(2)  # it looks for a worker each second
        self.check_goes_on(painter)
        self.assertEqual(said.read_text().count("\n"), 1, said.read_text())

    def test_a_rank_that_is_stopped(self):
        job, log = self.job(*self.openmpi())
        painter, said = self.painter()
        self.check_goes_on(painter)
        rank = self.rank_process(job.pid, 2)
        os.kill(rank, signal.SIGSTOP)
        self.check_goes_on(painter)
        self.assertTrue(wait_for(lambda: "does not answer" in log.read_text()), log.read_text())
        os.kill(rank, signal.SIGCONT)
        self.check_goes_on(painter)
        self.assertEqual(said.read_text(), "")

    def test_a_second_job_of_the_name_is_refused(self):
        self.job()
        second = self.spawn(self.worker, "--job", "test")
        self.assertEqual(second.wait(30), 1)
        self.assertIn("another gluray-worker --job test runs already", second.stderr.read())

    def test_ranks_of_two_versions_end_the_job(self):
        python = "/usr/bin/python3"  # which has the distribution's mpi4py
        if subprocess.run([python, "-c", "import mpi4py"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
            self.skipTest("python3-mpi4py is not installed")
        other = pathlib.Path(__file__).resolve().parent / "other_version.py"
        # One program for all ranks: mpirun of Open MPI 5.0.7 crashes where it is given two.
        either = f'[ $OMPI_COMM_WORLD_RANK = 3 ] && exec {python} {other} "0.0.1 (9)"; exec {self.worker} --job test'
        job = self.spawn(*self.openmpi(ranks=4), "sh", "-c", either)
        _, said = job.communicate(timeout=60)
        self.assertNotEqual(job.returncode, 0)
        self.assertIn("gluray-worker 0: rank 3 is of GLuRay 0.0.1 (9) on node7, rank 0 of GLuRay ", said)
        self.assertNotIn("programs join with", said)

    def test_wrong_options(self):
        for options, line in ((["--job", "a/b"], "names no job"), (["--mpi", "/nowhere/lib.so"], "MPI cannot be loaded"),
                              (["--mpi", "other"], "built without other")):
            process = self.spawn(self.worker, *options)
            self.assertEqual(process.wait(30), 1)
            said = process.stderr.read()
            self.assertEqual(said.count("\n"), 1, said)
            self.assertIn(line, said)


if __name__ == "__main__":
    Jobs.gluray, Jobs.worker, Jobs.client = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
