"""One program that runs under GLuRay."""
import base64
import contextlib
import secrets
import time

from . import hub
from .drawn import Drawn
from .errors import GlurayError
from .film import film
from .png import check_file, write_png

MOST_SIDE = 1 << 15  # pixels of an image
MEASURED = 1.1  # seconds: the rates of a program's state are over the last one


class Program(Drawn):
    """A program that runs under GLuRay: `name`, `pid`, `host`, `ranks` (of an MPI job), `since` (seconds since 1970).

    p["ao.samples"] reads and writes a setting. Methods raise GlurayError, whose text is one line that says what to do.
    """

    in_process = False  # whether it is this process (inside.py)

    def __init__(self, entry):
        self._take(entry)
        self._names, self._gesture = None, None

    def _take(self, entry):
        self._entry, self._generation = entry, hub.generation
        self.name, self.pid, self.host = str(entry.get("name", "")), entry.get("pid"), str(entry.get("host", ""))
        self.ranks, self.since = entry.get("ranks", 1), entry.get("since", 0)

    def __repr__(self):
        return f"<gluray.Program {self.name} ({self.pid})>"

    def __eq__(self, other):
        return isinstance(other, Program) and (self.pid, self.host, self.name) == (other.pid, other.host, other.name)

    def __hash__(self):
        return hash((self.pid, self.host, self.name))

    # Settings

    def get(self, name):
        """The value of a setting: a bool, number, text or list."""
        return self.why(name)["value"]

    def why(self, name):
        """{"value": ..., "layer": "live", "place": ""}: a setting's value and what it comes from."""
        name = self.resolve(name)
        found = self._ask({"type": "get", "names": [name]}).get("values")
        if not isinstance(found, dict) or not isinstance(found.get(name), dict) or "value" not in found[name]:
            raise GlurayError(f"{self.name} ({self.pid}): {name}: it does not answer")
        return found[name]

    def settings(self):
        """The values of all settings, by name."""
        found = self._ask({"type": "get", "names": []}).get("values")
        return {name: one.get("value") for name, one in sorted(found.items()) if isinstance(one, dict)} if isinstance(found, dict) else {}

    def set(self, values=None, **more):
        """Changes settings, all or none: p.set({"ao.samples": 16}), p.set(ao=True, ao_samples=16).

        A value None gives the setting what files, variables ... say. Returns the number of the first frame with the new values,
        counted from the program's first; None if it draws nothing now: they count from its next frame.
        """
        changes = {self.resolve(name): value for name, value in {**(values or {}), **more}.items()}
        request = {"type": "set", "values": changes}
        if self._gesture:
            request["gesture"] = self._gesture
        return self._ask(request).get("frame")

    def __getitem__(self, name):
        return self.get(name)

    def __setitem__(self, name, value):
        self.set({name: value})

    def preset(self, name):
        """Applies a preset by its name, or "none". Returns as set()."""
        return self.set({"preset": name})

    def undo(self):
        """Takes back the last change of settings by any client. Returns the first frame without it, as set()."""
        return self._ask({"type": "undo"}).get("frame")

    def redo(self):
        """Makes the change again that was taken back last. Returns as set()."""
        return self._ask({"type": "redo"}).get("frame")

    @contextlib.contextmanager
    def gesture(self):
        """`with p.gesture():` all changes inside are undone together."""
        outer, self._gesture = self._gesture, self._gesture or secrets.token_hex(8)
        try:
            yield self
        finally:
            self._gesture = outer

    @contextlib.contextmanager
    def changed(self, values=None, **more):
        """`with p.changed(ao=True):` the settings get back what they had at the end."""
        names = [self.resolve(name) for name in {**(values or {}), **more}]
        before = {name: self.why(name) for name in names}
        self.set(values, **more)
        try:
            yield self
        finally:
            self.set({name: one["value"] if one.get("layer") == "live" else None for name, one in before.items()})

    def describe(self):
        """What is to be known of each setting, by name: type, default, least, most, words, unit, help ..."""
        return self._rows(self._ask({"type": "describe"}))

    @staticmethod
    def _rows(result):
        rows = result.get("settings")
        return {row["name"]: row for row in (rows if isinstance(rows, list) else []) if isinstance(row, dict) and isinstance(row.get("name"), str)}

    def resolve(self, name):
        """The setting that a name means: "ao.samples" itself, or ao_samples, if only one setting's name is spelt so."""
        if not isinstance(name, str):
            raise GlurayError(f"{name!r} is no name of a setting")
        if "_" not in name:
            return name
        if self._names is None:
            self._take_names(self._ask({"type": "describe"}))
        same = [known for known in self._names if known.replace(".", "_").replace("-", "_") == name]
        if name in self._names or not same:
            return name
        if len(same) > 1:
            raise GlurayError(f"{name} may mean {' or '.join(same)}; use the setting's own name")
        return same[0]

    def _take_names(self, result):
        self._names = list(self._rows(result))

    # State

    def state(self, seconds=5.0):
        """What the program does, as a dict: frame, fps (frames a second), triangles, traced (share, 0 to 1), memory (bytes),
        noise, passes, windows, opengl, warnings ... (docs/control-protocol.md, Events). Takes a second, over which rates are measured;
        raises GlurayError if the program tells nothing within `seconds`."""
        connection = self._observe(["state"], 0.1, seconds)
        try:
            begin, newest = time.monotonic(), None
            while time.monotonic() < begin + (seconds if newest is None else min(MEASURED, seconds)):
                event = connection.event(0.1)
                if event and event.get("what") == "state" and isinstance(event.get("state"), dict):
                    newest = event["state"]
            if newest is not None:
                return newest
        finally:
            connection.close()
        raise GlurayError(f"{self.name} ({self.pid}): it does not tell its state")

    def _observe(self, what, every, seconds=None):
        """A connection of its own with events of the program. Raises GlurayError."""
        connection = hub.another()
        try:
            connection.ask({"type": "observe", "program": self._number(), "what": what, "every": every}, seconds)
        except BaseException:
            connection.close()
            raise
        return connection

    # Images

    def shot(self, file):
        """Saves the image that the program's window shows as PNG. Replaces PNG files, no others. Returns (width, height).

        A program that draws nothing is asked to draw; raises GlurayError if it shows no frame within eight seconds.
        """
        check_file(file)
        shot, width, height = self._take_shot()
        write_png(file, width, height, self._rows_of(shot, width, height))
        return width, height

    def film(self, name, frames, every=None, set=None, passes=None, progress=None):
        """Saves the next frames that its window shows as numbered PNG files, each of a later frame than the one before.

        `name`: "turn-%04d.png", or "turn.png" for turn-0001.png ...; `every`: seconds between images (None: as fast as frames come);
        `set`: settings that vary from image to image, {"lights.azimuth": (0, 90)}, which get back what they had, in one step for undo;
        `passes`: waits until each image has been refined so often or is finished, for a minute at most; `progress`: called with
        (done, of) after each image, ends the film by returning False. Returns the numbers of the frames, None where one is not known.
        """
        return film(self, name, frames, every, set, passes, progress)

    def _take_shot(self):
        """A shot that the program keeps for some seconds, its width and height. Raises GlurayError."""
        shot = self._call("shot", {})
        width, height = shot.get("width"), shot.get("height")
        if not all(isinstance(side, int) and 0 < side <= MOST_SIDE for side in (width, height)):
            raise GlurayError(f"{self.name} ({self.pid}): it sends no image")
        return shot, width, height

    def _rows_of(self, shot, width, height):
        """The RGB bytes of a shot, the top row first. Raises GlurayError."""
        rows = bytearray()
        while len(rows) < 3 * width * height:
            piece = self._call("pixels", {"shot": shot.get("shot"), "row": len(rows) // (3 * width)})
            try:
                pixels = base64.b64decode(piece.get("pixels"), validate=True)
            except (TypeError, ValueError):
                break
            if not pixels or len(pixels) % (3 * width):
                break
            rows += pixels
        if len(rows) != 3 * width * height:
            raise GlurayError(f"{self.name} ({self.pid}): it sends no image")
        return bytes(rows)

    def _call(self, name, arguments):
        value = self._ask({"type": "call", "name": name, "arguments": arguments}).get("value")
        return value if isinstance(value, dict) else {}

    def _number(self):
        """Its number at the present hub. Raises GlurayError if the program has ended."""
        if self._generation != hub.ensure():
            answer = hub.ask({"type": "list"})
            for entry in answer.get("programs") or []:
                if isinstance(entry, dict) and (entry.get("pid"), entry.get("host")) == (self.pid, self.host):
                    self._take(entry)
                    break
            else:
                raise GlurayError(f"{self.name} ({self.pid}): it has ended")
        return self._entry.get("program")

    def _ask(self, request):
        number = self._number()
        try:
            answer = hub.ask({**request, "program": number}, of=self._generation)
        except (TypeError, ValueError) as error:
            raise GlurayError(f"a value is no boolean, number, text or list: {error}") from None
        return self._result(answer, number)

    def _result(self, answer, number):
        """Its result in an answer. Raises GlurayError if it failed."""
        results = answer.get("results")
        for result in results if isinstance(results, list) else []:
            if isinstance(result, dict) and result.get("program") == number:
                if "why" in result:
                    raise GlurayError(f"{self.name} ({self.pid}): {' '.join(str(result['why']).split())}")
                return result
        raise GlurayError(f"{self.name} ({self.pid}): it does not answer")
