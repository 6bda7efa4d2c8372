"""The hub of this process: the one that runs, or `gluray hub` as a child process, which ends with this one."""
import atexit
import os
import pathlib
import shutil
import subprocess
import threading
import time

from .connection import Connection
from .errors import GlurayError, HubError

_lock = threading.RLock()
_address = ("", "")        # "HOST:PORT" and key file; empty: this machine
_connection = _child = None
generation = 0             # of connections
# How old a hub is from which on programs are not waited for: at first; while none is there, but it expects some; while none is there, but some may
# come from other machines.
YOUNG_SECONDS, EXPECTED_SECONDS, FAR_SECONDS = 1.0, 5.0, 9.0
LATE = 0.5                 # seconds from taking the hub's lock to listening, at most


def connect(hub="", key=""):
    """Uses the hub at "HOST:PORT", with the key file, from now on; without arguments that of this machine. Raises HubError."""
    global _address
    with _lock:
        _drop()
        _address = (hub, key)
        _connected()


def ask(request, of=None):
    """The hub's answer; connects first. Raises GlurayError. `of`: the generation whose numbers the request has."""
    answer, = ask_all([request], of)
    if isinstance(answer, GlurayError):
        raise answer
    return answer


def ask_all(requests, of=None):
    """As ask(), for requests that are sent at once: their answers, in their order; a GlurayError in the place of one that failed."""
    with _lock:
        connection = _connected()
        if of is not None and of != generation:
            raise HubError("another hub runs since a moment ago; ask again")
        try:
            return connection.ask_all(requests)
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
    """The program gluray: $GLURAY, that of the installation which this module is part of, or the one on the PATH; None: there is none."""
    return os.environ.get("GLURAY") or _installed() or shutil.which("gluray")


def _installed():
    """PREFIX/bin/gluray of PREFIX/lib/python3/dist-packages/gluray and the like."""
    for folder in pathlib.Path(__file__).resolve().parents:
        if (folder / "lib/gluray/libgluray-engine.so").exists():
            return str(folder / "bin/gluray")
    return None


def _where():
    return (_address[0] or os.environ.get("GLURAY_HUB", ""), _address[1] or os.environ.get("GLURAY_HUB_KEY", ""))


def _connected():
    global _connection, generation
    if _connection is None or not _connection.alive():
        _drop()
        hub, key = _where()
        try:
            _connection = Connection(hub, key)
        except HubError as error:
            if hub or "no hub runs here" not in str(error):
                raise
            _connection = _with_own_hub(error)
        _settle(_connection)
        generation += 1
    return _connection


def _drop():
    global _connection
    if _connection:
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
    end, ended = time.monotonic() + 5, False
    while True:
        try:
            connection = Connection(seconds=max(0.1, end - time.monotonic()))
            break
        except HubError:
            if time.monotonic() > end:
                _end(_child, os.getpid())
                said = (_child.stderr.read() or b"").decode(errors="replace").strip().splitlines()
                raise HubError(said[-1] if said else f"{program} hub does not start") from None
            if not ended and _child.poll() is not None:  # perhaps because another process was first: its hub will listen soon
                ended, end = True, min(end, time.monotonic() + LATE)
            time.sleep(0.02)
    threading.Thread(target=_empty, args=[_child.stderr], daemon=True).start()
    return connection


def _empty(pipe):
    """Reads what nobody wants: a full pipe would stop the hub."""
    while pipe.read(1 << 12):
        pass


def _settle(connection):
    """Gives programs time to find a new hub: they look for one when a frame begins, at most every 50 ms. As apps/gluray/control/hub_session.cpp."""
    before, expected = None, connection.expected
    while (age := time.monotonic() - connection.began) < FAR_SECONDS:
        now = connection.ask({"type": "list"}).get("programs")
        if now and now == before and not expected:
            return
        before = now
        if age >= (YOUNG_SECONDS if now else FAR_SECONDS if connection.tcp else EXPECTED_SECONDS if expected else YOUNG_SECONDS):
            return
        time.sleep(0.15)
        try:
            probe = Connection(*_where())  # each hello says it anew
            expected = probe.expected
            probe.close()
        except HubError:
            return


def _end(child, owner):
    if os.getpid() != owner or child.poll() is not None:
        return
    child.terminate()
    try:
        child.wait(2)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait(2)


def _forked():
    """A child has no connection, is no parent of the hub, and holds no lock that a thread of its parent had."""
    global _lock, _connection, _child
    _lock = threading.RLock()
    for connection in list(Connection.all):
        connection.close()
    _connection = None
    if _child:  # whose input must end with the parent
        _child.stdin.close(), _child.stderr.close()
    _child = None


os.register_at_fork(after_in_child=_forked)
