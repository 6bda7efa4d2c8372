"""frames a second of a fixed-function program: real OpenGL, GLuRay, and a bare Embree loop

The Wavelet's isosurfaces at several sizes, sent to OpenGL in each possible way. The three are measured in turn,
round by round, so that other load on the machine affects all of them; results are medians. With --bvh auto the
program first draws ten frames a second until the better structure is in use, as in long use; the first image is that of
the fast structure. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex
import sys

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PATHS = ["list", "elements", "vbo", "arrays", "immediate"]
# Frames of one round for the real OpenGL, by millions of triangles: llvmpipe needs seconds for one of the largest.
GL_FRAMES = {1: 24, 4: 12, 16: 6, 64: 3}
RAY_FRAMES = {1: 72, 4: 48, 16: 36, 64: 24}


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench frames")
    parser.add_argument("--large", action="store_true", help="64 million triangles too (needs about 16 GB)")
    parser.add_argument("--quick", action="store_true", help="1 million triangles, one round: a minute in all")
    parser.add_argument("--sizes", help="millions of triangles, for instance 1,4")
    parser.add_argument("--paths", help=f"some of {','.join(PATHS)}")
    parser.add_argument("--rounds", type=int, help="rounds, each measuring everything once (3; quick: 1)")
    parser.add_argument("--threads", type=int, default=2, help="threads of llvmpipe, GLuRay and the bare loop (2)")
    parser.add_argument("--bvh", default="auto", choices=["auto", "fast", "full", "compact"],
                        help="GLuRay's acceleration structures; the bare loop uses full ones if this is auto")
    parser.add_argument("--name", default="frames", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--no-gluray", action="store_true", help="measure only the other two")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    sizes = options.sizes.split(",") if options.sizes else ["1"] if options.quick else ["1", "4", "16"]
    try:
        options.sizes = [int(size) for size in sizes] + ([64] if options.large and "64" not in sizes else [])
    except ValueError:
        parser.error(f"--sizes takes whole numbers of millions, not '{options.sizes}'")
    if any(size not in GL_FRAMES for size in options.sizes):
        parser.error(f"sizes are {', '.join(map(str, GL_FRAMES))}")
    options.paths = options.paths.split(",") if options.paths else PATHS
    if not set(options.paths) <= set(PATHS):
        parser.error(f"paths are {', '.join(PATHS)}")
    options.rounds = options.rounds or (1 if options.quick else 3)
    return options


class Suite:
    """The programs, their options and the environment they run in."""

    def __init__(self, options, display_name):
        self.options = options
        self.client = options.build / "bench" / "client" / "gluray-bench-client"
        self.bare = options.build / "bench" / "bare" / "gluray-bench-bare"
        self.gluray = options.build / "apps" / "gluray" / "gluray"
        self.gluray_options = ["--threads", str(options.threads), "--bvh", options.bvh]
        self.environment = {"DISPLAY": display_name, "LP_NUM_THREADS": str(options.threads)}
        programs.require(self.client, self.bare, *([] if options.no_gluray else [self.gluray]))

    def measure_gl(self, size, path):
        frames = 6 if self.options.quick else GL_FRAMES.get(size, 20)
        return programs.measure(self._client(size, path, frames), self.environment)

    def measure_gluray(self, size, path):
        frames = 24 if self.options.quick else RAY_FRAMES.get(size, 20)
        # Structures built in the background must be in use before frames are measured and memory is read.
        warm = ["--warm", 2 + 2 * size] if self.options.bvh == "auto" and size > 0 else []
        return programs.measure_with_gluray(self.gluray, self.gluray_options, self._client(size, path, frames) + warm,
                                            self.environment)

    def measure_bare(self, size):
        frames = 24 if self.options.quick else RAY_FRAMES[size]
        return programs.measure([self.bare, "--triangles", size, "--frames", frames, "--orbit", "--bvh",
                                 "full" if self.options.bvh == "auto" else self.options.bvh, "--threads", self.options.threads], self.environment)

    def _client(self, size, path, frames):
        return [self.client, "--triangles", size, "--path", path, "--frames", frames, "--orbit"]

    def measure_size(self, size):
        """Rounds of everything at one size, interleaved: {"bare": measurement, path: {"gl":, "gluray":}, ...}."""
        rounds = {("bare", None): []}
        for number in range(self.options.rounds):
            for path in self.options.paths:
                progress(f"{size}M triangles, round {number + 1} of {self.options.rounds}, {path}")
                rounds.setdefault(("gl", path), []).append(self.measure_gl(size, path))
                if not self.options.no_gluray:
                    rounds.setdefault(("gluray", path), []).append(self.measure_gluray(size, path))
                # Measures the bare loop between the paths, too, not only once in the round.
                rounds[("bare", None)].append(self.measure_bare(size))
        progress(None)
        out = {path: {} for path in self.options.paths}
        for (kind, path), measured in rounds.items():
            if kind == "bare":
                out["bare"] = programs.combined(measured)
            else:
                out[path][kind] = programs.combined(measured)
        return out


def progress(text):
    """Prints to stderr what is being measured; None ends the line on a terminal."""
    if sys.stderr.isatty():
        print("\r\033[K" + (text or ""), end="", file=sys.stderr, flush=True)
    elif text:
        print(text, file=sys.stderr, flush=True)


def rows_of(size, measured, empty):
    """The results of one size, a dictionary a path. `empty` holds the same programs' memory with nothing to draw."""
    bare_fps = 1 / measured["bare"]["frame_s"]
    for path, pair in measured.items():
        if path == "bare":
            continue
        triangles = pair["gl"]["triangles"]
        row = {"millions": size, "path": path, "triangles": triangles, "bare_fps": bare_fps,
               "bare_first_image_s": measured["bare"]["first_image_s"]}
        for kind, m in pair.items():
            row[f"{kind}_fps"] = 1 / m["frame_s"]
            row[f"{kind}_first_image_s"] = m["first_image_s"]
            row[f"{kind}_bytes_per_triangle"] = (m["rss_bytes"] - empty[kind]) / triangles
        if "gluray" in pair:
            row["gluray_over_gl"] = row["gluray_fps"] / row["gl_fps"]
            row["gluray_over_bare"] = row["gluray_fps"] / bare_fps
            row["rasterised"] = rasterised(pair["gluray"]["report"])
        yield row


def rasterised(report):
    """{reason: draws} left to the real OpenGL; {"no report": 1} if GLuRay wrote no report."""
    return {"no report": 1} if report is None else report.get("draws", {}).get("rasterised", {})


COLUMNS = [("Mtri", "millions", "{:d}"), ("path", "path", "{}"), ("GL fps", "gl_fps", "{:.2f}"),
           ("GLuRay fps", "gluray_fps", "{:.2f}"), ("bare fps", "bare_fps", "{:.2f}"),
           ("/GL", "gluray_over_gl", "{:.2f}"), ("/bare", "gluray_over_bare", "{:.2f}"),
           ("first GL s", "gl_first_image_s", "{:.2f}"), ("first GLuRay s", "gluray_first_image_s", "{:.2f}"),
           ("GL B/tri", "gl_bytes_per_triangle", "{:.0f}"), ("GLuRay B/tri", "gluray_bytes_per_triangle", "{:.0f}")]


def print_table(rows):
    columns = [column for column in COLUMNS if column[1] in rows[0]]
    cells = [[title for title, _, _ in columns]]
    cells += [[form.format(row[key]) for _, key, form in columns] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(columns))]
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)), flush=True)
    for row in rows:
        if row.get("rasterised"):
            print(f"note: {row['millions']}M {row['path']}: drawn by the real OpenGL: {row['rasterised']}")


def run(options, argv):
    result = {"suite": "frames", "command": "scripts/bench frames " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "bvh": options.bvh, "rounds": options.rounds, "rows": [], "measured": {}}
    with display(own=options.xvfb) as name:
        suite = Suite(options, name)
        empty = {"gl": suite.measure_gl(0, "list")["rss_bytes"]}
        if not options.no_gluray:
            empty["gluray"] = suite.measure_gluray(0, "list")["rss_bytes"]
        for size in options.sizes:
            measured = suite.measure_size(size)
            result["measured"][str(size)] = measured
            result["rows"] += rows_of(size, measured, empty)
    result["versions"]["renderer"] = next(iter(result["measured"].values()))[options.paths[0]]["gl"]["renderer"]
    print_table(result["rows"])
    machine.write(ROOT, options.name, result)


def measured_to_the_end(options, argv):
    """run(), and ends the line on the terminal in any case."""
    try:
        run(options, argv)
    finally:
        progress(None)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: measured_to_the_end(options, argv))
