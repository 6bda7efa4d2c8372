"""Many programs of the control protocol in one process, and a plain client: fake_programs.py FOLDER COUNT prints "ready" when all are
greeted, and lives until its standard input ends."""
import json
import os
import selectors
import socket
import sys
import threading
import time

PATIENCE = 30  # seconds


class Peer:
    """One connection to the hub in `folder`."""

    def __init__(self, folder, **hello):
        self.socket, self.bytes, self.ids = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM), b"", 0
        try:
            self.socket.connect(os.path.join(folder, "hub.sock"))
        except OSError:
            self.socket.close()
            raise
        self.tell(type="hello", version=1, **{"role": "client", **hello})

    def tell(self, **message):
        self.socket.sendall(json.dumps(message).encode() + b"\n")

    def take(self):
        """The messages that one read brings; None: the hub has closed the connection."""
        try:
            got = self.socket.recv(1 << 16)
        except ConnectionResetError:
            got = b""
        if not got:
            return None
        *lines, self.bytes = (self.bytes + got).split(b"\n")
        return [json.loads(line) for line in lines]

    def start(self, type, **members):
        """Sends a request; returns its id."""
        self.ids += 1
        self.tell(type=type, id=self.ids, **members)
        return self.ids

    def answer(self, id, patience=PATIENCE):
        """Waits for it; drops other messages. ConnectionError: the hub has ended."""
        self.socket.settimeout(patience)
        while (messages := self.take()) is not None:
            for message in messages:
                if message["type"] == "answer" and message["id"] == id:
                    return message
        raise ConnectionError("the hub has ended")

    def ask(self, type, **members):
        return self.answer(self.start(type, **members))

    def close(self):
        self.socket.close()


class FakePrograms:
    """`count` programs that answer requests, on a thread of their own."""

    def __init__(self, folder, count):
        self.selector, self.frame, self.ended, self.sets = selectors.DefaultSelector(), 0, False, 0
        self.peers = [Peer(folder, role="program", pid=os.getpid() * 1000 + i, host=socket.gethostname(), name=f"fake{i}") for i in range(count)]
        for peer in self.peers:
            self.selector.register(peer.socket, selectors.EVENT_READ, peer)
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        while not self.ended:
            for key, _ in self.selector.select(0.2):
                messages = key.data.take()
                if messages is None:
                    self.selector.unregister(key.fileobj)
                for message in messages or []:
                    self.reply(key.data, message)

    def reply(self, peer, message):
        if message["type"] in ("hello", "answer", "event", "error"):
            return
        self.frame += 1
        result = {"frame": self.frame, "values": message["values"]} if message["type"] == "set" else {}
        self.sets += message["type"] == "set"
        peer.tell(type="answer", id=message["id"], results=[result])

    def close(self):
        self.ended = True
        self.thread.join()
        for peer in self.peers:
            peer.close()


def wait_for(condition, patience=PATIENCE):
    """Its first true value; the last one where the time is over."""
    until = time.monotonic() + patience
    while not (value := condition()) and time.monotonic() < until:
        time.sleep(0.02)
    return value


if __name__ == "__main__":
    programs = FakePrograms(sys.argv[1], int(sys.argv[2]))
    print("ready", flush=True)
    sys.stdin.read()
    programs.close()
