"""memory of a fixed-function program and of GLuRay in it, at 16 to 256 million triangles

The Wavelet's isosurfaces with normals, indexed in buffer objects (vbo-pieces) and as soup by glBegin, in a list (list-pieces) and in
every frame (immediate). The paths in pieces never hold the mesh in the program: it is made and sent four million triangles at
a time; immediate keeps it indexed, 24 bytes a triangle, as such a program would. "now" is resident memory once all background builds
are in use, "peak" the highest since the program began to send; both exclude the memory before that (window,
libraries, and for immediate its mesh: "before"). "structures": acceleration structures; "sent": bytes of buffers sent to the real
OpenGL. Runs follow one another; each is ended if the machine has less than 1.5 GB left. Results go to bench/results/NAME.json.
"""
import pathlib
import shlex

from support import machine, programs
from support.display import display
from support.options import Parser
from support.telling import status_of

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PATHS = ["vbo-pieces", "list-pieces", "immediate"]
# Everything included, in bytes: indexed with normals, and soup.
GOALS = {(256, "vbo-pieces"): 12e9, (64, "list-pieces"): 8e9, (64, "immediate"): 8e9}
FRAMES = {16: 24, 64: 16, 128: 10, 256: 8}
LEAST_FREE = 1.5e9


def arguments(argv):
    parser = Parser(__doc__, prog="scripts/bench memory")
    parser.add_argument("--rows", default="16:vbo-pieces,16:list-pieces,16:immediate,64:vbo-pieces,64:list-pieces,64:immediate,256:vbo-pieces",
                        help="millions of triangles and path of each row")
    parser.add_argument("--bvh", default="auto", help="acceleration structures, several separated by commas")
    parser.add_argument("--gl", action="store_true", help="the real OpenGL alone, too (slow above 16 million)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--name", default="memory", help="name of the result file")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release", help="build folder")
    parser.add_argument("--xvfb", action="store_true", help="use an Xvfb even if there is a display")
    options = parser.parse_args(argv)
    try:
        options.rows = [(int(size), path) for size, path in (row.split(":") for row in options.rows.split(","))]
    except ValueError:
        parser.error("--rows takes rows like 16:vbo-pieces,64:immediate")
    if not all(size in FRAMES and path in PATHS for size, path in options.rows):
        parser.error(f"sizes are {', '.join(map(str, FRAMES))}, paths {', '.join(PATHS)}")
    return options


def row_of(size, path, kind, measured):
    report = measured.get("report") or {}
    own, triangles = measured["own_bytes"], measured["triangles"]
    most, goal = measured["peak_bytes"], GOALS.get((size, path))
    return {"millions": size, "path": path, "kind": kind, "triangles": triangles, "before_bytes": own,
            "now_bytes": measured["rss_bytes"] - own, "now_anonymous_bytes": measured["rss_anon_bytes"], "peak_bytes": most - own,
            "process_peak_bytes": most, "now_per_triangle": (measured["rss_bytes"] - own) / triangles,
            "peak_per_triangle": (most - own) / triangles, "structure_bytes": report.get("bvh", {}).get("bytes"),
            "mesh_bytes": report.get("mesh", {}).get("bytes"), "sent_bytes": report.get("buffers", {}).get("bytesSent"),
            "process_peak_over_goal": most / goal if goal else None, "first_image_s": measured["first_image_s"],
            "frame_s": measured["frame_s"], "rasterised": report.get("draws", {}).get("rasterised", {})}


COLUMNS = [("Mtri", "millions", "{:d}", 1), ("path", "path", "{}", None), ("by", "kind", "{}", None),
           ("before GB", "before_bytes", "{:.2f}", 1e-9), ("now GB", "now_bytes", "{:.2f}", 1e-9),
           ("peak GB", "peak_bytes", "{:.2f}", 1e-9), ("B/tri", "now_per_triangle", "{:.0f}", 1),
           ("peak B/tri", "peak_per_triangle", "{:.0f}", 1), ("structures GB", "structure_bytes", "{:.2f}", 1e-9),
           ("sent GB", "sent_bytes", "{:.2f}", 1e-9), ("peak/goal", "process_peak_over_goal", "{:.2f}", 1),
           ("first s", "first_image_s", "{:.1f}", 1), ("frame ms", "frame_s", "{:.1f}", 1e3)]


def print_table(rows):
    def cell(row, key, form, scale):
        return "-" if row[key] is None else form.format(row[key] if scale in (None, 1) else row[key] * scale)
    cells = [[title for title, *_ in COLUMNS]] + [[cell(row, *column[1:]) for column in COLUMNS] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(COLUMNS))]
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)), flush=True)
    for row in rows:
        if row["rasterised"]:
            print(f"note: {row['millions']}M {row['path']} {row['kind']}: drawn by the real OpenGL: {row['rasterised']}")


def run(options, argv):
    result = {"suite": "memory", "command": "scripts/bench memory " + shlex.join(argv), **machine.describe(ROOT),
              "threads": options.threads, "rows": []}
    client = options.build / "bench" / "client" / "gluray-bench-client"
    gluray = options.build / "apps" / "gluray" / "gluray"
    with display(own=options.xvfb) as name:
        environment = {"DISPLAY": name, "LP_NUM_THREADS": str(options.threads)}
        for size, path in options.rows:
            for kind in (["gl"] if options.gl else []) + options.bvh.split(","):
                print(f"{size}M {path} {kind}", flush=True)
                command = [client, "--triangles", size, "--path", path, "--orbit", "--frames", 3 if kind == "gl" else FRAMES[size]]
                if kind == "gl":
                    measured = programs.measure(command, environment, timeout=1800, least_free=LEAST_FREE)
                else:
                    measured = programs.measure_with_gluray(gluray, ["--threads", options.threads, "--bvh", kind],
                                                            [*command, "--settle", min(2 + 2 * size, 100)], environment, timeout=1800, least_free=LEAST_FREE)
                result["rows"].append(row_of(size, path, kind, measured))
                print_table(result["rows"][-1:])
    print_table(result["rows"])
    machine.write(ROOT, options.name, result)


def main(argv):
    options = arguments(argv)
    return status_of(lambda: run(options, argv))
