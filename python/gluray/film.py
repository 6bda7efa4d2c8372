"""Numbered images of the frames that a program shows."""
import math
import re
import time

from .errors import GlurayError
from .png import check_file, write_png

LATER_SECONDS = 10.0                     # for a frame later than the one before
PASSES_SECONDS = 60.0                    # for the passes of an image
BEGIN_SECONDS, STALL_SECONDS = 4.0, 10.0  # without a pass, after which none is expected: until the first one, and later


def file_names(name):
    """A function of numbers: the names that "turn-%04d.png" or "turn.png" stands for. Raises GlurayError."""
    name = str(name)
    if not name.endswith(".png") or re.search("(^|/)[.]png$", name):
        raise GlurayError(f"{name}: use a name that ends in .png, such as film-%04d.png")
    if "%" not in name:
        stem = name[:-len(".png")]
        return lambda number: f"{stem}{'' if stem[-1] in '-_' else '-'}{number:04}.png"
    found = re.fullmatch("([^%]*)%(0([1-9]))?d([^%]*)", name, re.DOTALL)
    if not found:
        raise GlurayError(f"{name}: use one %d or %04d for the number, and no other % in the name")
    before, digits, after = found[1], int(found[3] or 1), found[4]
    return lambda number: f"{before}{number:0{digits}}{after}"


def film(program, name, frames, every, ramps, passes, progress):
    """As Program.film() says."""
    names, ramps = file_names(name), _checked(program, frames, ramps or {})
    for number in range(1, frames + 1):
        check_file(names(number))
    if not ramps:
        return _shoot(program, names, frames, every, ramps, passes, progress)
    before = {setting: program.why(setting) for setting in ramps}
    with program.gesture():  # one step for undo
        try:
            return _shoot(program, names, frames, every, ramps, passes, progress)
        finally:
            program.set({setting: one["value"] if one.get("layer") == "live" else None for setting, one in before.items()})


def _checked(program, frames, ramps):
    """Ramps by the settings' own names: first and last value, and whether they are whole numbers."""
    if not isinstance(frames, int) or frames < 1:
        raise GlurayError(f"frames = {frames!r}: use a number from 1")
    checked, rows = {}, program.describe() if ramps else {}
    for setting, ends in ramps.items():
        setting = program.resolve(setting)
        numbers = isinstance(ends, (tuple, list)) and len(ends) == 2 and all(isinstance(end, (int, float)) and not isinstance(end, bool) and math.isfinite(end) for end in ends)
        now = program.get(setting)
        if not numbers or isinstance(now, bool) or not isinstance(now, (int, float)):
            raise GlurayError(f"{setting}: only settings that are one number can vary, from one number to another")
        checked[setting] = (*ends, rows.get(setting, {}).get("type") == "integer")
    return checked


def _value(first, last, whole, number, frames):
    value = first + (last - first) * ((number - 1) / (frames - 1) if frames > 1 else 0)
    return int(math.floor(value + 0.5)) if whole else value


def _shoot(program, names, frames, every, ramps, passes, progress):
    refined = _Refined(program, passes) if passes else None
    made, last, before = [], None, None
    due = time.monotonic()
    try:
        for number in range(1, frames + 1):
            time.sleep(max(0.0, due - time.monotonic()))
            due = max(due + (every or 0), time.monotonic())
            values = {setting: _value(*ramp, number, frames) for setting, ramp in ramps.items()}
            same, before = bool(ramps) and values == before, values
            first = program.set(values) if ramps and not same else None
            if refined and not same:
                refined.wait(first)
            last = _save_later(program, names(number), first, last)
            made.append(last)
            if progress and progress(number, frames) is False:
                break
    finally:
        if refined:
            refined.close()
    return made


def _save_later(program, file, least, last):
    """Saves a frame from `least` on that is later than `last`. Returns its number; None: not known."""
    end = time.monotonic() + LATER_SECONDS
    while True:
        shot, width, height = program._take_shot()
        frame = shot.get("frame")
        frame = frame if isinstance(frame, int) else None
        if frame is None or (frame >= (least or 0) and (last is None or frame > last)):
            write_png(file, width, height, program._rows_of(shot, width, height))
            return frame
        if time.monotonic() > end:
            raise GlurayError(f"{program.name} ({program.pid}): it shows no later frame")
        time.sleep(0.02)


class _Refined:
    """Waits until the program's image has passes."""

    def __init__(self, program, passes):
        values = {name: program.get(name) for name in ("refine.idle", "refine.passes", "noise")}
        if values["refine.idle"] is False:
            raise GlurayError(f"{program.name} ({program.pid}): passes needs refine.idle = true")
        most, noise = values["refine.passes"], values["noise"]
        self.passes, self.most, self.noise = passes, most if isinstance(most, int) else passes, noise if isinstance(noise, (int, float)) else 0
        self.connection = program._observe(["state"], 0.1)
        self.before = self._passes(self._state(1.0) or {})  # of the image that was shown

    def _state(self, seconds):
        event = self.connection.event(seconds)
        state = event.get("state") if event and event.get("what") == "state" else None
        return state if isinstance(state, dict) else None

    @staticmethod
    def _passes(state):
        return state["passes"] if isinstance(state.get("passes"), int) else 0

    def wait(self, frame):
        """Until the image of `frame` (None: the one that is shown) has the passes or is finished."""
        while self.connection.event(0):  # states of earlier moments
            pass
        begin = progress = time.monotonic()
        patience = BEGIN_SECONDS
        passes, own = self.before, frame is None or not self.before  # the state has the passes of the image before until the new one has some
        while time.monotonic() < min(begin + PASSES_SECONDS, progress + patience):
            state = self._state(0.2)
            if not state or not isinstance(state.get("frame", 0), int) or state.get("frame", 0) < (frame or 0):
                continue
            now = self._passes(state)
            if now != passes:
                own, progress, patience = True, time.monotonic(), STALL_SECONDS
            passes, noise = now, state.get("noise")
            finished = now >= self.most or (isinstance(noise, (int, float)) and noise <= self.noise)
            if own and now and (now >= self.passes or finished):
                break
        self.before = passes

    def close(self):
        self.connection.close()
