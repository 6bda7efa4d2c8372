"""settings of running programs: time until they are applied, and what a program pays for it

A small program (tests/controls/client.c, 160x120) draws all the time. Measures the time from a client's request to the answer, which comes when
a frame with the value begins; the same with 200 programs that only speak the protocol; what a program costs before there is a hub, and its frame
time while a client observes it as the panel does; a slider that moves faster than the program draws; and the panel's start. What is
compared is measured in turn; figures are medians. They go to bench/results/NAME.json.
"""
import contextlib
import pathlib
import shlex
import statistics
import subprocess
import time

from support import machine, running
from support.display import display
from support.map_time import Maps
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RATES = {"60 fps": 1000 / 60, "full speed": 0}  # programs, and milliseconds of their frames
CROWD, CROWD_PROCESSES = 200, 4
SLOW_MS = 200          # a frame of the program whose slider is moved
STATE_SECONDS = 0.25   # as the panel observes
MOVED_SECONDS = 3


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench controls")
    parser.add_argument("--rounds", type=int, default=7, help="rounds, each measuring everything once (7)")
    parser.add_argument("--name", default="controls", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    return parser.parse_args(argv)


def spread(values, unit="ms"):
    """Median, and the value that one in twenty is above."""
    ordered = sorted(values)
    return {unit: round(statistics.median(ordered), 3), f"{unit}_95": round(ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))], 3),
            "count": len(ordered)}


def timed(act):
    """Milliseconds that it takes."""
    begin = time.perf_counter()
    act()
    return 1000 * (time.perf_counter() - begin)


def applied(place, rounds):
    """From a request to its answer, and the whole command."""
    for name, period in RATES.items():
        asked, command, alone = [], [], []
        program = running.Program(place, period)
        set_by_command = [str(place.gluray), "set", "spp=1"]
        for _ in range(rounds):
            hub = place.hub()
            (number,) = place.numbers(1)
            with contextlib.closing(place.peer()) as peer:
                for samples in range(1, 21):
                    time.sleep(0.013 + 0.0007 * samples)  # not in step with the frames
                    asked.append(timed(lambda: peer.ask("set", program=number, values={"ao.samples": samples})))
            for _ in range(3):
                command.append(timed(lambda: subprocess.run(set_by_command, env=place.environment, stdout=subprocess.DEVNULL, check=True)))
            running.end_gently(hub)
            time.sleep(0.3)
            alone.append(timed(lambda: subprocess.run(set_by_command, env=place.environment, stdout=subprocess.DEVNULL, check=True)))
        yield {"scene": f"set to answer, {name}", **spread(asked), "goal": 20}
        yield {"scene": f"gluray set, {name}", **spread(command)}
        yield {"scene": f"gluray set without a hub, {name}", **spread(alone)}
        program.end()


def broadcast(place, rounds):
    hub = place.hub()
    place.crowd(CROWD, CROWD_PROCESSES)
    place.numbers(CROWD)
    with contextlib.closing(place.peer()) as peer:
        times = [timed(lambda: peer.ask("set", program="all", values={"ao.samples": i + 1})) for i in range(3 * rounds)]
    running.end_gently(hub)
    yield {"scene": f"set of {CROWD} programs", **spread(times), "goal": 50}


def before_a_hub(place, rounds):
    """control = on against off."""
    frames, threads, memory = {"on": [], "off": []}, {"on": [], "off": []}, {"on": [], "off": []}
    for number in range(rounds):
        for mode in ("on", "off") if number % 2 else ("off", "on"):
            program = running.Program(place, 0, "--set", f"control={mode}")
            program.frame_ms(1)
            frames[mode].append(program.frame_ms(2))
            threads[mode].append(program.threads())
            memory[mode].append(program.resident())
            program.end()
    ratios = [on / off for on, off in zip(frames["on"], frames["off"])]
    yield {"scene": "no hub, control on over off", "frame_ms_on": round(statistics.median(frames["on"]), 4),
           "frame_ms_off": round(statistics.median(frames["off"]), 4), "ratio": round(statistics.median(ratios), 4),
           "new_threads": statistics.median(threads["on"]) - statistics.median(threads["off"]),
           "new_megabytes": round((statistics.median(memory["on"]) - statistics.median(memory["off"])) / 1e6, 3),
           "megabytes_all": {mode: [round(m / 1e6, 2) for m in all_of] for mode, all_of in memory.items()}, "count": rounds}


def while_observed(place, rounds):
    """Frame time with a client that observes over that without, in turn in one run."""
    program, hub = running.Program(place, 0), place.hub()
    place.numbers(1)
    program.frame_ms(1)
    ratios, times = [], []
    for number in range(4 * rounds):
        measured = {}
        for kind in ("alone", "observed") if number % 2 else ("observed", "alone"):
            with running.observed(place, STATE_SECONDS) if kind == "observed" else contextlib.nullcontext():
                time.sleep(0.3)
                measured[kind] = program.frame_ms(1)
        ratios.append(measured["observed"] / measured["alone"])
        times.append(measured["alone"])
    running.end_gently(hub)
    program.end()
    yield {"scene": "observed over not", "frame_ms_alone": round(statistics.median(times), 4), "ratio": round(statistics.median(ratios), 4),
           "ratio_low": round(min(ratios), 4), "ratio_high": round(max(ratios), 4), "count": len(ratios), "goal": 1.02}


def slider(place, rounds):
    """Events of a drag come faster than frames."""
    for rate in (60, 1000):
        program, hub = running.Program(place, SLOW_MS), place.hub()
        (number,) = place.numbers(1)
        delays, refused, waiting = [], 0, []
        for drag in range(rounds):
            moved = running.Drag(place, number, f"drag {drag}")
            delays.append(1000 * moved.move(rate, MOVED_SECONDS + 0.031 * drag))  # not in step with the frames
            refused += moved.refused
            waiting.append(moved.most_waiting)
            moved.close()
        running.end_gently(hub)
        program.end()
        result = spread(delays)
        yield {"scene": f"slider, {rate} events a second, {1000 // SLOW_MS} fps", **result, "frames": round(result["ms"] / SLOW_MS, 2),
               "frames_most": round(max(delays) / SLOW_MS, 2), "goal_frames": 2, "refused": refused,
               "most_that_wait": waiting}


def panel(place, rounds, name):
    """Until its window is mapped."""
    maps, times = Maps(name), []
    for _ in range(rounds):
        begin = time.perf_counter()
        process = place.spawn([place.panel])
        maps.wait()
        times.append(1000 * (time.perf_counter() - begin))
        process.kill()
        process.wait()
    yield {"scene": "panel, start to window", **spread(times), "first_ms": round(times[0], 1), "goal": 1000}


def run(options, argv):
    result = {"suite": "controls", "command": ("scripts/bench controls " + shlex.join(argv)).strip(), **machine.describe(ROOT), "rounds": options.rounds,
              "rows": []}
    with display(own=True) as name, running.Place(options.build, name) as place:
        suites = [applied, broadcast, before_a_hub, while_observed, slider]
        for rows in [suite(place, options.rounds) for suite in suites] + [panel(place, options.rounds, name)]:
            for row in rows:
                print("  ".join(f"{key} {value}" for key, value in row.items()), flush=True)
                result["rows"].append(row)
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
