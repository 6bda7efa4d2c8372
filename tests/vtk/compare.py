"""Draws states of ParaView and VTK with and without GLuRay and compares their images and depth.

    compare.py --gluray GLURAY --out FOLDER [--group GROUP,... | --label LABEL] [NAME ...]

Needs an X server of its own (tests/doors/with_display.py). GROUP is a module of states/; one process draws the states of one
program, of whatever groups they are. Compared are the share of pixels that differ by more than 8 of 255, window depth, and, away
from all surfaces, every pixel; of some states also the share of pixels that differ by more than 2. For a state that fails both
images, their difference (eight times as bright) and NAME.json are in FOLDER/failed. Prints a table; FOLDER/LABEL.json holds it too.
Exit code 77: ParaView or VTK is not installed.
"""
import json
import pathlib
import sys
import zlib

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "live"))
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import batch  # noqa: E402
import images  # noqa: E402
import registry  # noqa: E402
from command_line import Parser  # noqa: E402

DEPTH = 1e-4   # window depths that differ by more count as different
# Counts that must stay 0 while only the camera moves.
STEADY = {"mesh.built": "meshes were built", "bvh.builds": "acceleration structures were built"}
MARGIN = 4     # pixels around surfaces that anti-aliasing may touch
CLOSE, CLOSE_SHARE = 2, 0.0001  # registry.State.close
ROUNDING = 1   # of 255: what may differ elsewhere, where anti-aliasing of the whole image was computed by us


def read_png(path):
    """An image that images.write_png() wrote: RGB, no filters."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        size, kind = int.from_bytes(data[at:at + 4], "big"), data[at + 4:at + 8]
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height = int.from_bytes(body[:4], "big"), int.from_bytes(body[4:8], "big")
        elif kind == b"IDAT":
            packed += body
        at += size + 12
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + 3 * width)
    return rows[:, 1:].reshape(height, width, 3)


def grown(mask, by):
    """True wherever `mask` is true within a square of `by` pixels to each side."""
    wide = np.pad(mask, by)
    for axis in (0, 1):
        wide = np.logical_or.reduce([np.roll(wide, shift, axis) for shift in range(-by, by + 1)])
    return wide[by:-by, by:-by]


def compare_shot(state, off_file, on_file):
    """Shares that differ in colour and depth, and the errors."""
    off, on = read_png(off_file), read_png(on_file)
    if off.shape != on.shape:
        return 1.0, 1.0, [f"{on.shape[1]}x{on.shape[0]} instead of {off.shape[1]}x{off.shape[0]} pixels"]
    wrong = []
    beyond = images.share_beyond(off, on)
    if beyond > state.beyond:
        wrong.append(f"{beyond:.4%} of its pixels differ by more than {images.VISIBLE}/255, at most {state.beyond:.4%} may")
    if state.close and (share := images.share_beyond(off, on, CLOSE)) > CLOSE_SHARE:
        wrong.append(f"{share:.4%} of its pixels differ by more than {CLOSE}/255, at most {CLOSE_SHARE:.4%} may")
    depth_files = [file.with_suffix(".npy") for file in (off_file, on_file)]
    if not state.same_depth or not all(file.exists() for file in depth_files):
        return beyond, 0.0, wrong
    off_depth, on_depth = map(np.load, depth_files)
    deeper = float((np.abs(off_depth - on_depth) > DEPTH).mean())
    if deeper > state.beyond:
        wrong.append(f"the depth of {deeper:.4%} of its pixels differs by more than {DEPTH}, at most {state.beyond:.4%} may")
    if state.outside:
        outside = ~grown((off_depth < 1) | (on_depth < 1), MARGIN)
        apart = np.abs(off[outside].astype(np.int16) - on[outside]).max(axis=1, initial=0)
        count = int((apart > ROUNDING).sum())
        if count:
            wrong.append(f"{count} pixels away from every surface are not equal")
    return beyond, deeper, wrong


def keep_failure(folder, state, number, off_file, on_file, wrong):
    off, on = read_png(off_file), read_png(on_file)
    kept = [("off", off), ("on", on)]
    if off.shape == on.shape:
        kept.append(("difference", images.difference_image(off, on)))
    folder.mkdir(parents=True, exist_ok=True)
    for kind, image in kept:
        images.write_png(folder / f"{state.name}-{number}-{kind}.png", np.ascontiguousarray(image))
    return [f"{state.name}, image {number}: {line}; see {folder}/{state.name}-{number}-*.png" for line in wrong]


def traced_share(counts):
    traced, rasterised = counts.get("triangles.traced", 0), counts.get("triangles.rasterised", 0)
    return traced / (traced + rasterised) if traced + rasterised else None


def reasons(counts):
    """The reasons for rasterised draws, the most frequent first."""
    start = "draws.rasterised."
    draws = {name[len(start):]: count for name, count in counts.items() if name.startswith(start)}
    return sorted(draws, key=draws.get, reverse=True)


def compare_state(state, off, on, failed):
    """A row of the table, and the errors."""
    name = state.name
    plain, traced = off.result(name), on.result(name)
    wrong = [f"{name}: {kind}: {seen['error']}" for kind, seen in (("plain", plain), ("with GLuRay", traced)) if seen["error"]]
    off_shots, on_shots = off.shots(name), on.shots(name)
    if not off_shots and not off.text(name):
        wrong.append(f"{name}: draws nothing that could be compared")
    if len(off_shots) != len(on_shots):
        wrong.append(f"{name}: {len(on_shots)} images instead of {len(off_shots)}")
    if off.text(name) != on.text(name):
        wrong.append(f"{name}: other words: see {off.folder / name}.txt and {on.folder / name}.txt")
    row = {"name": name, "program": state.program, "pictures": len(on_shots), "beyond": 0.0, "depth": 0.0,
           "seconds": traced["seconds"], "plain_seconds": plain["seconds"]}
    for number, files in enumerate(zip(off_shots, on_shots)):
        beyond, depth, lines = compare_shot(state, *files)
        row["beyond"], row["depth"] = max(row["beyond"], beyond), max(row["depth"], depth)
        if lines:
            wrong += keep_failure(failed, state, number, *files, lines)
    # A server's counts are complete after it has ended.
    if traced["counts"] is None and not traced["error"] and state.program != "remote":
        wrong.append(f"{name}: GLuRay wrote no report while it was drawn: see {on.folder / 'log'}")
    counts = traced["counts"] or {}
    row |= {"traced": traced_share(counts), "triangles": counts.get("triangles.traced", 0) + counts.get("triangles.rasterised", 0),
            "reasons": reasons(counts), "counts": counts}
    if traced.get("steady"):
        wrong += unsteady(state, traced["steady"])
    if state.min_share is not None and (row["traced"] or 0) < state.min_share:
        wrong.append(f"{name}: {row['traced'] or 0:.2%} of its triangles are traced, at least {state.min_share:.2%} should be; "
                     f"rasterised for: {'; '.join(row['reasons'])}")
    return row, wrong


def unsteady(state, steady):
    """What is wrong with the counts of frames between which only the camera moved."""
    name = state.name
    wrong = [f"{name}: {steady[counter]:.0f} {what} while only the camera moved" for counter, what in STEADY.items() if steady.get(counter)]
    if (sent := steady.get("buffers.bytesSent", 0)) > state.sends:
        wrong.append(f"{name}: {sent:.0f} bytes of buffers were sent to the real OpenGL while only the camera moved, {state.sends} at most")
    if not steady.get("triangles.traced"):
        wrong.append(f"{name}: nothing was traced while the camera moved")
    return wrong


def print_processes(program, folder):
    """Prints one line for each of several processes, with the totals of its report. Returns the errors."""
    reports = sorted(folder.glob("report.json*"))
    for path in reports:
        report = json.loads(path.read_text())
        triangles = report["triangles"]
        print(f"{program} {path.name}: {triangles['traced']} triangles traced, {triangles['rasterised']} rasterised, "
              f"{report['mesh']['built']} meshes built")
    wanted = int(program[len("mpi"):]) if program.startswith("mpi") else 1
    return [] if len(reports) == wanted else [f"{program}: {len(reports)} reports of {wanted} processes in {folder}"]


def print_table(rows):
    print(f"{'state':36} {'program':8} images   pixels    depth   traced  triangles  seconds  most often rasterised for")
    for row in rows:
        share = "-" if row["traced"] is None else f"{row['traced']:.1%}"
        print(f"{row['name']:36} {row['program']:8} {row['pictures']:8} {row['beyond']:8.4%} {row['depth']:8.4%} {share:>8} "
              f"{row['triangles']:10.0f} {row['seconds']:8.2f}  {'; '.join(row['reasons'][:1])}")


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--group", default="")
    parser.add_argument("--label", help="name of the table and of the folders, where no group gives one")
    parser.add_argument("--door", default="auto")
    parser.add_argument("--keep-shares", action="store_true",
                        help="write to shares.json how much of each state must be traced: what is traced now, a little less")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    states = [s for s in registry.load().values() if (s.name in given.names if given.names else not given.group or s.group in given.group.split(","))]
    if not states or len(states) < len(given.names):
        sys.exit(f"compare.py: no such states: {given.group} {given.names}")
    out, gluray = pathlib.Path(given.out).resolve(), str(pathlib.Path(given.gluray).resolve())
    label = given.label or given.group or ("some" if given.names else "all")
    failed = out / "failed"
    for state in states:
        for file in failed.glob(f"{state.name}-*.png"):
            file.unlink()

    rows, wrong, skipped = [], [], []
    for program in dict.fromkeys(s.program for s in states):
        chosen = [s for s in states if s.program == program]
        if not chosen:
            continue
        names = [s.name for s in chosen]
        try:
            off = batch.draw_plain(program, names, out / "plain" / f"{label}-{program}")
            on = batch.draw_traced(program, names, out / "traced" / f"{label}-{program}", gluray, ["--door", given.door])
        except batch.Skipped as why:
            skipped.append(f"skipped: {program}: {why}")
            continue
        if program not in ("pvbatch", "vtk", "newer_vtk"):
            wrong += print_processes(program, on.folder)
        for state in chosen:
            row, lines = compare_state(state, off, on, failed)
            rows.append(row)
            wrong += lines
    if rows:
        print_table(rows)
        (out / f"{label}.json").write_text(json.dumps(rows, indent=1) + "\n")
    if given.keep_shares:
        registry.keep_shares({row["name"]: row["traced"] for row in rows if row["traced"] is not None})
    print("\n".join(skipped + wrong))
    return 1 if wrong else 77 if not rows else 0


if __name__ == "__main__":
    sys.exit(main())
