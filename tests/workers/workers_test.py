"""Programs whose pictures gluray-worker traces: workers_test.py GLURAY WORKER CLIENT, with an X server at hand. Jobs of many ranks
use the launchers that are installed."""
import os
import pathlib
import shutil
import signal
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "controls"))
from fake_programs import wait_for  # noqa: E402
from parts import Parts  # noqa: E402

LIGHT = ["--set", "ao=on", "--set", "ao.samples=4", "--set", "shadows=on"]
STALL = 2.5  # seconds that a picture may take when a worker is gone


class Workers(Parts):
    worker = ""

    def setUp(self):
        super().setUp()
        self.logs = 0

    def log(self):
        self.logs += 1
        return self.folder / f"log{self.logs}"

    def job(self, *launcher):
        """A job of gluray-worker; its process and the file of its messages, once it listens."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*launcher, self.worker, "--job", "test", stderr=file, stdout=file)
        self.assertTrue(wait_for(lambda: "programs join with" in path.read_text() or process.poll() is not None))
        self.assertIsNone(process.poll(), path.read_text())
        return process, path

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

    def check_pictures(self, log):
        for options in ([], LIGHT, ["--set", "spp=4"]):
            expected, _ = self.checksum(*options)
            self.assertEqual(self.checksum("--workers", "test", *options), (expected, ""), options)
        self.assertTrue(wait_for(lambda: log.read_text().count("is connected") == 3), log.read_text())

    def mpi(self, name, *options):
        for path in (f"mpirun.{name}", f"mpiexec.{name}"):
            if shutil.which(path):
                return [path, "-n", "3", *options]
        self.skipTest(f"{name} is not installed")

    def openmpi(self):
        return self.mpi("openmpi", "--oversubscribe", *(["--allow-run-as-root"] if os.getuid() == 0 else []))

    def test_one_worker(self):
        _, log = self.job()
        self.check_pictures(log)

    def test_ranks_of_open_mpi(self):
        _, log = self.job(*self.openmpi())
        self.assertIn("3 ranks", log.read_text())
        self.assertIn("Open MPI", log.read_text())
        self.check_pictures(log)

    def test_ranks_of_mpich(self):
        _, log = self.job(*self.mpi("mpich"))
        self.assertIn("3 ranks", log.read_text())
        self.assertIn("MPICH", log.read_text())
        self.check_pictures(log)

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
        self.assertIn("this process traces until", said.read_text())
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

    def rank_process(self, launcher, rank):
        """Number of the process of a rank that `launcher` started."""
        for folder in pathlib.Path("/proc").iterdir():
            try:
                if int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1]) != launcher:
                    continue
                if f"OMPI_COMM_WORLD_RANK={rank}".encode() in (folder / "environ").read_bytes().split(b"\0"):
                    return int(folder.name)
            except (OSError, ValueError, IndexError):
                continue
        self.fail(f"no process of rank {rank}")

    def test_a_second_job_of_the_name_is_refused(self):
        self.job()
        second = self.spawn(self.worker, "--job", "test")
        self.assertEqual(second.wait(30), 1)
        self.assertIn("another gluray-worker --job test runs already", second.stderr.read())

    def test_wrong_options(self):
        for options, line in ((["--job", "a/b"], "names no job"), (["--mpi", "/nowhere/lib.so"], "MPI cannot be loaded"),
                              (["--mpi", "other"], "built without other")):
            process = self.spawn(self.worker, *options)
            self.assertEqual(process.wait(30), 1)
            said = process.stderr.read()
            self.assertEqual(said.count("\n"), 1, said)
            self.assertIn(line, said)


if __name__ == "__main__":
    Parts.gluray, Workers.worker, Parts.client = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
