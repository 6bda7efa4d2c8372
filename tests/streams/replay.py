"""Replays one recorded call stream by the real OpenGL alone and through doors, and compares every frame.

    replay.py --gluray GLURAY --out FOLDER [--door DOOR]... NAME

Needs an X server of its own (tests/doors/with_display.py). Where a frame differs, NAME-DOOR-FRAME-off.png, -on.png and
-difference.png are left in FOLDER; NAME.json always. Exit code 77: apitrace is not installed.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "live"))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import images  # noqa: E402
import streams  # noqa: E402
from command_line import Parser  # noqa: E402

BEYOND = 0.005  # share of a frame's pixels that may differ by more than 8 of 255
SECONDS = 120


def snapshots(name):
    """The calls before which images are taken: the ends of frames, from the first compared frame on."""
    listed = subprocess.run(["apitrace", "dump", "--color=never", "--calls=*/frame", str(HERE / f"{name}.trace")],
                            capture_output=True, text=True, check=True).stdout
    numbers = [line.split()[0] for line in listed.splitlines() if line[:1].isdigit()]
    return ",".join(numbers[streams.STREAMS[name].first:])


def replay(name, before=()):
    """The images of every frame, and OpenGL's messages to the program."""
    command = [*before, "glretrace", f"--snapshot={snapshots(name)}",
               "--snapshot-prefix=-", str(HERE / f"{name}.trace")]
    done = subprocess.run(command, capture_output=True, timeout=SECONDS, env=dict(os.environ, LC_ALL="C"))
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr.decode(errors='replace')[-800:]}")
    messages = {line.split(":", 1)[1] for line in done.stderr.decode(errors="replace").splitlines() if ": message: major api error" in line}
    return list(images.read_pnms(done.stdout)), messages


def traced_share(report):
    traced, rasterised = report["triangles"]["traced"], report["triangles"]["rasterised"]
    return traced / (traced + rasterised) if traced + rasterised else 0.0


def check(name, door, plain, seen, report, out):
    """The errors, one a line."""
    stream = streams.STREAMS[name]
    wrong = []
    if len(plain) != len(seen):
        return [f"{name} by {door}: {len(seen)} frames instead of {len(plain)}"]
    for number, (off, on) in enumerate(zip(plain, seen)):
        share = images.share_beyond(off, on) if off.shape == on.shape else 1.0
        if share <= BEYOND:
            continue
        wrong.append(f"{name} by {door}: {share:.3%} of frame {number} differs by more than {images.VISIBLE}/255, "
                     f"at most {BEYOND:.3%} may")
        for kind, image in (("off", off), ("on", on), ("difference", images.difference_image(off, on))):
            images.write_png(out / f"{name}-{door}-{number}-{kind}.png", image)
    if traced_share(report) < stream.traced:
        wrong.append(f"{name} by {door}: {traced_share(report):.2%} of its triangles are traced, at least {stream.traced:.2%} "
                     f"should be; rasterised: {report['draws']['rasterised']}")
    frames = stream.first + len(plain)
    if report["flushes"] > stream.batches * frames:
        wrong.append(f"{name} by {door}: {report['flushes']} batches in {frames} frames, at most {stream.batches} a frame")
    return wrong


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--door", choices=["auto", "vendor", "preload"], action="append", help="through this one (auto)")
    parser.add_argument("name", choices=list(streams.STREAMS))
    given = parser.parse_args()
    if not shutil.which("glretrace"):
        print("skipped: apitrace is not installed")
        return 77
    out = pathlib.Path(given.out)
    out.mkdir(parents=True, exist_ok=True)

    plain, messages = replay(given.name)
    wrong = [] if plain and max(map(images.color_count, plain)) > 1 else [f"{given.name}: its images are empty"]
    results = {"frames": len(plain)}
    for door in given.door or ["auto"]:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "report.json"
            seen, more = replay(given.name, [given.gluray, "--door", door, "--shading", "vertex", "--report", str(path), "--"])
            report = json.loads(path.read_text())
        wrong += check(given.name, door, plain, seen, report, out)
        wrong += [f"{given.name} by {door}: messages to the program that do not come from its own calls:{text}" for text in more - messages]
        results[door] = {"beyond": [images.share_beyond(a, b) for a, b in zip(plain, seen) if a.shape == b.shape],
                         "traced": traced_share(report), "report": report}
        print(f"{given.name} by {door}: {len(seen)} frames, at most {max(results[door]['beyond'], default=1):.4%} of a frame "
              f"differs, {results[door]['traced']:.2%} traced, {report['flushes']} batches")
    (out / f"{given.name}.json").write_text(json.dumps(results, indent=2) + "\n")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
