"""Light across the ranks of pvbatch on hosts with networks of their own, each with a worker, one of which is stopped meanwhile:
hosts_light_test.py GLURAY WORKER, with an X server at hand. Exits with 77 where there can be no such hosts, or something is missing."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import hosts
from sort_last_test import Images, check_light, compare, pixels


class HostsImages(Images):
    def __init__(self, gluray, worker, folder, network):
        super().__init__(gluray, worker, folder)
        self.network = network

    def launcher(self, ranks):
        return self.network.mpirun(ranks) if ranks > 1 else []

    def job(self):
        """A worker on each host, and the file of messages."""
        log = self.folder / "log"
        with log.open("w") as file:
            process = subprocess.Popen(self.network.mpirun(len(self.network.hosts), self.worker, "--job", "test"), env=self.environment,
                                       stderr=file, stdin=subprocess.DEVNULL)
        self.wait_for(log, "programs join with")
        return process, log


def check_stopped_worker(images):
    """The program goes on without its light and says so; when the worker goes on, the next image has all light."""
    expected = pixels(images.folder / "one.png")
    job, log = images.job()
    try:
        worker = images.network.hosts[1].running(images.worker)
        os.kill(worker, signal.SIGSTOP)
        without, said = images.draw("stopped", 2, "--workers", "test")
        os.kill(worker, signal.SIGCONT)
        again, _ = images.draw("again", 2, "--workers", "test")
    finally:
        job.terminate()
        job.wait()
    assert "the worker does not answer; this process traces" in said, said
    assert "rank 1 of the program draws nothing here" in log.read_text(), log.read_text()
    without, again = (compare(expected, pixels(found)) for found in (without, again))
    print(f"a worker is stopped: {without}, it goes on: {again}")
    assert again[0] < 0.1 and again[1] < 0.01, log.read_text()


def main(gluray, worker):
    why = hosts.why_not()
    if why or not all(map(shutil.which, ("pvbatch", "mpirun.openmpi", "convert"))):
        print(why)
        return 77
    with tempfile.TemporaryDirectory() as folder:
        network = hosts.Network(2, pathlib.Path(folder))
        try:
            images = HostsImages(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder), network)
            for name in ("paths", "occlusion"):
                check_light(images, name)
            check_stopped_worker(images)
        finally:
            network.end()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
