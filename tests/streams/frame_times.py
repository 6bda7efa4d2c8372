"""Frame times of the recorded streams, with the real OpenGL alone and through GLuRay, in turn.

    frame_times.py --gluray GLURAY [--engine auto|always|never] [--frames N] [--turns N] [--json FILE] [NAME ...]

(with an X server at hand.) The last frame of each stream is replayed again and again, as a viewer draws it. Where glretrace
cannot do that, the frames after the first are timed: the time of the whole stream less that of its first frame. Each turn
measures both ways one after the other, and the medians of the turns count; glretrace's own work is in both. NAME is a stream
of this folder, or the path of another recording without its ".trace", such as one with more frames than ours.
"""
import json
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

import streams

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

HERE = pathlib.Path(__file__).parent
SHORT = 5  # for very short streams, measurements for each of --turns


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def replay(trace, options=(), before=()):
    """(frames, seconds, seconds of all processors)"""
    command = [*before, "glretrace", "--benchmark", *options, str(trace)]
    start = processor_seconds()
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=300)
    found = re.search(r"Rendered (\d+) frames in ([\d.]+) secs", done.stdout + done.stderr)
    return int(found[1]), float(found[2]), processor_seconds() - start


def first_frame(trace, folder):
    cut = folder / trace.name
    subprocess.run(["apitrace", "trim", "--frames=0-0", "-o", str(cut), str(trace)], check=True, capture_output=True)
    return cut


class Stream:
    def __init__(self, name, frames, folder):
        self.name, self.trace, self.frames = name, HERE / f"{name}.trace", frames
        self.repeats = replay(self.trace, ["--loop=10"])[0] > replay(self.trace)[0]
        self.short = self.trace if self.repeats else first_frame(self.trace, folder)

    def turn(self, way):
        """Milliseconds of a frame and of all processors in it, without the first frames, in which libraries are loaded and
        shaders built."""
        few = replay(self.short, ["--loop=5"] if self.repeats else [], way)
        many = replay(self.trace, [f"--loop={self.frames + 5}"] if self.repeats else [], way)
        return [1000 * (many[which] - few[which]) / max(many[0] - few[0], 1) for which in (1, 2)]

    def milliseconds(self, turns, ways):
        """For each way the medians of the time of a frame, and of its processor time; measured in turn."""
        measured = [[self.turn(way) for way in ways] for _ in range(turns if self.repeats else turns * SHORT)]
        return [[statistics.median(times) for times in zip(*way)] for way in zip(*measured)]


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--engine", default="auto")
    parser.add_argument("--frames", type=int, default=1000)
    parser.add_argument("--turns", type=int, default=9)
    parser.add_argument("--json")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    os.environ.pop("GLURAY_ENGINE", None)
    ways = [(), (given.gluray, "--engine", given.engine, "--")]
    rows = []
    print("| program | real OpenGL, ms | GLuRay, ms | ratio | ratio of processor time |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name in given.names or streams.STREAMS:
            stream = Stream(name, given.frames, pathlib.Path(folder))
            (off, off_cpu), (on, on_cpu) = stream.milliseconds(given.turns, ways)
            rows.append({"stream": name, "repeated": stream.repeats, "gl_ms": off, "gluray_ms": on, "ratio": on / off,
                         "gl_processor_ms": off_cpu, "gluray_processor_ms": on_cpu, "processor_ratio": on_cpu / off_cpu})
            print(f"| {name} | {off:.2f} | {on:.2f} | {on / off:.2f} | {on_cpu / off_cpu:.2f} |", flush=True)
    if given.json:
        sys.path.insert(0, str(HERE.parent.parent / "bench"))
        from support import machine
        result = {"how": f"tests/streams/frame_times.py --engine {given.engine} --frames {given.frames} --turns {given.turns}: "
                         f"medians of {given.turns} turns ({given.turns * SHORT} of streams of few frames), the real OpenGL and GLuRay in turn; "
                         "glretrace's own work in both",
                  **machine.describe(HERE.parent.parent), "median_ratio": statistics.median(r["ratio"] for r in rows), "rows": rows}
        pathlib.Path(given.json).write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
