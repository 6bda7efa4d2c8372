"""Light across the ranks of ParaView's programs on hosts of a network, by queries and by `gather`: parts_test.py LINK GLURAY WORKER [CASE...], with an X
server at hand. Exits with 77 where there can be no such network, or something is missing."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import network
from sort_last_test import HERE, LIGHTS, Images, compare, pixels

SECONDS = 240
LEAST = 50_000  # bytes that cross cables while the ranks draw one script's images
ATTEMPTS = 3  # where a rank was late, which the machine's other work may have caused


class Hosts(Images):
    """Ranks of pvbatch, one on each host."""

    def __init__(self, gluray, worker, folder, net):
        super().__init__(gluray, worker, folder)
        self.net, self.logs = net, 0
        self.environment["HWLOC_COMPONENTS"] = "-gl"  # it asks X servers of others, and ends where they do

    def launcher(self, ranks):
        return self.net.mpirun(ranks) if ranks > 1 else []

    def job(self):
        """A worker on each host but the last, and the file of messages."""
        self.logs += 1
        log = self.folder / f"log{self.logs}"
        with log.open("w") as file:
            process = subprocess.Popen(self.net.mpirun(len(self.net.hosts) - 1, self.worker, "--job", "test", "--threads", "1"), env=self.environment,
                                       stderr=file, stdin=subprocess.DEVNULL)
        self.wait_for(log, "programs join with")
        return process, log


class ServedHosts(Hosts):
    """Ranks of pvserver; the client is on the last host, without GLuRay."""

    def draw(self, name, ranks, *options):
        path, log = self.folder / f"{name}.png", self.folder / f"{name}.log"
        server_host = self.net.hosts[0]
        words = [self.gluray, "--engine", "always", *self.light, *options, "--", "pvserver", "--server-port=11111"]
        with log.open("w") as file:
            server = subprocess.Popen(self.launcher(ranks) + words if ranks > 1 else server_host.command(*words), env=self.environment, stdout=file,
                                      stderr=subprocess.STDOUT)
        try:
            self.wait_for(log, "Accepting connection")
            client = self.net.hosts[-1].inside("pvpython", str(HERE / "sort_last.py"), str(path), f"{server_host.address}:11111")
            done = subprocess.run(client, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=SECONDS, check=False)
            assert done.returncode == 0 and path.exists(), done.stdout + log.read_text()
            assert server.wait(60) == 0, log.read_text()
        finally:
            server.kill()
            server.wait()
        return path, log.read_text()


def together(images, ranks):
    """The image of the ranks with workers, bytes from each host to each other meanwhile, and what the workers said."""
    job, log = images.job()
    try:
        before = images.net.bytes()
        found, said = images.draw("together", ranks, "--workers", "test")
        after = images.net.bytes()
    finally:
        job.terminate()
        job.wait()
    crossed = [after[a][b] - before[a][b] for a in range(ranks) for b in range(ranks) if a != b]
    return pixels(found), crossed, log.read_text() + said


def check(images, ranks, name):
    """The ranks draw the image of one rank, and their workers say much to each other."""
    images.light = [word for setting in LIGHTS[name] for word in ("--set", setting)]
    expected, _ = images.draw("one", 1)
    alone, _ = images.draw("alone", ranks)
    for _ in range(ATTEMPTS):
        found, crossed, said = together(images, ranks)
        if "does not answer" not in said and "draws nothing" not in said:
            break
    without, across = compare(pixels(expected), pixels(alone)), compare(pixels(expected), found)
    print(f"{type(images).__name__}, {ranks} ranks, {name}: mean difference and share of pixels: without workers {without}, with workers {across}; "
          f"bytes from host to host {crossed}", flush=True)
    assert without[1] > 0.05, "the scene shows nothing of other ranks"
    assert across[0] < 0.1 and across[1] < 0.01, said
    assert "does not answer" not in said and "draws nothing" not in said, said
    assert min(crossed) > LEAST, said


CASES = {"pvbatch": (Hosts, 2, LIGHTS), "three": (Hosts, 3, ("occlusion",)), "pvserver": (ServedHosts, 2, ("occlusion", "paths"))}


def main(link, gluray, worker, *cases):
    why = network.why_not()
    if why or not all(map(shutil.which, ("pvbatch", "pvserver", "pvpython", "mpirun.openmpi", "convert"))):
        print(why or "ParaView, Open MPI or ImageMagick is missing")
        return 77
    for case in cases or CASES:
        kind, ranks, names = CASES[case]
        with tempfile.TemporaryDirectory() as folder:
            net = network.Switched(ranks + 1, pathlib.Path(folder), os.path.abspath(link))
            try:
                net.delay(200)
                net.rate(1e9)
                images = kind(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder), net)
                for name in names:
                    check(images, ranks, name)
            finally:
                net.end()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
