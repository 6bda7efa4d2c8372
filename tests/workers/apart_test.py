"""Images of pvbatch whose ranks' data lie away from each other, with `gather`: those of one process. apart_test.py GLURAY WORKER [FOLDER], with an X
server at hand; FOLDER keeps the images. Exits with 77 where pvbatch, Open MPI or ImageMagick is missing."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from sort_last_test import HERE, Images, compare, pixels

IMAGES, RANKS = 6, (2, 3, 4, 8)
# ao.distance: the default is a share of the bounds of what is drawn, which differ where ranks draw less of what lies outside.
LIGHTS = {
    "mirrors": ["integrator=whitted", "material=mirror"],
    "paths": ["integrator=path", "path.samples=4", "refine.passes=4"],
    "shadows": ["ao=on", "ao.distance=1.5", "ao.samples=8", "shadows=on", "refine.passes=2"],
    "filtered": ["ao=on", "ao.distance=1.5", "ao.samples=2", "refine.passes=4", "denoise=filter"],
    "ground": ["ao=on", "ao.distance=1.5", "ao.samples=8", "refine.passes=1", "ground=plane", "lights.up=z"],
    "ground in front": ["integrator=whitted", "material=mirror", "ground=plane", "lights.up=z", "ground.offset=-0.2"],
    "background": ["integrator=path", "path.samples=4", "refine.passes=4", "ground=plane", "lights.up=z", "background=environment"],
    "catcher": ["shadows=on", "lights=headlight+key", "refine.passes=2", "ground=catcher", "lights.up=z"],
    "averages": ["ao=on", "ao.distance=1.5", "ao.samples=8", "refine.passes=2", "spp=4"],
}
SEEN_BY_FIRST = 4  # images in which rank 0 draws something: only there has the composed image a ground, and edges of averages that no box cuts
OF_ONE_COLOR = 3  # images whose background is one colour: only there is it replaced
# By number of ranks: images in which the data of one rank lie outside of the view, so that ParaView does not draw them, and lack their shadow on the ground.
UNDRAWN = {8: (1, 2)}
FAR = 24  # of 255
STRAY = 20  # pixels of a view whose samples hit another side of an edge, because each rank rounds coordinates in a space of its own


class Views(Images):
    def views(self, name, ranks, settings, *options):
        """The images of all cameras, and what was said."""
        folder = self.folder / name
        folder.mkdir()
        words = [word for setting in settings for word in ("--set", setting)]
        done = subprocess.run([*self.launcher(ranks), self.gluray, "--engine", "always", *words, *options, "--", "pvbatch", "--force-offscreen-rendering",
                               HERE / "apart.py", folder], env=self.environment, stderr=subprocess.PIPE, text=True, timeout=240, check=False)
        assert done.returncode == 0, done.stderr
        return [pixels(folder / f"{number}.png") for number in range(IMAGES)], done.stderr


def far(a, b):
    """Pixels that differ by more than FAR."""
    return sum(any(abs(x - y) > FAR for x, y in zip(a[i:i + 3], b[i:i + 3])) for i in range(0, len(a), 3))


def casts_on_ground(settings):
    return any(setting.startswith("ground=") for setting in settings) and {"integrator=path", "shadows=on"} & set(settings)


def check(images, name, settings):
    expected, _ = images.views(f"{name}-1", 1, settings)
    if any(setting.startswith(("ground=", "spp=")) for setting in settings):
        expected = expected[:SEEN_BY_FIRST]
    if any(setting.startswith("background=") for setting in settings):
        expected = expected[:OF_ONE_COLOR]
    job, log = images.job()
    try:
        for ranks in RANKS:
            found, said = images.views(f"{name}-{ranks}", ranks, settings, "--set", "gather=on", "--workers", "test")
            differing = [far(a, b) for a, b in zip(expected, found)]
            for image in UNDRAWN.get(ranks, ()) if casts_on_ground(settings) else ():
                differing[image] = 0
            print(f"{name}, {ranks} ranks: pixels that differ {differing}, mean {[round(compare(a, b)[0], 4) for a, b in zip(expected, found)]}")
            assert max(differing) <= STRAY, log.read_text() + said
    finally:
        job.terminate()
        job.wait()


def main(gluray, worker, keep=None):
    if not all(map(shutil.which, ("pvbatch", "mpirun", "convert"))):
        return 77
    with tempfile.TemporaryDirectory() as folder:
        images = Views(os.path.abspath(gluray), os.path.abspath(worker), pathlib.Path(folder))
        try:
            for name, settings in LIGHTS.items():
                check(images, name, settings)
        finally:
            if keep:
                shutil.copytree(folder, keep, dirs_exist_ok=True, ignore=shutil.ignore_patterns("run"))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
