"""The hub of this process: the one that runs, or `gluray hub` as a child process, which ends with this one."""
import atexit
import os
import shutil
import subprocess
import threading
import time

from .connection import Connection
from .errors import HubError

_lock = threading.RLock()
_address = ("", "")        # "HOST:PORT" and key file; empty: this machine
_connection = _child = None
_owner = 0                 # process of the connection: a fork does not share it
generation = 0             # of connections


def connect(hub="", key=""):
    """Uses the hub at "HOST:PORT", with the key file, from now on; without arguments that of this machine. Raises HubError."""
    global _address
    with _lock:
        _drop()
        _address = (hub, key)
        _connected()


def ask(request, of=None):
    """The hub's answer; connects first. Raises GlurayError. `of`: the generation whose numbers the request has."""
    with _lock:
        connection = _connected()
        if of is not None and of != generation:
            raise HubError("another hub runs since a moment ago; ask again")
        try:
            return connection.ask(request)
        except HubError:
            _drop()
            raise


def ensure():
    """Connects if there is no connection. Returns its generation: numbers of programs hold for one hub."""
    with _lock:
        _connected()
        return generation


def another():
    """A connection of its own, for events. Raises HubError."""
    with _lock:
        _connected()
        return Connection(*_where())


def executable():
    """The program gluray: $GLURAY, or the one on the PATH; None: there is none."""
    return os.environ.get("GLURAY") or shutil.which("gluray")


def _where():
    return (_address[0] or os.environ.get("GLURAY_HUB", ""), _address[1] or os.environ.get("GLURAY_HUB_KEY", ""))


def _connected():
    global _connection, _owner, generation
    if _connection is None or _owner != os.getpid() or not _connection.alive():
        _drop()
        hub, key = _where()
        try:
            _connection = Connection(hub, key)
        except HubError as error:
            if hub or "no hub runs here" not in str(error):
                raise
            _connection = _with_own_hub(error)
        _owner, generation = os.getpid(), generation + 1
    return _connection


def _drop():
    global _connection
    if _connection and _owner == os.getpid():
        _connection.close()
    _connection = None


def _with_own_hub(error):
    global _child
    program = executable()
    if not program:
        raise HubError(f"{error}, or set GLURAY to the path of the program gluray") from None
    try:
        # The system closes the pipe to its input when this process ends, however it ends. In a session of its own no Ctrl+C reaches it.
        _child = subprocess.Popen([program, "hub", "--with-parent"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, bufsize=0, start_new_session=True)
    except OSError as problem:
        raise HubError(f"{program}: {problem.strerror}; set GLURAY to the path of the program gluray") from None
    atexit.register(_end, _child, os.getpid())
    end = time.monotonic() + 5
    while True:
        try:
            connection = Connection(seconds=max(0.1, end - time.monotonic()))
            break
        except HubError:
            ended = _child.poll() is not None
            if ended or time.monotonic() > end:
                _end(_child, os.getpid())
                said = (_child.stderr.read() or b"").decode(errors="replace").strip().splitlines()
                raise HubError(said[-1] if said else f"{program} hub does not start") from None
            time.sleep(0.02)
    threading.Thread(target=_child.stderr.read, daemon=True).start()  # a full pipe would stop it
    _settle(connection)
    return connection


def _settle(connection):
    """Gives programs a second to find the new hub: they look for one when a frame begins, at most every 50 ms."""
    end, before = time.monotonic() + 1, None
    while time.monotonic() < end:
        time.sleep(0.15)
        now = connection.ask({"type": "list"}).get("programs")
        if now and now == before:
            return
        before = now


def _end(child, owner):
    if os.getpid() != owner or child.poll() is not None:
        return
    child.terminate()
    try:
        child.wait(2)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait(2)
