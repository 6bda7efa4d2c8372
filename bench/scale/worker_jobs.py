"""Jobs of gluray-worker under Open MPI's launcher, for measurements on this machine."""
import contextlib
import os
import pathlib
import shutil
import signal
import subprocess
import threading
import time

from support.programs import Failed

LAUNCHER = next((name for name in ("mpirun.openmpi", "mpirun") if shutil.which(name)), "mpirun.openmpi")
OPTIONS = ["--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]


def launcher(ranks):
    """The launcher's command line for so many ranks, which share the machine's cores."""
    return [LAUNCHER, "-n", str(ranks), *OPTIONS, *(["--allow-run-as-root"] if os.getuid() == 0 else [])]


def _rank_of(process, mpirun):
    """The rank of a process that `mpirun` started; None: it is no such process."""
    try:
        parent = int((process / "stat").read_text().rsplit(")", 1)[1].split()[1])
        words = (process / "environ").read_bytes().split(b"\0") if parent == mpirun else []
        return next((int(word.split(b"=")[1]) for word in words if word.startswith(b"OMPI_COMM_WORLD_RANK=")), None)
    except (OSError, ValueError, IndexError):
        return None


def rank_processes(mpirun, ranks):
    """Numbers of the ranks' processes, in the order of the ranks."""
    found = {}
    for process in pathlib.Path("/proc").iterdir():
        if process.name.isdigit() and (rank := _rank_of(process, mpirun)) is not None:
            found[rank] = int(process.name)
    if sorted(found) != list(range(ranks)):
        raise Failed(f"{ranks} ranks were started, and {len(found)} found")
    return [found[rank] for rank in range(ranks)]


@contextlib.contextmanager
def joined(process, log, what):
    """Waits until programs can join the job that the process, a session of its own, has started; ends it afterwards."""
    try:
        end = time.monotonic() + 60
        while "programs join with" not in log.read_text():
            if process.poll() is not None or time.monotonic() > end:
                raise Failed(f"no job: {what}\n{log.read_text()}")
            time.sleep(0.05)
        yield
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGTERM)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


@contextlib.contextmanager
def job(worker, name, ranks, folder, *options):
    """A job whose ranks trace with one thread each and have their sockets in `folder`; gives their processes. `options`: more of the worker's."""
    log = pathlib.Path(folder) / f"{name}.log"
    command = [*launcher(ranks), str(worker), "--job", name, "--threads", "1", *options]
    with log.open("w") as file:
        process = subprocess.Popen(command, env={**os.environ, "GLURAY_RUNTIME": str(folder)}, stdin=subprocess.DEVNULL, stdout=file, stderr=file,
                                   start_new_session=True)
    with joined(process, log, " ".join(command)):
        yield rank_processes(process.pid, ranks)


class PeakMemory:
    """The most memory of their own (anonymous pages) that processes take while this is entered, looked at five times a second."""

    def __init__(self, processes):
        self.most = dict.fromkeys(processes, 0)  # bytes
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def _look(self, process):
        with contextlib.suppress(OSError, StopIteration):
            lines = pathlib.Path(f"/proc/{process}/status").read_text().splitlines()
            now = 1024 * next(int(line.split()[1]) for line in lines if line.startswith("RssAnon:"))
            self.most[process] = max(self.most[process], now)

    def _watch(self):
        while not self._over.wait(0.2):
            for process in self.most:
                self._look(process)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._over.set()
        self._thread.join()
