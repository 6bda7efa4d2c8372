"""Programs whose address space is limited (ulimit -v): wherever a program lives without GLuRay, it lives through each
door, and shows that picture or the traced one. Limits from where the program alone dies to where it is traced.
Arguments: GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY STEP, in MB.

Mesa's threads and their arenas of malloc make the least limit a matter of chance, so their number is fixed, and limits
below 400 MB are tried without such threads. A limit counts where the program alone lives three times."""
import os
import subprocess
import sys
import unittest

from limits_test import APIS, DOORS, EFFECTS, draw, picture, same
from manners import CLIENTS, GLURAY

STEP = int(sys.argv.pop(4))
FROM, SINGLE, TO = 220, 400, 1300  # MB
MANY, MANY_FROM, MANY_TO = 8, 800, 2100  # Mesa's threads with as many arenas, and MB: below, the program often dies alone
RUNS = 3


def use(threads: int) -> None:
    """Mesa's threads, and arenas of malloc, in programs from now on."""
    os.environ.update(LP_NUM_THREADS=str(threads), MALLOC_ARENA_MAX=str(max(threads, 1)))


def limited(megabytes: int, api: str, scene: str, **more):
    return draw(api, scene, limit=f"ulimit -v {megabytes * 1024}", **more)


class Limits(unittest.TestCase):
    def sweep(self, api: str, scene: str, door: str, settings=(), many=False):
        use(2)
        plain, traced = picture(draw(api, scene)), picture(draw(api, scene, door=door, settings=settings))
        tried = ends = 0
        least, most = (MANY_FROM, MANY_TO) if many else (FROM, TO)
        for megabytes in range(least, most + 1, STEP):
            use(MANY if many else 0 if megabytes < SINGLE else 2)
            alone = [limited(megabytes, api, scene) for _ in range(RUNS if many or megabytes < SINGLE else 1)]
            if any(run.returncode != 0 or not same(picture(run), plain) for run in alone):
                continue
            tried += 1
            with self.subTest(api=api, scene=scene, door=door, settings=settings, megabytes=megabytes):
                shown = picture(limited(megabytes, api, scene, door=door, settings=settings))
                ends += same(shown, traced)
                self.assertTrue(same(shown, plain) or same(shown, traced))
        self.assertGreater(tried, (most - least) // STEP // 2)
        if settings:  # the picture differs from that of the real OpenGL
            self.assertGreater(ends, 0, "nothing was traced")

    def test_small(self):
        for api in APIS:
            for door in DOORS:
                self.sweep(api, "small", door)

    def test_effects(self):
        for api, door in zip(APIS, DOORS):
            self.sweep(api, "small", door, EFFECTS)

    def test_large(self):
        for api, door in zip(APIS, reversed(DOORS)):
            self.sweep(api, "large", door)

    def test_many_threads(self):
        """Arenas of malloc for each thread take most of the address space, and the compiler gets what is left."""
        for door in DOORS:
            self.sweep("egl", "small", door, many=True)

    def test_program_that_grows(self):
        """What the program takes later is missing, too: tracing ends while the real OpenGL has enough."""
        use(2)
        for api in APIS:
            for door in DOORS:
                with self.subTest(api=api, door=door):
                    plain, done = limited(4000, api, "grows"), limited(4000, api, "grows", door=door)
                    self.assertTrue(same(picture(done), picture(plain)))
                    self.assertRegex(done.stderr, rb"stepping aside.*: the limit of its address space")

    def test_doors_alone_take_little(self):
        """The limit is set behind the launcher: the doors are open, and the engine is not loaded."""
        def lives(megabytes, *words):
            script = f'ulimit -c 0; ulimit -v {megabytes * 1024}; exec "$@"'
            return subprocess.run([*words, "sh", "-c", script, "sh", CLIENTS / "door_limits", "egl", "small", "0"],
                                  capture_output=True, timeout=100)

        use(0)
        plain = picture(draw("egl", "small"))
        least = next(megabytes for megabytes in range(200, 500, 4) if all(
            lives(more).returncode == 0 for more in (megabytes, megabytes + 4, megabytes + 8)))
        for door in DOORS:
            with self.subTest(door=door, least=least):
                self.assertTrue(same(picture(lives(least + 8, GLURAY, "--door", door, "--")), plain))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
