"""Programs that run under GLuRay, a hub and its clients, in a runtime directory of their own."""
import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

from support import programs

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "controls"))
from fake_programs import Peer, wait_for  # noqa: E402


class Program:
    """The client of tests/controls, which draws all the time, a frame in `period` milliseconds (0: as fast as it can)."""

    def __init__(self, place, period, *options):
        self.process = place.spawn([place.gluray, *options, "--", place.client, "always", str(period)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.pid = self.process.pid

    def count(self):
        """Frames since its start, and the seconds of its clock."""
        print("count", file=self.process.stdin, flush=True)
        frames, seconds = self.process.stdout.readline().split()
        return int(frames), float(seconds)

    def frame_ms(self, seconds):
        """Milliseconds of a frame, measured over so long."""
        frames, begin = self.count()
        time.sleep(seconds)
        more, end = self.count()
        return 1000 * (end - begin) / (more - frames)

    def threads(self):
        return len(os.listdir(f"/proc/{self.pid}/task"))

    def resident(self):
        """Bytes of memory."""
        return int(pathlib.Path(f"/proc/{self.pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def end(self):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close(), self.process.stdout.close()


class Place:
    """A runtime directory; `with` ends all that was started in it."""

    def __init__(self, build, display):
        self.gluray, self.panel = build / "apps" / "gluray" / "gluray", build / "apps" / "panel" / "gluray-panel"
        self.client = build / "tests" / "controls" / "client"
        programs.require(self.gluray, self.client)
        self.folder = tempfile.TemporaryDirectory(prefix="gluray-bench-")
        self.runtime = pathlib.Path(self.folder.name) / "run"
        plain = {k: v for k, v in os.environ.items() if not k.startswith("GLURAY_")}
        self.environment = plain | {"DISPLAY": display, "GLURAY_RUNTIME": str(self.runtime), "GLURAY_ENGINE": "always", "XDG_CONFIG_HOME": "/nowhere",
                                    "QT_QPA_PLATFORM": "xcb"}
        self.started = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in self.started:
            process.kill()
            process.wait()
        self.folder.cleanup()

    def spawn(self, words, **pipes):
        pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **pipes}
        self.started.append(subprocess.Popen([str(word) for word in words], env=self.environment, text=True, **pipes))
        return self.started[-1]

    def hub(self):
        hub = self.spawn([self.gluray, "hub"], stderr=subprocess.PIPE)
        if "listens" not in hub.stderr.readline():
            raise programs.Failed("gluray hub does not start")
        return hub

    def peer(self):
        return Peer(self.runtime)

    def numbers(self, count):
        """The numbers of the programs, when there are so many."""
        peer = self.peer()
        with contextlib.closing(peer):
            wait_for(lambda: len(peer.ask("list")["programs"]) == count)
            found = [program["program"] for program in peer.ask("list")["programs"]]
        if len(found) != count:
            raise programs.Failed(f"{len(found)} programs are connected to the hub, not {count}")
        return found

    def crowd(self, count, processes):
        """So many programs that only speak the protocol."""
        for _ in range(processes):
            crowd = self.spawn([sys.executable, ROOT / "tests/controls/fake_programs.py", self.runtime, count // processes],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE)
            crowd.stdout.readline()


@contextlib.contextmanager
def observed(place, every):
    """While the block runs, a client observes as the panel does."""
    peer = place.peer()
    peer.ask("observe", program="all", what=["programs", "settings", "state"], every=every)
    peer.socket.settimeout(0.1)
    ended = threading.Event()

    def read():
        while not ended.is_set():
            with contextlib.suppress(TimeoutError):
                peer.take()
    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    try:
        yield
    finally:
        ended.set()
        reader.join()
        peer.close()


def end_gently(process):
    process.send_signal(signal.SIGTERM)
    process.wait(20)


class Drag:
    """A slider that is moved, as in the panel: a request for the newest event every 25 ms, and one for the last; answers are not waited for."""
    PAUSE = 0.025  # seconds

    def __init__(self, place, program, gesture):
        self.peer, self.folder, self.program, self.gesture = place.peer(), place.runtime, program, gesture
        self.answered = {}  # seconds, by id
        self.sent = self.refused = self.most_waiting = 0
        self.ended = False
        self.peer.socket.settimeout(0.1)
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        while not self.ended:
            with contextlib.suppress(TimeoutError):
                for message in self.peer.take() or []:
                    if message["type"] == "answer":
                        self.refused += "why" in message or any("why" in one for one in message["results"])
                        self.answered[message["id"]] = time.perf_counter()

    def move(self, rate, seconds):
        """Seconds from the last event to its answer."""
        begin, last, requests, events = time.perf_counter(), 0, 0, int(rate * seconds)
        for number in range(events):
            time.sleep(max(0, begin + number / rate - time.perf_counter()))
            if number + 1 < events and time.perf_counter() < self.sent + self.PAUSE:
                continue
            last = self.peer.start("set", program=self.program, values={"ao.samples": number % 4000 + 1}, gesture=self.gesture)
            self.sent, requests = time.perf_counter(), requests + 1
            self.most_waiting = max(self.most_waiting, requests - len(self.answered))
        if not wait_for(lambda: last in self.answered):
            raise programs.Failed("a request got no answer")
        if self.value() != number % 4000 + 1:
            raise programs.Failed("the program does not have the last value of the slider")
        return self.answered[last] - self.sent

    def value(self):
        """What the program has."""
        with contextlib.closing(Peer(self.folder)) as peer:
            return peer.ask("get", program=self.program, names=["ao.samples"])["results"][0]["values"]["ao.samples"]["value"]

    def close(self):
        self.ended = True
        self.reader.join()
        self.peer.close()
