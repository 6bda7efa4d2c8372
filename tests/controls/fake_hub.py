"""A hub of the control protocol (docs/control-protocol.md) for one program, as tests want it."""
import json
import os
import select
import socket
import time

PATIENCE = 10  # seconds


class Hub:
    """Listens in `folder`, which is created; removes its socket when it is closed."""

    def __init__(self, folder):
        os.makedirs(folder, mode=0o700, exist_ok=True)
        self.path = os.path.join(folder, "hub.sock")
        self.listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.listener.bind(self.path)
        self.listener.listen(8)
        self.peer, self.bytes, self.ids, self.events, self.answers = None, b"", 0, [], {}

    def wait_for_program(self, patience=PATIENCE):
        """Whether one has connected; call it while the program draws."""
        if not select.select([self.listener], [], [], patience)[0]:
            return False
        self.peer, self.bytes = self.listener.accept()[0], b""
        return True

    def greet(self):
        """The program's hello."""
        self.tell({"type": "hello", "version": 1, "role": "hub", "pid": os.getpid(), "host": "test"})
        return self.message()

    def tell(self, message):
        self.peer.sendall(json.dumps(message).encode() + b"\n")

    def message(self, patience=PATIENCE):
        """The next message; None: the program has closed the connection."""
        until = time.monotonic() + patience
        while b"\n" not in self.bytes:
            if not select.select([self.peer], [], [], max(until - time.monotonic(), 0))[0]:
                raise TimeoutError("the program says nothing")
            try:
                got = self.peer.recv(1 << 16)
            except ConnectionResetError:
                got = b""
            if not got:
                return None
            self.bytes += got
        line, self.bytes = self.bytes.split(b"\n", 1)
        return json.loads(line)

    def start(self, type, **members):
        """Sends a request; returns its id."""
        self.ids += 1
        self.tell({"type": type, "id": self.ids, **members})
        return self.ids

    def result(self, id):
        """The answer's result, or the answer if it has `why`. Keeps events, and answers to earlier requests."""
        while id not in self.answers:
            message = self.message()
            if message["type"] == "event":
                self.events.append(message)
            else:
                assert message["type"] == "answer" and 0 < message["id"] <= self.ids, message
                self.answers[message["id"]] = message
        message = self.answers.pop(id)
        return message if "why" in message else (message["results"] or [{}])[0]

    def ask(self, type, **members):
        return self.result(self.start(type, **members))

    def event(self, what):
        while True:
            message = self.events.pop(0) if self.events else self.message()
            if message.get("what") == what:
                return message

    def hang_up(self):
        if self.peer:
            self.peer.close()
            self.peer = None

    def close(self):
        self.hang_up()
        self.listener.close()
        if os.path.exists(self.path):
            os.remove(self.path)
