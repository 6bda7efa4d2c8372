"""GLuRay in this process, and settings of programs that run under GLuRay.

    import gluray
    gluray.enable(ao=True)                  # before the first window: what this process draws is ray traced
    gluray.set(shadows=True)                # from the next frame on
    gluray.report()                         # what was traced, and what was not

Where this process was not enabled, the functions act on all programs that run under GLuRay:

    gluray.set(ao=True, ao_samples=16)
    p = gluray.programs()[0]
    p["ao.samples"] = 32
    with gluray.settings(shadows=True):     # for as long as the block lasts
        ...

Talks to the hub (docs/control-protocol.md): that of gluray panel or gluray hub, or, where none runs, `gluray hub` as a child process,
which ends with this one; $GLURAY is the path of the program gluray if it is not on the PATH. $GLURAY_HUB ("HOST:PORT") and
$GLURAY_HUB_KEY (a file), or connect(), name the hub of another machine.

Every failure is a GlurayError, whose text is one line. No call but watch() waits longer than some seconds
for the hub or a program.
"""
import contextlib
import json
import subprocess
import time

from . import hub as _hub
from . import inside as _inside
from . import several as _several
from .errors import GlurayError, HubError
from .hub import connect
from .inside import disable, enable, enabled, report, this_process
from .program import Program

# Not set and help: `from gluray import *` leaves Python's own alone.
__all__ = ["GlurayError", "HubError", "Program", "connect", "disable", "enable", "enabled", "preset", "programs", "redo", "report", "settings",
           "this_process", "undo", "watch"]


def programs(name=None):
    """The programs that run under GLuRay; with `name` those of that name. A list of Program, possibly empty."""
    return [p for p in _by_number(_hub.ask({"type": "list"})).values() if name is None or p.name == name]


def _by_number(message):
    """The programs of an answer or an event, by their numbers."""
    entries = message.get("programs")
    entries = entries if isinstance(entries, list) else []
    return {entry["program"]: Program(entry) for entry in entries if isinstance(entry, dict) and isinstance(entry.get("program"), int)}


def _some():
    """This process if enable() was called, else all programs."""
    if _inside.was_enabled():
        own = this_process()
        if own is None:
            raise GlurayError("this process has drawn nothing yet; until then, settings are those of enable() and set()")
        return [own]
    found = programs()
    if not found:
        raise GlurayError("no program runs under GLuRay; start one with: gluray PROGRAM")
    return found


def set(values=None, **more):
    """Changes settings: gluray.set(ao=True, **{"ao.samples": 16}). A value None: what the other layers say. Of this process if it was enabled,
    of all programs if not.

    Returns the first frames with the new values, by Program (see Program.set). Raises GlurayError if a program refuses; the
    others have changed then.
    """
    changes = {**(values or {}), **more}
    if _inside.change_before_window(changes):
        return {}
    found = _some()
    return _frames(found, *_several.set(found, changes))


def preset(name):
    """Applies a preset, as set()."""
    return set({"preset": name})


def undo():
    """Takes back the last change of settings, as set()."""
    found = _some()
    return _frames(found, *_several.ask([({"type": "undo"}, found)]))


def redo():
    """Makes the change again that was taken back last, as set()."""
    found = _some()
    return _frames(found, *_several.ask([({"type": "redo"}, found)]))


def _frames(programs, results, failures):
    _several.check(programs, failures)
    return {p: results[p].get("frame") for p in programs}


@contextlib.contextmanager
def settings(values=None, **more):
    """`with gluray.settings(ao=True):` settings as of set(), which get back what they had at the end."""
    found, changes = _some(), {**(values or {}), **more}
    before, failures = _several.values(found, list(changes))
    _several.check(found, failures)
    changed, failures = _several.set(found, changes)
    try:
        _several.check(found, failures)
        yield
    finally:
        _several.check(found, _several.give_back({p: before[p] for p in changed})[1])


def watch(what=("settings", "programs"), every=1.0, seconds=None):
    """Events as they come: dicts as docs/control-protocol.md (Events) says, with a Program or None as "program".

    `what`: of "settings", "programs", "state"; `every`: seconds between two events "state" of one program; ends after `seconds`
    (None: when the hub ends, which raises HubError, or the loop is left).
    """
    connection = _hub.another()
    try:
        # Observes before it asks for the programs, so that none is missed.
        connection.ask({"type": "observe", "program": "all", "what": list(what), "every": every})
        known = _by_number(connection.ask({"type": "list"}))
        end = None if seconds is None else time.monotonic() + seconds
        while end is None or time.monotonic() < end:
            event = connection.event(1.0 if end is None else max(0.0, min(1.0, end - time.monotonic())))
            if event is None:
                continue
            if event.get("what") == "programs":
                now = _by_number(event)
                known = {number: known.get(number, p) for number, p in now.items()}
                yield {"what": "programs", "programs": list(known.values())}
            else:
                number = event.get("program")
                rest = {name: value for name, value in event.items() if name not in ("type", "program")}
                yield {**rest, "program": known.get(number) if isinstance(number, int) else None}
    finally:
        connection.close()


def help(name):
    """Prints what a setting is, its unit, and the values that it takes."""
    try:
        found = programs()
    except GlurayError:
        found = []
    if found:
        name = found[0].resolve(name)
        row = found[0].describe().get(name)
        if row is None:
            found[0].why(name)  # raises with the nearest name
            raise GlurayError(f"no setting is called '{name}'")
    else:
        row = _row_of_executable(name)
    print(f"{row['name']} (default: {json.dumps(row.get('default'))})")
    if row.get("title"):  # programs of earlier versions have none
        print(f"  {row['title']} ({row.get('group')}, {row.get('level')})")
    print("  " + " ".join(f"{row.get('help', '')} {row.get('more', '')}".split()))
    for word in row.get("words") or []:
        if word.get("help"):
            print(f"    {word['word']}: {word['help']}")
    if row.get("values"):
        print(f"  Values: {row['values']}")


def _row_of_executable(name):
    program = _hub.executable()
    if not program:
        raise GlurayError("no program runs under GLuRay, and gluray is not on the PATH; set GLURAY to its path")
    try:
        done = subprocess.run([program, "get", "--json", name], capture_output=True, text=True, timeout=10)
        if done.returncode:
            raise GlurayError(done.stderr.strip().replace("gluray: ", "", 1))
        return json.loads(done.stdout)[0]
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        raise GlurayError(f"{program}: {error}") from None
