"""What fails between hosts and on them: faults_test.py LINK GLURAY WORKER CLIENT, with an X server at hand. A network that parts, ranks that stop or are
killed, full disks: each image is that without workers, none takes long, and one line says what happened. Exits with 77 where there can be no such network."""
import os
import signal

from case import Case, main
from hosts_test import BACK, TURN, Drawing
from jobs import wait_for

HOSTS = 3
LIGHT = ("--set", "ao=on", "--set", "ao.samples=4")
SMALL = ("16m", "16m")  # /tmp and /dev/shm
STOPS = 4               # seconds that a fault lasts
ATTEMPTS = 3


class Late(AssertionError):
    """A rank was late that no test stopped: this machine has other work to do."""


def repeated(test):
    """A test that is repeated where a rank was late."""
    def attempts(self):
        for attempt in range(ATTEMPTS):
            try:
                return test(self)
            except Late as late:
                if attempt + 1 == ATTEMPTS:
                    raise
                print(f"once more: {late}", flush=True)
                self.doCleanups()
                self.setUp()
    return attempts


def missed(rank, seen_by=0):
    return f"gluray-worker {seen_by}: rank {rank} does not answer; the others trace its part until it does"


class OpenMpi(Case):
    options = ()

    def start(self, host=0, **more):
        """A job on all hosts, and a program on one of them, which has drawn."""
        self.net = self.network(HOSTS, **more)
        self.job, self.log_path = self.hosts_job(self.net, HOSTS)
        return self.join(host)

    def join(self, host=0):
        later = self.images(TURN, *self.options)
        process, said = self.drawing(self.net, host, *self.options)
        drawing = Drawing(self, process, later[-2:] + later[:-2])
        drawing.draw_for(1, "all well")
        self.check_lines()
        return drawing, said

    def check_lines(self, *expected):
        """What the job has said, but for programs that come and go: once each."""
        lines = self.log_path.read_text().splitlines()
        found = [line for line in lines if "gluray-worker" in line and not line.endswith(("is connected", "is gone")) and "programs join with" not in line]
        if set(found) != set(expected) and all("does not answer" in line for line in set(found) ^ set(expected)):
            raise Late(lines)
        self.assertEqual(sorted(found), sorted(expected), lines)

    def rank_at(self, host):
        process = self.net.hosts[host].running(self.worker)
        self.assertIsNotNone(process, f"host {host} has no rank")
        return process

    def check_lost(self, drawing, said, lost, lose, find, what, seen_by=0):
        """Images go on without the rank, one line says so, and it takes part again once it is found."""
        lose()
        drawing.draw_for(STOPS, what)
        self.check_lines(missed(lost, seen_by))
        find()
        before = self.net.bytes()[lost][seen_by]

        def takes_part():
            drawing.draw()
            return self.net.bytes()[lost][seen_by] - before > 200_000
        self.assertTrue(wait_for(takes_part, BACK))
        self.assertEqual(said.read_text(), "")

    @repeated
    def test_a_cut_cable(self):
        drawing, said = self.start()
        self.check_lost(drawing, said, 2, lambda: self.net.cable(2, False), lambda: self.net.cable(2, True), "a cable is cut")

    @repeated
    def test_a_rank_is_stopped(self):
        drawing, said = self.start()
        rank = self.rank_at(1)
        self.check_lost(drawing, said, 1, lambda: os.kill(rank, signal.SIGSTOP), lambda: os.kill(rank, signal.SIGCONT), "a rank is stopped")

    @repeated
    def test_the_program_loses_the_first_host(self):
        """It is on the second one, and reaches the third."""
        drawing, said = self.start(host=1)
        self.check_lost(drawing, said, 0, lambda: self.net.between(0, 1, False), lambda: self.net.between(0, 1, True), "the first host is lost", 1)

    @repeated
    def test_two_hosts_lose_each_other(self):
        """Both reach the first one, where the program is: nothing is lost."""
        drawing, said = self.start()
        self.net.between(1, 2, False)
        drawing.draw_for(STOPS, "two other hosts lose each other")
        self.net.between(1, 2, True)
        drawing.draw_for(1, "they find each other")
        self.check_lines()
        self.assertEqual(said.read_text(), "")

    @repeated
    def test_the_programs_rank_is_stopped(self):
        drawing, said = self.start()
        rank = self.rank_at(0)
        os.kill(rank, signal.SIGSTOP)
        drawing.draw_for(STOPS, "the program's rank is stopped")
        os.kill(rank, signal.SIGCONT)
        text = "gluray: workers = test: the worker does not answer; this process traces in the meantime\n"
        self.assertTrue(wait_for(lambda: drawing.draw() and self.log_path.read_text().count("is connected") == 2, BACK))
        drawing.draw_for(1, "it goes on")
        self.assertEqual(said.read_text(), text)

    def test_a_rank_is_killed(self):
        """MPI ends the job. The program says so once, and goes on by itself."""
        drawing, said = self.start()
        os.kill(self.rank_at(2), signal.SIGKILL)
        drawing.draw_for(STOPS, "a rank is killed")
        self.assertNotEqual(self.job.wait(60), 0)
        drawing.draw_for(2, "the job has ended")
        self.assertEqual(said.read_text().count("this process traces in the meantime"), 1, said.read_text())
        self.assertEqual(said.read_text().count("\n"), 1, said.read_text())
        drawing.process.stdin.close()
        self.assertEqual(drawing.process.wait(30), 0)

    def fill(self):
        """No byte more fits into /tmp and /dev/shm of the hosts."""
        for host in self.net.hosts:
            for folder in ("/tmp", "/dev/shm"):
                self.spawn(*host.command("dd", "if=/dev/zero", f"of={folder}/full", "bs=4k")).communicate(timeout=60)
            left = self.spawn(*host.command("stat", "-f", "-c", "%a", "/tmp", "/dev/shm")).communicate(timeout=60)[0]
            self.assertEqual(left.split(), ["0", "0"])

    @repeated
    def test_full_disks(self):
        """A job that runs needs neither, nor do programs that join it."""
        drawing, said = self.start(sizes=SMALL)
        self.fill()
        drawing.draw_for(2, "disks are full")
        self.assertEqual(said.read_text(), "")
        self.end(drawing.process)
        drawing, said = self.join()
        self.check_lines()
        self.assertEqual(said.read_text(), "")

    def test_a_job_on_full_disks(self):
        """MPI cannot start, and says so. The program goes on by itself."""
        self.net = self.network(HOSTS, sizes=SMALL)
        self.fill()
        self.log_path = self.log()
        with self.log_path.open("w") as file:
            job = self.spawn(*self.launch(self.net, HOSTS, self.worker, "--job", "test", "--threads", "1"), stderr=file, stdout=file)
        self.assertNotEqual(job.wait(60), 0)
        self.assertIn("MPI", self.log_path.read_text())
        drawing, said = self.join()
        self.assertEqual(said.read_text(), "gluray: workers = test: no gluray-worker --job test runs on this machine; this process traces in the meantime\n")


class OpenMpiLight(OpenMpi):
    """Light is filtered across the tiles of all ranks."""

    options = LIGHT


class Mpich(OpenMpi):
    launcher = "mpiexec.mpich"


if __name__ == "__main__":
    main(OpenMpi)
