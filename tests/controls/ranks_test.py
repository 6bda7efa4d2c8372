"""An MPI job of the real mpirun: ranks_test.py GLURAY CLIENT, with an X server at hand. Exits with 77 where mpirun is missing."""
import json
import os
import shutil
import subprocess
import sys
import threading
import time
import unittest

from parts import Parts

RANKS = 2
PERIOD = 0.1    # seconds between frames: messages of the hub take far less
ATTEMPTS = 4    # a busy machine may make a rank late; the hub then says so


class Ranks(Parts):
    def setUp(self):
        super().setUp()
        for rank in range(RANKS):
            os.mkfifo(self.folder / f"in{rank}"), os.mkfifo(self.folder / f"out{rank}")
        inner = f"exec '{self.gluray}' -- '{self.client}' < in$OMPI_COMM_WORLD_RANK > out$OMPI_COMM_WORLD_RANK"
        root = ["--allow-run-as-root"] if os.getuid() == 0 else []
        self.spawn("mpirun", "-n", str(RANKS), "--oversubscribe", *root, "sh", "-c", inner, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        self.inputs = [open(self.folder / f"in{rank}", "w") for rank in range(RANKS)]
        self.outputs = [open(self.folder / f"out{rank}") for rank in range(RANKS)]
        self.addCleanup(self.leave)
        self.stopped = threading.Event()
        self.images = []  # of all ranks, a frame each

    def leave(self):
        for file in self.inputs + self.outputs:
            file.close()

    def draw(self):
        """One frame of all ranks."""
        for file in self.inputs:
            print("frame", file=file, flush=True)
        self.images.append(tuple(file.readline().strip() for file in self.outputs))

    def draw_on(self):
        while not self.stopped.wait(PERIOD):
            self.draw()

    def change(self, *words):
        """The rank 0's result of a command that no rank was late for."""
        for _ in range(ATTEMPTS):
            name, result = next(iter(self.results(*words).items()))
            if not result.get("late"):
                return result
            words = ["undo"] if words[0] == "redo" else ["redo"] if words[0] == "undo" else words
        self.fail(f"a rank is always late: {result}")

    def test_a_change_is_in_the_same_frame_of_all_ranks(self):
        self.draw()
        self.hub()
        thread = threading.Thread(target=self.draw_on)
        thread.start()
        try:
            (entry,) = self.listed(1).values()
            self.assertEqual((entry["ranks"], entry["connected"]), (RANKS, RANKS))
            self.assertEqual(self.change("set", "ao=on", "ao.samples=8")["values"], {"ao": True, "ao.samples": 8})
            after = len(self.images)
            while len(self.images) < after + 3:
                time.sleep(PERIOD)
            self.assertEqual(self.change("undo")["values"]["ao"], False)
            after = len(self.images)
            while len(self.images) < after + 3:
                time.sleep(PERIOD)
        finally:
            self.stopped.set()
            thread.join()
        self.assertTrue(all(one == other for one, other in self.images), self.images)
        kinds = [one for i, (one, _) in enumerate(self.images) if i == 0 or one != self.images[i - 1][0]]
        self.assertEqual(len(kinds), 3, self.images)
        self.assertEqual(kinds[0], kinds[2])


class Lines(Parts):
    """What several ranks would say."""

    def said_by_ranks(self, ranks, *options, **variables):
        """The lines of GLuRay on standard error of all ranks, each of which draws a frame."""
        root = ["--allow-run-as-root"] if os.getuid() == 0 else []
        words = " ".join(f"'{word}'" for word in (self.gluray, *options, "--", self.client))
        done = subprocess.run(["mpirun", "-n", str(ranks), "--oversubscribe", *root, "sh", "-c", f"echo frame | {words}"], timeout=120, check=False,
                              env=dict(self.environment, **variables), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        return [line for line in done.stderr.splitlines() if line.startswith("gluray: ")]

    def test_a_wrong_variable_is_named_once(self):
        for _ in range(2):  # a later job says it again
            line, = self.said_by_ranks(8, GLURAY_SPP="many")
            self.assertRegex(line, r"GLURAY_SPP.*many.* \(rank \d of 8; once on this host\)$")

    def test_a_wrong_option_is_named_once(self):
        line, = self.said_by_ranks(8, "--set", "spp=many")
        self.assertRegex(line, r"spp.* \(rank \d of 8; once on this host\)$")

    def test_one_process_says_its_lines_as_they_are(self):
        done = subprocess.run([self.gluray, "--", self.client], input="frame\n", text=True, capture_output=True, timeout=60, check=False,
                              env=dict(self.environment, GLURAY_SPP="many"))
        self.assertNotIn("rank", done.stderr)
        self.assertIn("GLURAY_SPP", done.stderr)

    def test_ranks_without_workers_write_reports_of_their_own(self):
        self.said_by_ranks(3, "--report", str(self.folder / "run.json"))
        self.assertEqual({path.name for path in self.folder.glob("run.json*")}, {"run.json", "run.json.rank1", "run.json.rank2"})
        for path in self.folder.glob("run.json*"):
            self.assertNotIn("ranks", json.loads(path.read_text()))


if __name__ == "__main__":
    if not shutil.which("mpirun"):
        sys.exit(77)
    Parts.gluray, Parts.client = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
