"""Frame times of the recorded streams, with the real OpenGL alone and through GLuRay, in turn: the last frame of each is
replayed again and again, as a viewer draws it. Medians; glretrace's own work is in both.

    frame_times.py --gluray GLURAY [--frames N] [--turns N] [NAME ...]       (with an X server at hand)
"""
import argparse
import pathlib
import re
import statistics
import subprocess

import streams

HERE = pathlib.Path(__file__).parent


def frame_ms(name, frames, before=()):
    command = [*before, "glretrace", "--benchmark", f"--loop={frames}", str(HERE / f"{name}.trace")]
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=300)
    found = re.search(r"Rendered (\d+) frames in ([\d.]+) secs", done.stdout + done.stderr)
    return float(found[2]) / int(found[1]) * 1000


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--frames", type=int, default=150)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    print("| program | real OpenGL, ms | GLuRay, ms | ratio |\n|---|---|---|---|")
    for name in given.names or streams.STREAMS:
        off, on = [], []
        for _ in range(given.turns):
            off.append(frame_ms(name, given.frames))
            on.append(frame_ms(name, given.frames, [given.gluray, "--"]))
        off, on = statistics.median(off), statistics.median(on)
        print(f"| {name} | {off:.2f} | {on:.2f} | {on / off:.2f} |", flush=True)


if __name__ == "__main__":
    main()
