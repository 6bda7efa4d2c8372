"""An MPI job of the real mpirun: ranks_test.py GLURAY CLIENT, with an X server at hand. Exits with 77 where mpirun is missing."""
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


if __name__ == "__main__":
    if not shutil.which("mpirun"):
        sys.exit(77)
    Parts.gluray, Parts.client = map(os.path.abspath, sys.argv[1:3])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
