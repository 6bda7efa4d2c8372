"""GLuRay in this process: enable() before the first window."""
import ctypes
import json
import os
import pathlib
import subprocess
import sys

from . import hub
from .errors import GlurayError
from .program import Program

_ENGINE = "libgluray-engine.so"
# Vendors that libglvnd has loaded: somebody has asked for a display, and what draws there is decided.
_VENDORS = ("libGLX_", "libEGL_")
_before = None   # the variables that enable() changed, with their values before; None: not enabled
_options = {}    # settings of enable() and of set() before the first window
_loaded = []     # libraries that this process keeps


def enable(values=None, quiet=False, **more):
    """Makes what this process draws from now on ray traced: gluray.enable(ao=True, **{"ao.samples": 16}).

    Call it before the first window of VTK, PyVista, vedo, f3d, pyqtgraph, moderngl ... opens. Settings are those of gluray.set(). Prints one line
    that says what it did, or why it could not, unless `quiet`. Returns whether the process is enabled; if not, the program draws as it would
    without GLuRay. Never raises but for settings that do not exist or have wrong values.
    """
    try:
        text = _enable({**(values or {}), **more})
        done = True
    except _NotPossible as why:
        text, done = f"not enabled: {why}", False
    if not quiet:
        print(f"gluray: {text}")
    return done


def disable(quiet=False):
    """Ends what enable() began. After the first window, the real OpenGL draws from the next frame on (engine = never). Returns
    whether anything had to be ended."""
    global _before
    if _before is None:
        return False
    program = this_process()
    if program:
        program.set({"engine": "never"})
    else:
        _restore()
    _before = None
    if not quiet:
        print("gluray: disabled" + ("; the real OpenGL draws from the next frame on" if program else ""))
    return True


def report():
    """What has been traced in this process, and why other draws were not, as a dict (that of gluray --report)."""
    program = this_process()
    if program is None:
        raise GlurayError("nothing has been drawn under GLuRay in this process; call gluray.enable() before the first window")
    return program.report()


def was_enabled():
    """Whether enable() was called, and not ended by disable()."""
    return _before is not None


def enabled():
    """Whether this process runs under GLuRay, by enable() or because gluray started it."""
    return _before is not None or this_process() is not None


class ThisProcess(Program):
    """The program that this process is. Settings act without a hub; shots, films and objects need another process (gluray.programs())."""

    in_process = True

    def __init__(self, engine):
        super().__init__({"name": os.path.basename(sys.argv[0] or "python"), "pid": os.getpid()})
        self._engine = engine

    def report(self):
        return self._ask({"type": "report"})

    def state(self, seconds=5.0):
        raise GlurayError("this process cannot watch itself; use gluray.report()")

    def _ask(self, request):
        try:
            text = json.dumps(request).encode()
        except (TypeError, ValueError) as error:
            raise GlurayError(f"a value is no boolean, number, text or list: {error}") from None
        answer = self._engine.glurayAsk(text)
        if not answer:
            raise GlurayError("there is no memory")
        try:
            result = json.loads(ctypes.string_at(answer))
        finally:
            self._engine.glurayForget(answer)
        if "why" in result:
            raise GlurayError(" ".join(str(result["why"]).split()))
        return result


def this_process():
    """This process as a ThisProcess, if the engine is loaded: it is from the first window on. Else None."""
    path = next((path for path in _mapped() if os.path.basename(path) == _ENGINE), None)
    if path is None:
        return None
    try:
        engine = ctypes.CDLL(path, mode=os.RTLD_NOLOAD | os.RTLD_NOW)
        engine.glurayAsk.argtypes, engine.glurayAsk.restype = [ctypes.c_char_p], ctypes.c_void_p
        engine.glurayForget.argtypes, engine.glurayForget.restype = [ctypes.c_void_p], None
    except (OSError, AttributeError):
        return None
    return ThisProcess(engine)


def change_before_window(values):
    """Settings for the first window. Returns whether this process is enabled and has none yet."""
    if _before is None or this_process() is not None:
        return False
    _apply({name: value for name, value in {**_options, **values}.items() if value is not None})
    return True


class _NotPossible(Exception):
    """str(): one line that says why this process cannot be enabled, and what to do."""


def _enable(values):
    global _before
    program = this_process()
    if program is not None:  # enabled before, or started by gluray
        changes = {"engine": "auto", **values} if _before is None and program.get("engine") == "never" else values
        if changes:
            program.set(changes)
        return "this process runs under it" + _words(values)
    if not sys.platform.startswith("linux"):
        raise _NotPossible("it works on Linux only")
    if late := [path for path in _mapped() if os.path.basename(path).startswith(_VENDORS) and "gluray" not in os.path.basename(path)]:
        raise _NotPossible(f"OpenGL is in use in this process ({os.path.basename(late[0])}); call it before the first window, or start anew with: "
                           "python -m gluray SCRIPT")
    _apply(values)
    return "what this process draws is ray traced" + _words(values)


def _words(values):
    return ", with " + ", ".join(f"{name}={_text(value)}" for name, value in values.items()) if values else ""


def _apply(values):
    """Sets the variables, as the launcher would, and loads the doors."""
    global _before, _options
    answer = _environment(values)
    if _before is not None:
        _restore()
    variables = {**answer["variables"], "GLURAY_PID": str(os.getpid()), "GLURAY_STREAMS": _streams(),
                 "GLURAY_PROGRAM": os.path.basename(sys.argv[0] or "python")}
    for path in answer["libraries"]:
        try:
            # For all: libglvnd then finds them by their names.
            _loaded.append(ctypes.CDLL(path, mode=os.RTLD_GLOBAL | os.RTLD_NOW))
        except OSError as error:
            if os.path.basename(path) != "libOSMesa.so.8":  # which needs libEGL.so.1 and libOpenGL.so.0
                raise _NotPossible(f"{error}; gluray doctor says what is missing") from None
    _before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    _options = dict(values)


def _restore():
    for name, value in (_before or {}).items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value


def _environment(values):
    """What gluray environment says for these settings."""
    program = hub.executable()
    if not program:
        raise _NotPossible("the program gluray is not on the PATH; set GLURAY to its path")
    options = [word for name, value in values.items() for word in ("--set", f"{_resolved(program, name, values)}={_text(value)}")]
    clean = {name: value for name, value in os.environ.items() if _before is None or name not in _before}
    clean |= {name: value for name, value in (_before or {}).items() if value is not None}
    try:
        done = subprocess.run([program, "environment", "--json", *options], capture_output=True, text=True, timeout=20, env=clean)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise _NotPossible(f"{program}: {error}") from None
    said = done.stderr.strip().removeprefix("gluray: ").splitlines()
    if done.returncode == 2 or (done.returncode == 0 and said and options):
        raise GlurayError(said[0].split("; see gluray --help")[0] if said else f"{program} refuses the settings")
    if done.returncode:
        raise _NotPossible(said[0] if said else f"{program} ended with {done.returncode}")
    return json.loads(done.stdout)


def _resolved(program, name, values):
    """ao_samples means ao.samples, as for gluray.set()."""
    if "_" not in name:
        return name
    done = subprocess.run([program, "settings", "--json"], capture_output=True, text=True, timeout=20)
    known = [row["name"] for row in json.loads(done.stdout)] if done.returncode == 0 else []
    same = [one for one in known if one.replace(".", "_").replace("-", "_") == name]
    if len(same) > 1:
        raise GlurayError(f"{name} may mean {' or '.join(same)}; use the setting's own name")
    return same[0] if same else name


def _text(value):
    """A value as files and options write it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, (list, tuple)):
        return ",".join(map(_text, value))
    return str(value)


def _streams():
    """Identities of standard output and standard error (src/base/guarded_write.h)."""
    words = []
    for number in (1, 2):
        try:
            status = os.fstat(number)
            words.append(f"{status.st_dev:x}.{status.st_ino:x}")
        except OSError:
            words.append("-")
    return " ".join(words)


def _mapped():
    """Paths of the files that this process has mapped."""
    try:
        lines = pathlib.Path("/proc/self/maps").read_text(errors="replace").splitlines()
    except OSError:
        return []
    return list(dict.fromkeys(line.split(maxsplit=5)[5] for line in lines if "/" in line and len(line.split(maxsplit=5)) == 6))
