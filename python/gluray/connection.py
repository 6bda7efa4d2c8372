"""A connection to the hub: docs/control-protocol.md, the role `client`. Every wait has a time limit."""
import collections
import hashlib
import hmac
import json
import os
import secrets
import select
import socket
import stat
import struct
import threading
import time
import weakref

from .errors import GlurayError, HubError

MOST_BYTES = 1 << 20  # of a message
MOST_EVENTS = 1000    # that wait to be taken; older ones are lost
LIST_SECONDS, ANSWER_SECONDS = 5.0, 12.0  # the second is more than the hub gives a program: then it says which one does not answer
MOST_SECONDS = 1e6    # of a wait: poll() counts milliseconds in 32 bits
OLD = 1e6             # seconds since hubs began that do not say it
NO_ANSWER = "the hub does not answer; end it, and start gluray hub"


def runtime_directory():
    """Where the hub's socket is."""
    if os.environ.get("GLURAY_RUNTIME"):
        return os.environ["GLURAY_RUNTIME"]
    if os.environ.get("XDG_RUNTIME_DIR"):
        return os.path.join(os.environ["XDG_RUNTIME_DIR"], "gluray")
    return f"/tmp/gluray-{os.getuid()}"


def key_of(file):
    """SHA-256 of a key file that only this user can read."""
    if not file:
        raise HubError("no key file is given; use gluray.connect(hub, key) or GLURAY_HUB_KEY")
    try:
        with open(file, "rb") as opened:
            status = os.fstat(opened.fileno())
            content = opened.read()
    except OSError as error:
        raise HubError(f"{file}: {error.strerror}") from None
    if stat.S_IMODE(status.st_mode) & 0o077 or status.st_uid != os.geteuid():
        raise HubError(f"{file}: others may read it, or it is not yours; run chmod 600 {file}")
    if len(content) < 32:
        raise HubError(f"{file}: a key has at least 32 bytes")
    return hashlib.sha256(content).digest()


class Connection:
    """Raises HubError with one line if it cannot connect within `seconds`. For one thread at a time; a forked child has none."""

    all = weakref.WeakSet()

    def __init__(self, hub="", key="", seconds=5.0):
        end = time.monotonic() + seconds
        Connection.all.add(self)
        self._buffer, self._events, self._id, self._socket = bytearray(), collections.deque(maxlen=MOST_EVENTS), 0, None
        try:
            if hub:
                secret = key_of(key)
                self._socket = self._connect_by_tcp(hub, seconds)
                self._prove(secret, end)
            else:
                self._socket = self._connect_here(seconds)
            self._send({"type": "hello", "version": 1, "role": "client"}, end)
            hello = self._receive(end)
        except BaseException:
            self.close()
            raise
        version = hello.get("version")
        if hello["type"] != "hello" or hello.get("role") != "hub" or not isinstance(version, int) or version < 1:
            self.close()
            raise HubError(_why(hello) if hello["type"] == "error" else "what listens there is no hub of GLuRay; end it, and start gluray hub")
        age, expected = hello.get("age"), hello.get("expected")
        self.began = time.monotonic() - (age if isinstance(age, (int, float)) and 0 <= age < OLD else OLD)
        self.expected = expected if isinstance(expected, int) else 0  # programs that run and had not connected
        self.tcp = hello.get("tcp") is True                           # programs of other machines may come, which it cannot expect

    def close(self):
        if self._socket:
            self._socket.close()
            self._socket = None

    def alive(self):
        """Whether the hub has not ended since the last request, as far as is known."""
        try:
            while self._socket and _ready(self._socket, select.POLLIN, 0) and len(self._buffer) < MOST_BYTES:
                got = self._socket.recv(1 << 16)
                if not got:
                    self.close()
                self._buffer += got
        except OSError:
            self.close()
        return self._socket is not None

    def ask(self, request, seconds=None):
        """The answer to a request. Raises GlurayError with the hub's reason, HubError if there is no answer in that time."""
        answer, = self.ask_all([request], seconds)
        if isinstance(answer, GlurayError):
            raise answer
        return answer

    def ask_all(self, requests, seconds=None):
        """The answers to requests that are sent at once, in their order; a GlurayError in the place of one that failed."""
        end = time.monotonic() + (seconds or (LIST_SECONDS if all(r["type"] == "list" for r in requests) else ANSWER_SECONDS))
        answers = {}  # by id; None: not yet here
        for request in requests:
            self._id += 1
            self._send({**request, "id": self._id}, end)
            answers[self._id] = None
        while None in answers.values():
            message = self._receive(end)
            if message["type"] == "event":
                self._events.append(message)
            elif message["type"] == "error":
                raise GlurayError(_why(message))
            elif message["type"] == "answer" and isinstance(message.get("id"), int) and message["id"] in answers:
                answers[message["id"]] = GlurayError(_why(message)) if "why" in message else message
        return list(answers.values())

    def event(self, seconds):
        """The next event; None if there is none in that time."""
        end = time.monotonic() + seconds
        while not self._events:
            if not self._wait(end, writing=False):
                return None
            message = self._receive(end + 1)
            if message["type"] == "event":
                self._events.append(message)
        return self._events.popleft()

    def _connect_here(self, seconds):
        directory = runtime_directory()
        try:
            status = os.lstat(directory)
        except OSError:
            raise HubError("no hub runs here; start gluray panel or gluray hub") from None
        if not stat.S_ISDIR(status.st_mode) or status.st_uid != os.geteuid() or stat.S_IMODE(status.st_mode) != 0o700:
            raise HubError(f"{directory} is not a directory of yours with mode 700; remove it")
        connected = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            connected.settimeout(seconds)
            connected.connect(os.path.join(directory, "hub.sock"))
            peer = connected.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
        except (FileNotFoundError, ConnectionRefusedError):
            connected.close()
            raise HubError("no hub runs here; start gluray panel or gluray hub") from None
        except OSError as error:
            connected.close()
            raise HubError(f"{directory}/hub.sock: {error}") from None
        if struct.unpack("3i", peer)[1] != os.geteuid():
            connected.close()
            raise HubError(f"the hub of {directory} belongs to another user")
        connected.setblocking(False)
        return connected

    @staticmethod
    def _connect_by_tcp(hub, seconds):
        host, sign, port = hub.rpartition(":")
        if not sign or not host or not port.isdigit():
            raise HubError(f"hub = {hub}: use HOST:PORT")
        end, connected = time.monotonic() + seconds, None
        for address in _addresses(hub, host.strip("[]"), int(port), seconds):
            try:
                connected = socket.create_connection(address, timeout=max(0.1, end - time.monotonic()))
                break
            except (OSError, OverflowError) as error:
                why = error
        if not connected:
            raise HubError(f"hub = {hub}: {why}")
        connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connected.setblocking(False)
        return connected

    def _prove(self, secret, end):
        challenge = self._receive(end)
        theirs, mine = challenge.get("nonce"), secrets.token_hex(32)
        if challenge["type"] != "challenge" or not isinstance(theirs, str) or len(theirs) != 64:
            raise HubError(_why(challenge) if challenge["type"] == "error" else "what listens there is no hub of GLuRay")

        def proof(word):
            return hmac.new(secret, f"gluray 1 {word} {theirs}{mine}".encode(), "sha256").hexdigest()

        self._send({"type": "proof", "nonce": mine, "mac": proof("peer")}, end)
        try:
            answer = self._receive(end)
        except HubError as error:
            raise HubError(f"{error}; do both sides have the same key file?") from None
        if not isinstance(answer.get("mac"), str) or not hmac.compare_digest(answer["mac"].encode(), proof("hub").encode()):
            raise HubError("the hub does not have the same key file")

    def _wait(self, end, writing):
        """Whether the socket is ready in time, or a whole line is there already."""
        if not self._socket:
            raise HubError("the connection to the hub ended")
        if not writing and b"\n" in self._buffer:
            return True
        return _ready(self._socket, select.POLLOUT if writing else select.POLLIN, end - time.monotonic())

    def _send(self, message, end):
        rest = memoryview(json.dumps(message, allow_nan=False, default=_plain).encode() + b"\n")
        if len(rest) > MOST_BYTES:
            raise GlurayError("the request is longer than 1 MiB")
        while rest:
            if not self._wait(end, writing=True):
                self._fail(NO_ANSWER)
            try:
                rest = rest[self._socket.send(rest, socket.MSG_NOSIGNAL):]
            except BlockingIOError:
                pass
            except OSError as error:
                self._fail(f"the connection to the hub ended: {error.strerror}")

    def _receive(self, end):
        """The next message: a dict with a text `type`."""
        while b"\n" not in self._buffer:
            if time.monotonic() >= end or not self._wait(end, writing=False):
                raise HubError(NO_ANSWER)
            try:
                got = self._socket.recv(1 << 16)
            except BlockingIOError:
                continue
            except OSError as error:
                self._fail(f"the connection to the hub ended: {error.strerror}")
            if not got:
                self._fail("the connection to the hub ended")
            self._buffer += got
            if len(self._buffer) > 2 * MOST_BYTES:
                self._fail("the hub sends a message longer than 1 MiB")
        line, _, rest = self._buffer.partition(b"\n")
        self._buffer = rest
        try:
            message = json.loads(line)
        except (ValueError, RecursionError):
            self._fail("what the hub sends is no message; end it, and start gluray hub")
        if not isinstance(message, dict) or not isinstance(message.get("type"), str):
            self._fail("what the hub sends is no message; end it, and start gluray hub")
        return message

    def _fail(self, why):
        self.close()
        raise HubError(why)


def _addresses(hub, host, port, seconds):
    """The host's addresses, at least one. A thread asks for them, because the system's look-up has no limit of time."""
    found = []

    def look():
        try:
            found.append([entry[4][:2] for entry in socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)])
        except (OSError, OverflowError, UnicodeError) as error:
            found.append(error)

    thread = threading.Thread(target=look, daemon=True)
    thread.start()
    thread.join(seconds)
    if not found or not isinstance(found[0], list):
        raise HubError(f"hub = {hub}: {found[0] if found else 'looking up the name takes too long'}")
    return found[0]


def _ready(waited, events, seconds):
    """Whether the socket is ready in time, or has failed. select() takes no descriptor above 1023, which ParaView has."""
    poll = select.poll()
    poll.register(waited, events)
    return bool(poll.poll(min(max(0.0, seconds), MOST_SECONDS) * 1000))  # rounds up to milliseconds


def _plain(value):
    """Values of numpy as Python's own."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r}")


def _why(message):
    why = message.get("why")
    return " ".join(why.split()) if isinstance(why, str) and why.strip() else "the hub refuses, and does not say why"
