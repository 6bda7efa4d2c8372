"""Light across the ranks of pvserver, whose client shows the image: pvserver_test.py GLURAY WORKER, with an X server at hand. Exits with 77
where ParaView, Open MPI or ImageMagick is missing."""
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile

import hosts
from sort_last_test import HERE, LIGHTS, Images, check_light

SECONDS = 240


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class ServedImages(Images):
    """`network`: what puts a command into a network of its own, because pvserver listens on all interfaces; empty: nothing does."""

    def __init__(self, gluray, worker, folder, network):
        super().__init__(gluray, worker, folder)
        self.network = network

    def draw(self, name, ranks, *options):
        path, port = self.folder / f"{name}.png", free_port()
        log = self.folder / f"{name}.log"
        with log.open("w") as file:
            server = subprocess.Popen(self.network(*self.launcher(ranks), self.gluray, "--engine", "always", *self.light, *options, "--", "pvserver",
                                                   f"--server-port={port}"), env=self.environment, stdout=file, stderr=subprocess.STDOUT)
        try:
            self.wait_for(log, "Accepting connection")
            # Without GLuRay: an image that the client drew has no light.
            done = subprocess.run(self.network("pvpython", str(HERE / "sort_last.py"), str(path), str(port)), env=self.environment,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=SECONDS, check=False)
            assert done.returncode == 0 and path.exists(), done.stdout + log.read_text()
            assert server.wait(60) == 0, log.read_text()
        finally:
            server.kill()
            server.wait()
        return path, log.read_text()


def main(gluray, worker):
    if not all(map(shutil.which, ("pvserver", "pvpython", "pvbatch", "mpirun", "convert"))):
        return 77
    with tempfile.TemporaryDirectory() as folder:
        host = None if hosts.why_not() else hosts.Machine("server")
        try:
            network = host.inside if host else lambda *words: list(words)
            images = ServedImages(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder), network)
            for name in LIGHTS:
                check_light(images, name)
        finally:
            if host:
                host.end()
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
