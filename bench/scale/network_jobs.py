"""Jobs of gluray-worker on hosts of one machine with networks of their own (tests/network), for measurements: the hosts share the machine's cores, so
figures show what the network adds, and no scaling."""
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from scale import worker_jobs
from support.programs import Failed

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "network"))
import network  # noqa: E402

LAUNCHER = "mpirun.openmpi"
# Frames that are as large as the network's: those of Ethernet, and, where each costs the switch much of its time, jumbo frames.
MTU, JUMBO_MTU, JUMBO_FROM = 1500, 9000, 1e9


@contextlib.contextmanager
def job(name, command, worker, folder):
    """A job that the launcher's command line starts."""
    log = pathlib.Path(folder) / f"{name}.log"
    with log.open("w") as file:
        process = subprocess.Popen([*command, str(worker), "--job", name, "--threads", "1"], stdin=subprocess.DEVNULL, stdout=file, stderr=file,
                                   env={**os.environ, "HWLOC_COMPONENTS": "-gl"}, start_new_session=True)
    with worker_jobs.joined(process, log, name):
        yield


def ranks_on(host, worker):
    """Processes of the worker's program there, in the order of their start."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            words = (process / "environ").read_bytes().split(b"\0")
            if f"GLURAY_RUNTIME={host.runtime}".encode() in words and os.path.samefile(process / "exe", worker):
                found.append(int(process.name))
    return sorted(found)


class Hosts:
    """So many hosts, with a job "one" of one rank on the first, and "many" of one on each; threads: one each."""

    def __init__(self, link, worker, ranks, delay_us, bits_per_second):
        if why := network.why_not():
            raise Failed(f"no hosts with networks of their own: {why}")
        self.worker, self.stack = worker, contextlib.ExitStack()
        with contextlib.ExitStack() as stack:
            folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="gluray-bench-", dir="/tmp"))
            mtu = JUMBO_MTU if bits_per_second > JUMBO_FROM else MTU
            self.net = network.Switched(ranks, pathlib.Path(folder), str(link), mtu=mtu)
            stack.callback(self.net.end)
            self.net.delay(delay_us)
            self.net.rate(bits_per_second)
            first = self.net.hosts[0]
            stack.enter_context(job("one", first.command(), worker, folder))
            self.one = ranks_on(first, worker)
            stack.enter_context(job("many", self.net.mpirun(ranks), worker, folder))
            self.many = [process for host in self.net.hosts for process in ranks_on(host, worker) if process not in self.one]
            if (len(self.one), len(self.many)) != (1, ranks):
                raise Failed(f"{ranks} ranks were started, and {len(self.many)} found")
            self.stack = stack.pop_all()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stack.close()

    def runtime(self):
        """The first host's runtime directory, as processes of this machine see it."""
        return f"/proc/{self.net.hosts[0].init}/root{self.net.hosts[0].runtime}"

    def jobs(self):
        """As gluray-bench-image has it."""
        return [f"{name}:{','.join(map(str, processes))}" for name, processes in (("one", self.one), ("many", self.many))]

    def round_trip_us(self):
        """The least of a byte by TCP between the first two hosts."""
        one, other = self.net.hosts[0], self.net.hosts[1]
        server = subprocess.Popen(other.inside(sys.executable, "-c", ECHO, "0"), stdout=subprocess.PIPE, text=True)
        try:
            port = server.stdout.readline().strip()
            done = subprocess.run(one.inside(sys.executable, "-c", ECHO, other.address, port), stdout=subprocess.PIPE, text=True, timeout=60, check=True)
            return float(done.stdout)
        finally:
            server.kill()
            server.wait()
            server.stdout.close()


# PORT: answers byte by byte; ADDRESS PORT: asks.
ECHO = """
import socket, sys, time
def without_delay(connection):
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection
if len(sys.argv) == 2:
    server = socket.create_server(("", int(sys.argv[1])))
    print(server.getsockname()[1], flush=True)
    connection = without_delay(server.accept()[0])
    while byte := connection.recv(1):
        connection.sendall(byte)
else:
    connection, least = without_delay(socket.create_connection((sys.argv[1], int(sys.argv[2])))), 1e9
    for _ in range(200):
        start = time.monotonic()
        connection.sendall(b"x")
        connection.recv(1)
        least = min(least, time.monotonic() - start)
    print(1e6 * least)
"""
