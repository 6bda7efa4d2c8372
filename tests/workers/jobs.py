"""Jobs of gluray-worker for tests, alone and by the launchers that are installed."""
import os
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "controls"))
from fake_programs import wait_for  # noqa: E402
from parts import Parts  # noqa: E402


class Jobs(Parts):
    worker = ""  # path of the program

    def setUp(self):
        super().setUp()
        self.logs = 0

    def log(self):
        self.logs += 1
        return self.folder / f"log{self.logs}"

    def job(self, *launcher, options=()):
        """A job of gluray-worker; its process and the file of its messages, once it listens."""
        path = self.log()
        with path.open("w") as file:
            process = self.spawn(*launcher, self.worker, "--job", "test", *options, stderr=file, stdout=file)
        self.assertTrue(wait_for(lambda: "programs join with" in path.read_text() or process.poll() is not None))
        self.assertIsNone(process.poll(), path.read_text())
        return process, path

    def mpi(self, name, *options, ranks=3):
        for path in (f"mpirun.{name}", f"mpiexec.{name}"):
            if shutil.which(path):
                return [path, "-n", str(ranks), *options]
        self.skipTest(f"{name} is not installed")

    def openmpi(self, ranks=3):
        return self.mpi("openmpi", "--oversubscribe", *(["--allow-run-as-root"] if os.getuid() == 0 else []), ranks=ranks)

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
