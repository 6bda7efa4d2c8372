"""Programs whose stacks are small, and framebuffers of very different shapes: through each door, with EGL and GLX, a
program draws the same image as with plenty, and takes little more memory than without GLuRay.
Arguments: GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY [unittest arguments]."""
import re
import subprocess
import sys
import unittest

from compare_images import differing, images
from manners import CLIENTS, GLURAY

DOORS, APIS = ("vendor", "preload"), ("egl", "glx")
EFFECTS = ("--set", "ao=on", "--set", "shadows=on", "--set", "integrator=path", "--set", "path.samples=1")
SAME = 0.01  # of the pixels may differ: edges of triangles, noise of light


def draw(api: str, scene: str, stack: int = 0, door: str = "", limit: str = "", settings=()) -> subprocess.CompletedProcess:
    """`stack` in kB, 0: the main thread draws. `limit`: commands of the shell that set limits. No door: without GLuRay."""
    words = [GLURAY, "--door", door, *settings, "--"] if door else []
    words += [CLIENTS / "door_limits", api, scene, stack]
    script = f'ulimit -c 0; {limit}\nexec "$@"'
    return subprocess.run(["sh", "-c", script, "sh", *map(str, words)], capture_output=True, timeout=100)


def image(done: subprocess.CompletedProcess) -> bytes:
    assert done.returncode == 0, f"{done.args}: exit code {done.returncode}: {done.stderr.decode()}"
    (width, height, pixels), = images(done.stdout)
    assert len(pixels) == 3 * width * height and len(set(pixels)) > 10, "the image is empty"
    return pixels


def same(a: bytes, b: bytes) -> bool:
    return len(a) == len(b) and differing(a, b) <= SAME * len(a) / 3


def peak(done: subprocess.CompletedProcess) -> int:
    """Memory that the program used at most, in MB."""
    return int(re.search(rb"VmHWM:\s*(\d+) kB", done.stderr)[1]) // 1024


class Stacks(unittest.TestCase):
    def test_small_threads(self):
        for api in APIS:
            image(draw(api, "small", 64))
            for door in DOORS:
                for settings in ((), EFFECTS):
                    ample = image(draw(api, "small", 4096, door, settings=settings))
                    for stack in (64, 128):
                        with self.subTest(api=api, door=door, settings=settings, stack=stack):
                            self.assertTrue(same(image(draw(api, "small", stack, door, settings=settings)), ample))

    def test_small_limit(self):
        """Threads that libraries start have small stacks, too."""
        for door in DOORS:
            for settings in ((), EFFECTS):
                ample = image(draw("egl", "large", 0, door, settings=settings))
                for kilobytes in (64, 160):
                    with self.subTest(door=door, settings=settings, kilobytes=kilobytes):
                        done = draw("egl", "large", 0, door, f"ulimit -s {kilobytes}", settings)
                        self.assertTrue(same(image(done), ample))


class Shapes(unittest.TestCase):
    def test_framebuffers_of_all_shapes(self):
        """One texture for images of 16384x16 and 16x16384 pixels would take 2 GB."""
        for api, door in zip(APIS, DOORS):
            with self.subTest(api=api, door=door):
                plain, done = draw(api, "sizes"), draw(api, "sizes", door=door)
                self.assertTrue(same(image(done), image(plain)))
                self.assertLess(peak(done), peak(plain) + 400)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
