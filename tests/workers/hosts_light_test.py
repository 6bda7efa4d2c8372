"""Light across the ranks of pvbatch on hosts with networks of their own, each with a worker: hosts_light_test.py GLURAY WORKER, with an X server at
hand. Exits with 77 where there can be no such hosts, or something is missing."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import hosts
from sort_last_test import Pictures, check_light


class HostsPictures(Pictures):
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


def main(gluray, worker):
    why = hosts.why_not()
    if why or not all(map(shutil.which, ("pvbatch", "mpirun.openmpi", "convert"))):
        print(why)
        return 77
    with tempfile.TemporaryDirectory() as folder:
        network = hosts.Network(2, pathlib.Path(folder))
        try:
            check_light(HostsPictures(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder), network))
        finally:
            network.end()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
