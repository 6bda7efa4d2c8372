"""A hub for tests of its clients, and a program for tests of hubs, after docs/control-protocol.md; programs exist in memory only.

    with FakeHub(directory) as hub:
        paraview = hub.add("paraview", pid=4242)

`paraview` is a FakeProgram: its settings, the frame that it is at, and what it refuses can be changed. hub.instead maps types of requests to
what the hub does instead of answering: "silence", "garbage", "end", or a message. seek_hub() lets a FakeProgram talk to a real hub.
"""
import base64
import hashlib
import hmac
import json
import os
import pathlib
import secrets
import socket
import subprocess
import threading

from fake_scene import FakeScene

IMAGE = bytes(range(45))  # RGB bytes of every program's image


def image_of(file):
    """Width, height and RGB bytes of a PNG file, as ImageMagick reads it."""
    size = subprocess.run(["identify", "-format", "%w %h", str(file)], check=True, capture_output=True, text=True, timeout=30).stdout
    rgb = subprocess.run(["convert", str(file), "-depth", "8", "rgb:-"], check=True, capture_output=True, timeout=30).stdout
    return (*map(int, size.split()), rgb)


def line_of(message):
    return json.dumps(message).encode() + b"\n"


class FakeProgram:
    def __init__(self, number, name, pid, rows):
        self.entry = {"program": number, "pid": pid, "host": socket.gethostname(), "name": name, "ranks": 1, "version": 1, "since": 1764000000.5}
        self.rows = {row["name"]: row for row in rows}
        self.live, self.steps, self.undone = {}, [], []  # steps: the layer before and after, and the gesture
        self.frame = 1042
        self.refuses = {}  # by name of a setting: why
        self.silent = ()   # types of requests that seek_hub() does not answer
        self.no_image = ""  # why it has none
        self.scene, self.calls = FakeScene(), []  # what it draws; the calls that came
        self.draws = 0  # frames that it draws for each shot

    def described(self, name):
        row = self.rows[name]
        if name in self.live:
            return {"value": self.live[name], "layer": "live", "place": ""}
        return {"value": row["value"], "layer": row["layer"], "place": row["place"]}

    def layers(self, name):
        return [{"layer": "built-in", "value": self.rows[name]["default"], "place": ""}, {"layer": "live", "value": self.live.get(name), "place": ""}]

    def get(self, request):
        names = request.get("names") or list(self.rows)
        for name in names:
            if name not in self.rows:
                return {"why": f"no setting is called '{name}'"}
        layers = request.get("layers")
        return {"values": {n: self.described(n) | ({"layers": self.layers(n)} if layers else {}) for n in names}}

    def changed(self, before, after):
        names = {n for n in {**before, **after} if before.get(n) != after.get(n)}
        self.live = after
        return {n: self.described(n)["value"] for n in sorted(names)}

    def set(self, request):
        values = request["values"]
        for name in values:
            if name in self.refuses or name not in self.rows:
                return {"why": self.refuses.get(name, f"no setting is called '{name}'")}
        before, after = self.live, {n: v for n, v in {**self.live, **values}.items() if v is not None}
        gesture = request.get("gesture")
        if gesture and self.steps and self.steps[-1][2] == gesture:
            self.steps[-1] = (self.steps[-1][0], after, gesture)
        else:
            self.steps.append((before, after, gesture))
        self.undone.clear()
        self.changed(before, after)
        return {"frame": self.frame, "values": {n: self.described(n)["value"] for n in values}}

    def step(self, source, target, side):
        if not source:
            return {"why": "there is nothing to undo" if side == 0 else "there is nothing to redo"}
        step = source.pop()
        target.append(step)
        return {"frame": self.frame, "values": self.changed(self.live, step[side])}

    def undo(self, _):
        return self.step(self.steps, self.undone, 0)

    def redo(self, _):
        return self.step(self.undone, self.steps, 1)

    def call(self, request):
        """What it draws; shot and pixels of an image of 5 x 3, two rows at a time."""
        name, arguments = request["name"], request["arguments"]
        self.calls.append((name, arguments))
        if (found := self.scene.call(name, arguments, self.frame)) is not None:
            return found
        if self.no_image:
            return {"why": self.no_image}
        if name == "shot":
            self.frame = self.frame and self.frame + self.draws
            return {"value": {"shot": 4, "width": 5, "height": 3, "frame": self.frame}}
        row, rows = arguments["row"], min(2, 3 - arguments["row"])
        assert name == "pixels" and arguments["shot"] == 4, request
        return {"value": {"row": row, "rows": rows, "pixels": base64.b64encode(IMAGE[15 * row:15 * (row + rows)]).decode()}}

    def describe(self, _):
        return {"settings": list(self.rows.values())}


class FakeHub:
    def __init__(self, directory, rows=(), key=None, hello=None):
        """`key`: listens by TCP on self.address instead, and asks for proofs of these bytes; `hello`: instead of its own."""
        self.rows, self.programs, self.instead, self.observers, self.requests = list(rows), {}, {}, [], []
        self.hello = hello or {"type": "hello", "version": 1, "role": "hub", "pid": os.getpid(), "host": "here"}
        self.key, self.lock, self.number = key and hashlib.sha256(key).digest(), threading.RLock(), 0
        self.ending, self.path = threading.RLock(), None
        if key:
            self.listener = socket.create_server(("127.0.0.1", 0))
            self.address = "127.0.0.1:%d" % self.listener.getsockname()[1]
        else:
            directory = pathlib.Path(directory)
            directory.mkdir(mode=0o700, exist_ok=True)
            self.listener = socket.socket(socket.AF_UNIX)
            self.path = directory / "hub.sock"
            self.listener.bind(str(self.path))
            self.listener.listen()
        self.connections = []
        threading.Thread(target=self.accept, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self):
        """Removes the socket and closes everything, as the end of a hub does."""
        with self.ending:
            if self.path:
                self.path.unlink(missing_ok=True)
            self.path = None
            for one in [self.listener, *self.connections]:
                try:
                    one.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass
                one.close()

    def add(self, name, pid):
        with self.lock:
            self.number += 1
            program = self.programs[self.number] = FakeProgram(self.number, name, pid, self.rows)
            self.tell(self.programs_event())
        return program

    def remove(self, program):
        with self.lock:
            del self.programs[program.entry["program"]]
            self.tell(self.programs_event())

    def programs_event(self):
        return {"type": "event", "what": "programs", "programs": [p.entry for p in self.programs.values()]}

    def tell(self, event):
        """Sends an event to the clients that observe it."""
        for connection, observed in list(self.observers):
            if event["what"] in observed:
                try:
                    connection.sendall(line_of(event))
                except OSError:
                    self.observers.remove((connection, observed))

    def accept(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            self.connections.append(connection)
            threading.Thread(target=self.serve, args=[connection], daemon=True).start()

    def serve(self, connection):
        try:
            lines = connection.makefile("rb")
            if self.key and not self.trust(connection, lines):
                return connection.close()
            connection.sendall(self.hello if isinstance(self.hello, bytes) else line_of(self.hello))
            for line in lines:
                message = json.loads(line)
                if message["type"] not in ("hello", "error"):
                    with self.lock:
                        self.take(connection, message)
        except OSError:
            pass

    def trust(self, connection, lines):
        nonce = secrets.token_hex(32)
        connection.sendall(line_of({"type": "challenge", "nonce": nonce}))
        proof = json.loads(lines.readline() or b"{}")
        prove = lambda word: hmac.new(self.key, f"gluray 1 {word} {nonce}{proof.get('nonce')}".encode(), "sha256").hexdigest()
        if proof.get("mac") != prove("peer"):
            return False
        connection.sendall(line_of({"type": "proof", "mac": prove("hub")}))
        return True

    def take(self, connection, request):
        self.requests.append(request)
        instead = self.instead.get(request["type"])
        if instead == "end":
            return self.end()
        if instead == "garbage":
            return connection.sendall(b"\xff{]\n")
        if isinstance(instead, dict):
            return connection.sendall(line_of({"type": "answer", "id": request["id"]} | instead))
        if not instead:
            connection.sendall(line_of({"type": "answer", "id": request["id"]} | self.answer(connection, request)))

    def answer(self, connection, request):
        kind = request["type"]
        if kind == "list":
            return {"programs": [p.entry for p in self.programs.values()]}
        wanted = request["program"]
        numbers = list(self.programs) if wanted == "all" else wanted if isinstance(wanted, list) else [wanted]
        for number in numbers:
            if number not in self.programs:
                return {"why": f"no program has number {number}; gluray list shows them"}
        if kind == "observe":
            self.observers = [(c, what) for c, what in self.observers if c is not connection] + [(connection, request["what"])]
            for number in numbers if "settings" in request["what"] else []:
                program = self.programs[number]
                self.tell_settings(program, [n for n, row in program.rows.items() if program.described(n)["value"] != row["default"]])
            return {"results": []}
        results = []
        for number in numbers:
            program = self.programs[number]
            result = getattr(program, kind)(request)
            results.append({"program": number} | result)
            if kind in ("set", "undo", "redo") and "values" in result:
                self.tell_settings(program, result["values"])
        return {"results": results}

    def tell_settings(self, program, names):
        self.tell({"type": "event", "what": "settings", "program": program.entry["program"],
                   "values": {n: program.described(n) for n in names}, "undo": len(program.steps), "redo": len(program.undone)})


def seek_hub(program, directory):
    """Does what a program does: looks for a hub, says hello, answers until the hub ends, and looks again. Returns a function that ends it."""
    ended, connections = threading.Event(), []

    def talk():
        with socket.socket(socket.AF_UNIX) as connection:
            connection.connect(str(pathlib.Path(directory) / "hub.sock"))
            connections.append(connection)
            answer(connection)

    def answer(connection):
        hello = {name: program.entry[name] for name in ("pid", "host", "name", "ranks")}
        connection.sendall(line_of({"type": "hello", "version": 1, "role": "program", "rank": 0, "job": ""} | hello))
        for line in connection.makefile("rb"):
            request = json.loads(line)
            if request["type"] in program.silent:
                continue
            if request["type"] in ("get", "set", "undo", "redo", "describe", "call"):
                connection.sendall(line_of({"type": "answer", "id": request["id"], "results": [getattr(program, request["type"])(request)]}))
            elif request["type"] == "observe":
                connection.sendall(line_of({"type": "answer", "id": request["id"], "results": []}))

    def look():
        while not ended.wait(0.05):
            try:
                talk()
            except OSError:
                pass

    def end():
        ended.set()
        for connection in connections:
            try:
                connection.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
        thread.join(10)

    thread = threading.Thread(target=look, daemon=True)
    thread.start()
    return end
