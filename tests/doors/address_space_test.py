"""Programs whose memory is limited (ulimit -v, -d): wherever a program lives without GLuRay, it lives through each door,
and shows that image or the traced one. Arguments: GLURAY LIBRARY_DIRECTORY CLIENTS_DIRECTORY edges|vendor|preload:
limits around those where the behaviour changes, or all in steps of 4 MB through that door.

Mesa's threads and their arenas of malloc make the least limit a matter of chance, so their number is fixed, and limits
below 400 MB are tried without such threads. A limit counts where the program alone lives three times."""
import functools
import itertools
import os
import re
import subprocess
import sys
import unittest

from limits_test import APIS, DOORS, EFFECTS, draw, image, same
from manners import CLIENTS, GLURAY, run

WHICH = sys.argv.pop(4)
STEP = 4  # MB
FROM, SINGLE, TO = 220, 400, 1300  # MB
MANY, MANY_FROM, MANY_TO = 8, 800, 1900  # Mesa's threads with as many arenas, and MB: below, the program often dies alone
RUNS = 3
# Opened without Mesa's threads; with them; the launcher opens the doors (664); the engine is loaded, and all is traced.
EDGES = (240, 268, 340, 380, 420, 520, 640, 668, 820, 892, 908, 932, 1000, 1200)
DATA_EDGES = (60, 160, 400, 660, 680, 740, 1000)
SHORT = r"^gluray: (OpenGL is not ray traced in this program|not ray traced): limits of the process \(ulimit -v, -d\) leave less than " \
        r"the \d+ MB that OpenGL and ray tracing need\n"


def use(threads: int) -> None:
    """Mesa's threads, and arenas of malloc, in programs from now on."""
    os.environ.update(LP_NUM_THREADS=str(threads), MALLOC_ARENA_MAX=str(max(threads, 1)))


def limited(megabytes: int, api: str, scene: str, option: str = "-v", **more):
    return draw(api, scene, limit=f"ulimit {option} {megabytes * 1024}", **more)


@functools.cache
def ample(api: str, scene: str, **more) -> bytes:
    use(2)
    return image(draw(api, scene, **more))


@functools.cache
def lives(megabytes: int, api: str, scene: str, option: str, threads: int) -> bool:
    """Whether the program alone shows its image each time. Without memory it may show nothing and exit as usual."""
    def shows(done) -> bool:
        try:
            return same(image(done), ample(api, scene))
        except AssertionError:
            return False

    use(threads)
    count = RUNS if threads != 2 else 1
    alone = (limited(megabytes, api, scene, option) for _ in range(count))
    return all(map(shows, alone))


def lives_about(megabytes: int, *how) -> bool:
    """The same at somewhat lower limits, too. Near 60 MB of data Mesa's compiler finds room at one limit and not at the next, and the doors take some
    of what there is."""
    lower = range(4) if megabytes < 100 else (0,)
    return all(lives(megabytes - less, *how) for less in lower)


class Limits(unittest.TestCase):
    def try_limit(self, megabytes: int, api: str, scene: str, door: str, settings=(), option="-v", threads=2) -> str:
        """What is seen: "dies" alone, "plain" or "traced"; the last where both images are the same."""
        if not lives_about(megabytes, api, scene, option, threads):
            return "dies"
        with self.subTest(option=option, megabytes=megabytes, api=api, scene=scene, door=door, settings=settings):
            plain, traced = ample(api, scene), ample(api, scene, door=door, settings=settings)
            use(threads)
            shown = image(limited(megabytes, api, scene, option, door=door, settings=settings))
            if same(shown, traced):
                return "traced"
            self.assertTrue(same(shown, plain), "another image")
        return "plain"

    def check(self, seen: list) -> None:
        """Most limits were tried; with effects, whose images differ, some were not traced, and the last were."""
        self.assertGreater(len(seen) - seen.count("dies"), len(seen) // 2)
        self.assertEqual(seen[-1], "traced")


def without_threads(megabytes: int) -> int:
    return 0 if megabytes < SINGLE else 2


@unittest.skipUnless(WHICH == "edges", "the sweep alone")
class Edges(Limits):
    # Of all combinations, two at each limit that differ in all ways: in four limits, all pairs of ways occur.
    COMBINATIONS = [(APIS[i], ("small", "large")[j], DOORS[k], ((), EFFECTS)[i ^ j ^ k])
                    for i, j, k in itertools.product(range(2), repeat=3)]

    def test_address_space(self):
        seen = {(): [], EFFECTS: []}
        for i, megabytes in enumerate(EDGES):
            for combination in (i % 4, 7 - i % 4):
                api, scene, door, settings = self.COMBINATIONS[combination]
                seen[settings].append(self.try_limit(megabytes, api, scene, door, settings, threads=without_threads(megabytes)))
        for one in seen.values():
            self.check(one)
        self.assertIn("plain", seen[EFFECTS])

    def test_data(self):
        seen = [self.try_limit(megabytes, APIS[i % 2], "small", DOORS[i // 2 % 2], EFFECTS, "-d")
                for i, megabytes in enumerate(DATA_EDGES)]
        self.check(seen)
        self.assertIn("plain", seen)

    def test_many_threads(self):
        """Arenas of malloc for each thread take most of the address space, and the compiler gets what is left."""
        for megabytes, door in itertools.product((1100, 1420, 1440, 1700), DOORS):
            self.try_limit(megabytes, "egl", "small", door, threads=MANY)

    def test_program_that_grows(self):
        """What the program takes later is missing, too, and limits that it sets itself: the real OpenGL draws on."""
        for (api, scene), door in zip(itertools.product(APIS, ("grows", "lowers")), DOORS * 2):
            with self.subTest(api=api, scene=scene, door=door):
                use(2)
                plain = limited(4000, api, scene) if scene == "grows" else draw(api, scene)
                done = limited(4000, api, scene, door=door) if scene == "grows" else draw(api, scene, door=door)
                self.assertTrue(same(image(done), image(plain)))
                self.assertRegex(done.stderr, rb"real OpenGL draws some frames.*: limits of the process \(ulimit -v, -d\)")

    def test_doors_alone_take_little(self):
        """The limit is set behind the launcher: the doors are open, and the engine is not loaded."""
        def behind(megabytes, *words):
            script = f'ulimit -c 0; ulimit -v {megabytes * 1024}; exec "$@"'
            return subprocess.run([*words, "sh", "-c", script, "sh", CLIENTS / "door_limits", "egl", "small", "0"],
                                  capture_output=True, timeout=100)

        use(0)
        least = next(megabytes for megabytes in range(200, 500, 4) if all(
            behind(more).returncode == 0 for more in (megabytes, megabytes + 4, megabytes + 8)))
        plain = ample("egl", "small")
        for door in DOORS:
            with self.subTest(door=door, least=least):
                self.assertTrue(same(image(behind(least + 8, GLURAY, "--door", door, "--")), plain))

    def test_one_line_says_so(self):
        """Hard limits below what is needed; and one that leaves too little only when the program is loaded."""
        def said(option, megabytes, *words):
            script = f'ulimit -c 0; ulimit {option} {megabytes * 1024}; exec "$@"'
            return run("sh", "-c", script, "sh", GLURAY, *words)

        use(2)
        program = CLIENTS / "door_linked_gl"
        for option, megabytes in (("-v", 500), ("-d", 500), ("-v", 760)):
            with self.subTest(option=option, megabytes=megabytes):
                done = said(option, megabytes, "--", program)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertRegex(done.stderr, SHORT + "$")
                done = said(option, megabytes, "explain", "--", program)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertRegex(done.stderr, SHORT if megabytes == 760 else SHORT + "$")
                done = said(option, megabytes, "doctor")
                self.assertEqual(done.returncode, 2, done.stderr)
                text = " ".join(done.stdout.split())
                self.assertIn("BROKEN", text)
                self.assertRegex(text, SHORT.removeprefix("^gluray: ").removesuffix(r"\n"))
                self.assertNotIn("saw no context", text)


@unittest.skipIf(WHICH == "edges", "edges alone")
class Sweep(Limits):
    def test_all(self):
        for api, scene in itertools.product(APIS, ("small", "large")):
            seen = {(): [], EFFECTS: []}
            for megabytes, settings in itertools.product(range(FROM, TO + 1, STEP), seen):
                seen[settings].append(self.try_limit(megabytes, api, scene, WHICH, settings, threads=without_threads(megabytes)))
            for one in seen.values():
                self.check(one)
            lives.cache_clear()

    def test_data(self):
        seen = [self.try_limit(megabytes, api, "small", WHICH, EFFECTS, "-d")
                for megabytes, api in itertools.product(range(40, 900, STEP), APIS)]
        self.check(seen)

    def test_many_threads(self):
        for megabytes in range(MANY_FROM, MANY_TO, STEP):
            self.try_limit(megabytes, "egl", "small", WHICH, threads=MANY)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
