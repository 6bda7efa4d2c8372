"""A job of workers over hosts with networks of their own, whose cables are pulled and slowed, and whose ranks are stopped and killed:
hosts_test.py GLURAY WORKER CLIENT, with an X server at hand. Exits with 77 where there can be no such hosts."""
import json
import os
import shutil
import signal
import sys
import time
import unittest

import hosts
from jobs import Jobs, wait_for

HOSTS = 4
TURN = 360          # frames after which the program's images repeat
LONGEST = 5         # seconds that an image may take; 1 is usual where a rank is lost, but other processes may be at work, too
BACK = 120          # seconds until a rank is there again: TCP repeats what was lost after as long as the cable was out
ONE_BY_ONE = ("always", "1000000000")  # the program draws a frame only when it is asked to, and turns
WORK = ["--set", "spp=4"]


class Drawing:
    """The frames of a program, each compared with the same of a program without workers."""

    def __init__(self, test, process, expected):
        self.test, self.process, self.expected, self.frame = test, process, expected, 1

    def draw(self):
        start = time.monotonic()
        found = self.test.frame(self.process)
        took = time.monotonic() - start
        self.frame += 1
        self.test.assertEqual(found, self.expected[self.frame % TURN], f"frame {self.frame}")
        return took

    def draw_for(self, seconds, what, until=lambda: False):
        """Says how long images took."""
        times, end = [], time.monotonic() + seconds
        while time.monotonic() < end and not until():
            times.append(self.draw())
            time.sleep(0.01)
        times.sort()
        print(f"{what}: {len(times)} images, median {1000 * times[len(times) // 2]:.1f} ms, longest {times[-1]:.2f} s", flush=True)
        self.test.assertLess(times[-1], LONGEST, what)
        return len(times)


class OpenMpi(Jobs):
    expected = []  # checksums of the frames of a program without workers, by number
    program = "mpirun.openmpi"

    def launch(self, *words):
        return self.network.mpirun(HOSTS, *words)

    def setUp(self):
        super().setUp()
        if not shutil.which(self.program):
            self.skipTest(f"{self.program} is not installed")
        self.network = hosts.Network(HOSTS, self.folder)
        self.addCleanup(self.network.end)
        if not OpenMpi.expected:
            process = self.spawn(self.gluray, "--engine", "always", *WORK, "--", self.client, *ONE_BY_ONE)
            later = [self.frame(process) for _ in range(TURN)]  # from the second on
            OpenMpi.expected = later[-2:] + later[:-2]
            self.end(process)

    def hosts_job(self, ready=True):
        """A rank on each host: the launcher's process, and the file of messages."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*self.launch(self.worker, "--job", "test", "--threads", "1"), stderr=file, stdout=file)
        if ready:
            self.assertTrue(wait_for(lambda: "programs join with" in path.read_text() or process.poll() is not None), path.read_text())
            self.assertIsNone(process.poll(), path.read_text())
        return process, path

    def drawing(self, host):
        """A program on a host of that number, and the file of its messages."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*self.network.hosts[host].command(self.gluray, "--engine", "always", *WORK, "--workers", "test", "--", self.client,
                                                                   *ONE_BY_ONE), stderr=file)
        drawing = Drawing(self, process, self.expected)
        drawing.draw()
        return drawing, path

    def answering(self):
        """Numbers of the ranks that answer."""
        done = self.run_at(0, self.gluray, "doctor", "--json", "--job", "test")
        return {rank["rank"] for rank in json.loads(done)["ranks"] if rank["answered"]}

    def run_at(self, host, *words):
        process = self.spawn(*self.network.hosts[host].command(*words))
        return process.communicate(timeout=60)[0]

    def rank_at(self, host):
        """The rank's process."""
        process = self.network.hosts[host].running(self.worker)
        self.assertIsNotNone(process, f"host {host} has no rank")
        return process

    def check_takes_part(self, drawing, log, rank, lose, find):
        """A rank that takes part in images is missed when it is lost, and back when it is found."""
        missed = f"rank {rank} does not answer"
        before = log.read_text().count(missed)
        lose()
        drawing.draw_for(4, f"rank {rank} is lost")
        self.assertGreater(log.read_text().count(missed), before, log.read_text())
        self.assertEqual(self.answering(), set(range(HOSTS)) - {rank})
        find()
        since = time.monotonic()
        self.assertTrue(wait_for(lambda: drawing.draw() and self.answering() == set(range(HOSTS)), BACK))
        print(f"rank {rank} answers {time.monotonic() - since:.1f} s after it was found again")
        drawing.draw_for(2, f"rank {rank} is back")

    def test_images_are_those_without_workers(self):
        _, log = self.hosts_job()
        self.assertEqual(self.answering(), set(range(HOSTS)))
        for host in (0, HOSTS - 1):
            drawing, said = self.drawing(host)
            drawing.draw_for(3, f"all well, program on host {host}")
            self.assertEqual(said.read_text(), "")
        self.assertEqual(log.read_text().count("is connected"), 2 + 1, log.read_text())  # programs, and the doctor

    def test_a_cable_is_pulled_and_put_in_again(self):
        _, log = self.hosts_job()
        drawing, said = self.drawing(0)
        drawing.draw_for(2, "all well")
        for _ in range(2):
            self.check_takes_part(drawing, log, 2, lambda: self.network.cable(2, False), lambda: self.network.cable(2, True))
        self.assertEqual(said.read_text(), "")

    def test_the_programs_own_cable(self):
        """Its rank, which is not rank 0, is alone, and gets new geometry meanwhile."""
        _, log = self.hosts_job()
        drawing, said = self.drawing(1)
        drawing.draw_for(1, "all well")
        self.network.cable(1, False)
        drawing.draw_for(4, "alone")
        self.end(drawing.process)
        drawing, said = self.drawing(1)
        drawing.draw_for(3, "alone with another program")
        self.network.cable(1, True)
        self.assertTrue(wait_for(lambda: self.answering() == set(range(HOSTS)), BACK))
        drawing.draw_for(2, "all are back")
        self.assertEqual(said.read_text(), "")
        self.assertEqual({rank for rank in range(HOSTS) if f"rank {rank} does not answer" in log.read_text()}, {0, 2, 3})

    def test_a_slow_cable(self):
        _, log = self.hosts_job()
        drawing, said = self.drawing(0)
        drawing.draw_for(1, "all well")
        if not self.network.slow(2, "rate", "1mbit", "burst", "16kb", "latency", "100ms"):
            self.skipTest("the kernel has no tc-tbf")
        drawing.draw_for(5, "a host gets 1 Mbit/s")
        self.network.slow(2, "rate", "64kbit", "burst", "4kb", "latency", "400ms")
        drawing.draw_for(5, "a host gets 64 kbit/s")
        self.network.slow(2)
        drawing.draw_for(2, "a whole cable again")
        self.assertEqual(said.read_text(), "")

    def test_geometry_comes_late(self):
        """A rank that is left out because it waits for geometry takes part when it has it."""
        _, log = self.hosts_job()
        if not self.network.slow(2, "rate", "32kbit", "burst", "4kb", "latency", "2s"):
            self.skipTest("the kernel has no tc-tbf")
        drawing, said = self.drawing(0)
        drawing.draw_for(2, "a host waits for geometry")
        self.assertIn("rank 2 does not answer", log.read_text())
        self.network.slow(2)
        drawing.draw_for(5, "a whole cable again")
        self.check_takes_part(drawing, log, 2, lambda: self.network.cable(2, False), lambda: self.network.cable(2, True))
        self.assertEqual(said.read_text(), "")

    def test_a_rank_is_stopped(self):
        _, log = self.hosts_job()
        drawing, said = self.drawing(0)
        process = self.rank_at(3)
        for _ in range(2):
            self.check_takes_part(drawing, log, 3, lambda: os.kill(process, signal.SIGSTOP), lambda: os.kill(process, signal.SIGCONT))
        self.assertEqual(said.read_text(), "")

    def test_a_rank_is_killed(self):
        """MPI ends the job. The program goes on by itself, says once or twice why, and uses the next job."""
        job, _ = self.hosts_job()
        drawing, said = self.drawing(0)
        drawing.draw_for(1, "all well")
        os.kill(self.rank_at(2), signal.SIGKILL)
        drawing.draw_for(4, "a rank is killed")
        self.assertNotEqual(job.wait(60), 0)
        self.assertTrue(wait_for(lambda: "this process traces in the meantime" in said.read_text()), said.read_text())
        _, log = self.hosts_job()
        self.assertTrue(wait_for(lambda: drawing.draw() and "is connected" in log.read_text()), log.read_text())
        drawing.draw_for(2, "the next job")
        self.assertLessEqual(said.read_text().count("\n"), 2, said.read_text())

    def test_a_host_has_a_job_of_the_name(self):
        """No rank waits for the one that must not listen there."""
        other = self.network.hosts[2]
        alone = self.spawn(*other.command(self.worker, "--job", "test"))
        self.assertIn("programs join with", alone.stderr.readline())
        job, log = self.hosts_job(ready=False)
        self.assertNotEqual(job.wait(60), 0)
        said = log.read_text()
        self.assertIn("gluray-worker 2: another gluray-worker --job test runs already", said)
        self.assertNotIn("programs join with", said)


class Mpich(OpenMpi):
    program = "mpiexec.mpich"

    def launch(self, *words):
        return self.network.mpiexec(HOSTS, *words)


if __name__ == "__main__":
    if why := hosts.why_not():
        print(why)
        sys.exit(77)
    Jobs.gluray, Jobs.worker, Jobs.client = map(os.path.abspath, sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
