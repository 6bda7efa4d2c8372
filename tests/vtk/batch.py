"""Runs batches of states (registry.py) in pvbatch or python3, with or without the launcher, and keeps their output."""
import dataclasses
import hashlib
import json
import os
import pathlib
import shlex
import shutil
import socket
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
SECONDS = 180  # for one process, however many states it draws, on a machine that is busy with other things
PYTHON = "/usr/bin/python3"  # Debian's own: the modules belong to it


class Skipped(RuntimeError):
    """Something that a test needs is not installed."""


def vtk_modules():
    """The folder of python3-vtk9's modules."""
    done = subprocess.run([str(HERE / "unpack_vtk9")], capture_output=True, text=True)
    if done.returncode == 77:
        raise Skipped(done.stderr.strip())
    if done.returncode:
        raise RuntimeError(f"unpack_vtk9 failed: {done.stderr.strip()}")
    return done.stdout.strip()


def need(program):
    if not shutil.which(program):
        raise Skipped(f"{program} is not installed")


def command(program, launcher, report):
    """The command that runs a Python script in `program`, additions to its environment, and the report's file."""
    more = {"VTK_STATES_REPORT": str(report)} if report else {}
    if program == "vtk":
        return [*launcher, PYTHON], more | {"PYTHONPATH": vtk_modules()}
    if program == "newer_vtk":
        if subprocess.run([PYTHON, "-c", "import vtkmodules"], capture_output=True, cwd="/").returncode:
            raise Skipped("python3-paraview is not installed")
        return [*launcher, PYTHON], more
    if program == "remote":
        need("pvpython")
        return ["pvpython"], {}  # the server is what is looked at
    need("pvbatch")
    if program == "pvbatch":
        return [*launcher, "pvbatch"], more
    need("mpirun")
    words = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-np", program[len("mpi"):]]
    if not report:
        return [*words, "pvbatch"], {}
    # Each process has a report of its own; the first one's is read.
    launch = " ".join(shlex.quote(word) for word in launcher).replace(shlex.quote(str(report)), f'"{report}.$OMPI_COMM_WORLD_RANK"')
    return [*words, "sh", "-c", f'exec {launch} pvbatch "$@"', "sh"], {"VTK_STATES_REPORT": f"{report}.0"}


class Server:
    """pvserver; it ends after its client."""

    def __init__(self, launcher, folder, settings):
        need("pvserver")
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.log = folder / "server.log"
        with open(self.log, "w") as log:
            self.process = subprocess.Popen([*launcher, "pvserver", f"--server-port={self.port}"], env=settings, stdout=log,
                                            stderr=log, cwd=folder)
        deadline = time.monotonic() + 60
        while "Accepting connection" not in self.log.read_text():
            if self.process.poll() is not None or time.monotonic() > deadline:
                self.end()
                raise RuntimeError(f"pvserver does not listen: {self.log.read_text()[-500:]}")
            time.sleep(0.05)

    def end(self):
        """Its exit code; None if it had to be stopped."""
        try:
            return self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            return None


def environment(home, **more):
    """The environment: the same renderer everywhere, no user settings."""
    home.mkdir(parents=True, exist_ok=True)
    ours = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    return dict(ours, GALLIUM_DRIVER="llvmpipe", LIBGL_ALWAYS_SOFTWARE="1", HOME=str(home), LC_ALL="C",
                XDG_CACHE_HOME=os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache")),
                PYTHONDONTWRITEBYTECODE="1", **more)


@dataclasses.dataclass
class Batch:
    """Some states of one program, drawn one after the other by one process."""
    program: str
    names: list
    folder: pathlib.Path

    def draw(self, launcher=(), report=None):
        """Draws the remaining states. Notes a state in which the process ends, and continues with the others."""
        words, more = command(self.program, launcher, report)
        settings = environment(self.folder / "home", **more)
        left = [name for name in self.names if not self.result_file(name).exists()]
        while left:
            end = self.run_once([*words, str(HERE / "runner.py"), str(self.folder), *left], settings, launcher)
            after = [name for name in left if not self.result_file(name).exists()]
            if not after:
                if end:  # all is drawn, and the process died of something later
                    self.note(left[-1], f"{end} after the last state")
                return
            self.note(after[0], f"{end or 'the process ended'}; see {self.folder / 'log'}")
            left = after[1:]

    def run_once(self, words, settings, launcher):
        """What was wrong with the process's end; empty if nothing."""
        server = Server(launcher, self.folder, settings) if self.program == "remote" else None
        if server:
            settings = settings | {"VTK_STATES_SERVER": f"127.0.0.1:{server.port}"}
        with open(self.folder / "log", "a") as log:
            process = subprocess.Popen(words, env=settings, stdout=log, stderr=log, cwd=self.folder)
            try:
                code = process.wait(SECONDS)
                end = f"the process ended with {code}" if code else ""
            except subprocess.TimeoutExpired:
                process.terminate()  # mpirun ends its children where it is asked to
                try:
                    process.wait(10)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                end = f"the process did not end within {SECONDS} s"
        if server and (code := server.end()) != 0:
            end = end or f"the server ended with {code}"
        return end

    def note(self, name, error):
        seen = self.result(name)
        self.result_file(name).write_text(json.dumps(seen | {"error": error}) + "\n")

    def result_file(self, name):
        return self.folder / f"{name}.json"

    def result(self, name):
        try:
            return json.loads(self.result_file(name).read_text())
        except FileNotFoundError:
            return {"seconds": 0, "error": "was not drawn", "counts": None}

    def shots(self, name):
        """The files of its images, in the order in which they were taken."""
        found = []
        while (file := self.folder / f"{name}-{len(found)}.png").exists():
            found.append(file)
        return found

    def text(self, name):
        file = self.folder / f"{name}.txt"
        return file.read_text() if file.exists() else ""


def versions():
    done = subprocess.run(["dpkg-query", "-W", "paraview", "python3-paraview", "libvtk[0-9]*", "libgl1-mesa-dri"],
                          capture_output=True, text=True)
    return done.stdout


def key(words):
    """A digest of the states, of the programs that draw them, and of `words`."""
    seen = hashlib.sha256(" ".join([versions(), *words]).encode())
    for file in sorted(HERE.rglob("*.py")):
        seen.update(file.read_bytes())
    return seen.hexdigest()[:16]


def draw_plain(program, names, place):
    """The images of `names` without GLuRay, kept in `place` until the digest changes."""
    folder = place / key([program, *names])
    batch = Batch(program, names, folder)
    if not (folder / "complete").exists():
        shutil.rmtree(place, ignore_errors=True)  # what was kept for an older key
        folder.mkdir(parents=True)
        batch.draw()
        (folder / "complete").touch()
    return batch


def always(gluray):
    """Options that make GLuRay trace every frame, however small."""
    told = subprocess.run([gluray, "run", "--help"], capture_output=True, text=True).stdout
    return ["--engine", "always"] if "--engine" in told else []


def draw_traced(program, names, folder, gluray, options=()):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    report = folder / "report.json"
    batch = Batch(program, names, folder)
    batch.draw([gluray, "run", *always(gluray), *options, "--report", str(report), "--"], report)
    return batch


if __name__ == "__main__":
    sys.exit("batch.py is used by compare.py")
