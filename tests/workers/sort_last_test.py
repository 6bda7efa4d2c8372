"""Light across the ranks of pvbatch, whose workers ask each other, or gather what all ranks draw: sort_last_test.py GLURAY WORKER, with an X
server at hand. Exits with 77 where pvbatch, Open MPI or ImageMagick is missing."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
LIGHTS = {
    "occlusion": ["ao=on", "ao.samples=16", "refine.passes=1"],
    "paths": ["gather=on", "integrator=path", "refine.passes=8", "noise=0.001"],
    "mirrors": ["gather=on", "integrator=whitted", "material=mirror", "refine.passes=1"],
}
STEP = 2  # of 255: colours that differ by less are equal, because each rank rounds coordinates in a space of its own


def pixels(path):
    """Red, green and blue of each pixel of a PNG file."""
    return subprocess.run(["convert", path, "-depth", "8", "rgb:-"], stdout=subprocess.PIPE, check=True).stdout


def compare(a, b):
    """Mean difference of channels, and the share of pixels that differ by more than STEP."""
    differences = [abs(x - y) for x, y in zip(a, b)]
    off = sum(max(differences[i:i + 3]) > STEP for i in range(0, len(differences), 3))
    return sum(differences) / len(differences), off / (len(differences) // 3)


class Images:
    def __init__(self, gluray, worker, folder):
        self.light = []  # options of its settings
        self.gluray, self.worker, self.folder = gluray, worker, folder
        self.environment = dict(os.environ, GALLIUM_DRIVER="llvmpipe", LIBGL_ALWAYS_SOFTWARE="1", XDG_RUNTIME_DIR=str(folder / "run"),
                                XDG_CONFIG_HOME=str(folder), HOME=str(folder))
        (folder / "run").mkdir(mode=0o700)

    @staticmethod
    def launcher(ranks):
        if ranks == 1:
            return []
        root = ["--allow-run-as-root"] if os.getuid() == 0 else []
        return ["mpirun", *root, "--oversubscribe", "--mca", "mpi_yield_when_idle", "1", "-np", str(ranks)]

    def draw(self, name, ranks, *options, script=()):
        """The image's file, and what was said."""
        path = self.folder / f"{name}.png"
        done = subprocess.run([*self.launcher(ranks), self.gluray, "--engine", "always", *self.light, *options, "--", "pvbatch", HERE / "sort_last.py", path,
                               *script], env=self.environment, stderr=subprocess.PIPE, text=True, timeout=240, check=False)
        assert done.returncode == 0 and path.exists(), done.stderr
        return path, done.stderr

    @staticmethod
    def wait_for(log, text):
        for _ in range(1200):
            if text in log.read_text():
                return
            time.sleep(0.05)
        raise AssertionError(log.read_text())

    def job(self):
        """One worker for all ranks, and the file of its messages."""
        log = self.folder / "log"
        with log.open("w") as file:
            process = subprocess.Popen([self.worker, "--job", "test"], env=self.environment, stderr=file)
        self.wait_for(log, "programs join with")
        return process, log


def check_report(path, asks):
    """Rank 0's report has a row for each rank. `asks`: light crosses their borders, so that times of light are known."""
    report = json.loads(path.read_text())
    rows = report["ranks"]
    print(f"{path.name}: {report['limit']}; {[(row['state'], row['ms']) for row in rows]}")
    assert [row["rank"] for row in rows] == [0, 1] and report["workers"] == "answer", report
    assert all(row["state"] in ("connected", "ended") and row["memory"] > 1e6 and row["host"] for row in rows), rows
    assert rows[0]["images"] > 0 and (rows[1]["images"] > 0 or not asks), rows
    assert not asks or all(row["ms"]["eye"] > 0 and row["ms"]["light"] > 0 and row["bytes"]["sent"] > 0 for row in rows), rows
    assert not asks or not report["limit"].startswith("not measured"), report["limit"]
    assert not list(path.parent.glob(path.name + ".*")), "other ranks write no file"


def check_light(images, name="occlusion"):
    """Two ranks with workers draw the image of one rank, and another one without workers."""
    images.light = [word for setting in LIGHTS[name] for word in ("--set", setting)]
    expected, _ = images.draw("one", 1)
    alone, _ = images.draw("alone", 2)
    job, log = images.job()
    try:
        report = images.folder / f"{name}.json"
        together, said = images.draw("together", 2, "--workers", "test", "--report", report)
    finally:
        job.terminate()
        job.wait()
    without, across = (compare(pixels(expected), pixels(found)) for found in (alone, together))
    print(f"{name}: mean difference and share of pixels: without workers {without}, with workers {across}")
    assert without[1] > 0.05, "the scene shows nothing of other ranks"
    # Rays that graze the cut through a sphere meet it or not.
    assert across[0] < 0.1 and across[1] < 0.01, log.read_text() + said
    check_report(report, asks=name == "occlusion")
    assert "does not" not in log.read_text() and "draws nothing" not in log.read_text(), log.read_text()


def check_animation(images):
    """The last frame of an animation is smooth, and all ranks' surfaces darken it, although few rays were traced."""
    images.light = [word for setting in LIGHTS["occlusion"] for word in ("--set", setting)]
    expected, _ = images.draw("one", 1, "--set", "refine.passes=16")
    images.light += ["--set", "refine.offscreen=animated", "--set", "fps=1"]
    alone, _ = images.draw("alone", 2, script=["orbit"])
    job, log = images.job()
    try:
        together, said = images.draw("together", 2, "--workers", "test", script=["orbit"])
        finished, _ = images.draw("finished", 2, "--workers", "test", "--set", "refine.offscreen=finished", script=["orbit"])
    finally:
        job.terminate()
        job.wait()
    without, across = (compare(pixels(expected), pixels(found)) for found in (alone, together))
    assert pixels(together) != pixels(finished), "its frames were not animated"
    print(f"animation: mean difference and share of pixels: without workers {without}, with workers {across}")
    assert across[0] < 1.5 and across[0] < without[0] / 4, log.read_text() + said


def main(gluray, worker):
    if not all(map(shutil.which, ("pvbatch", "mpirun", "convert"))):
        return 77
    with tempfile.TemporaryDirectory() as folder:
        images = Images(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder))
        for name in LIGHTS:
            check_light(images, name)
        check_animation(images)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
