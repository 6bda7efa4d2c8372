"""gluray doctor --job on jobs of gluray-worker: job_doctor_test.py GLURAY WORKER. Jobs of many ranks use Open MPI, where it is
installed."""
import json
import os
import signal
import socket
import sys
import unittest

from jobs import Jobs


class JobDoctor(Jobs):
    def doctor(self, *options):
        """Exit code, findings and ranks."""
        done = self.command("doctor", "--json", "--job", "test", *options)
        self.assertEqual(done.stderr, "")
        answer = json.loads(done.stdout)
        self.assertEqual(answer["exitCode"], done.returncode)
        return done.returncode, answer["findings"], answer["ranks"]

    def check_rank(self, rank):
        self.assertTrue(rank["answered"])
        self.assertEqual((rank["host"], rank["byteOrder"]), (socket.gethostname(), sys.byteorder))
        self.assertGreaterEqual(rank["threads"], 1)
        self.assertGreaterEqual(rank["hostCores"], rank["usableCores"])
        self.assertGreater(rank["memoryBytes"], rank["availableBytes"])

    def test_one_worker(self):
        process, log = self.job()
        _, findings, [rank] = self.doctor()
        self.check_rank(rank)
        self.assertEqual((rank["mpi"], rank["usableCores"]), ("no MPI", len(os.sched_getaffinity(process.pid))))
        self.assertIn("1 rank on 1 host", findings[0]["text"])
        self.assertNotIn("threads", [finding["topic"] for finding in findings], findings)
        self.assertNotIn("malformed", log.read_text())

    def test_text(self):
        self.job()
        done = self.command("doctor", "--job", "test")
        self.assertEqual(done.stderr, "")
        self.assertRegex(done.stdout, r'(?s)^job +ok +"test" answers: 1 rank .*\nrank 0 +ok .*(all is well|with limitations)\n$')

    def test_one_core_of_many(self):
        if len(os.sched_getaffinity(0)) < 2:
            self.skipTest("the machine has one core")
        core = min(os.sched_getaffinity(0))
        self.job("taskset", "-c", str(core))
        code, findings, [rank] = self.doctor()
        self.assertEqual((code, rank["usableCores"], rank["cores"]), (1, 1, str(core)))
        [bound] = [finding for finding in findings if finding["topic"] == "binding"]
        self.assertIn("--bind-to none", bound["fix"])

    def test_ranks_of_open_mpi(self):
        self.job(*self.openmpi(), "--bind-to", "none")
        _, findings, ranks = self.doctor()
        self.assertEqual([(rank["rank"], rank["rankOnHost"], rank["ranksOnHost"]) for rank in ranks], [(i, i, 3) for i in range(3)])
        for rank in ranks:
            self.check_rank(rank)
        self.assertIn("3 ranks on 1 host", findings[0]["text"])
        self.assertIn("Open MPI", findings[0]["text"])

    def test_a_rank_that_is_stopped_is_named(self):
        job, _ = self.job(*self.openmpi(), "--bind-to", "none")
        rank = self.rank_process(job.pid, 2)
        os.kill(rank, signal.SIGSTOP)
        code, findings, ranks = self.doctor()
        self.assertEqual((code, [rank["answered"] for rank in ranks]), (1, [True, True, False]))
        [silent] = [finding for finding in findings if finding["topic"] == "answers"]
        self.assertIn("rank 2 has not answered", silent["text"])
        os.kill(rank, signal.SIGCONT)
        self.assertTrue(all(rank["answered"] for rank in self.doctor()[2]))

    def test_a_worker_that_is_stopped(self):
        job, _ = self.job()
        job.send_signal(signal.SIGSTOP)
        code, [finding], ranks = self.doctor()
        self.assertEqual((code, ranks), (2, []))
        self.assertIn("does not answer", finding["text"])
        self.assertIn("stopped", finding["fix"])

    def test_no_job(self):
        code, [finding], ranks = self.doctor()
        self.assertEqual((code, finding["text"], ranks), (2, "no gluray-worker --job test runs on this machine", []))
        self.assertIn("gluray-worker --job test", finding["fix"])
        done = self.command("doctor", "--job")
        self.assertEqual((done.returncode, done.stderr), (2, ""))
        self.assertIn("no gluray-worker --job job runs", done.stdout)

    def test_wrong_directory(self):
        self.runtime.mkdir(mode=0o755)
        code, [finding], _ = self.doctor()
        self.assertEqual(code, 2)
        self.assertIn("run chmod 700", finding["text"])

    def test_wrong_options(self):
        for options, line in ((["--job", "a/b"], "names no job"), (["--job=a b"], "names no job"),
                              (["--job", "test", "glxgears"], "a program or a job"), (["--job", "test", "--", "glxgears"], "a program or a job")):
            done = self.command("doctor", *options)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done)
            self.assertIn(line, done.stderr)


if __name__ == "__main__":
    Jobs.gluray, Jobs.worker = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
