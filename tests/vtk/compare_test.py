"""Which differences compare.py must report, and which not: compare_test.py FOLDER"""
import pathlib
import shutil
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed for", sys.executable)
    sys.exit(77)

import batch
import compare
import registry
import stages

WIDTH, HEIGHT = 100, 80


def ball():
    """A bright disc on a dark background, and its depth."""
    y, x = np.indices((HEIGHT, WIDTH))
    inside = (x - 50) ** 2 + (y - 40) ** 2 < 400
    image = np.where(inside[..., None], [200, 150, 100], [20, 30, 40]).astype(np.uint8)
    return image, np.where(inside, 0.5, 1.0).astype(np.float32)


def changed(color=None, depth=None):
    image, window_depth = ball()
    if color:
        rows, columns, value = color
        image[rows, columns] = value
    if depth:
        rows, columns, value = depth
        window_depth[rows, columns] = value
    return image, window_depth


def drawn(folder, shots, counts=None, error="null", text="", steady="null"):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    stage = stages.Stage(folder, "state")
    for image, depth in shots:
        stage.keep(image, depth)
    if text:
        stage.keep_text([text])
    made = batch.Batch("vtk", ["state"], folder)
    made.result_file("state").write_text('{"seconds": 0, "error": %s, "counts": %s, "steady": %s}' %
                                          (error, counts or '{"frames": 1}', steady))
    return made


HALF_TRACED = '{"triangles.traced": 50, "triangles.rasterised": 50, "draws.rasterised.blending": 3}'
FEW = (slice(30, 32), slice(50, 51), (240, 150, 100))       # 2 pixels of 8000: 0.025 %
MANY = (slice(30, 34), slice(45, 50), (240, 150, 100))      # 20 pixels
OUTSIDE = (slice(2, 3), slice(2, 3), (22, 30, 40))          # one pixel, by little
ROUNDED = (slice(2, 9), slice(2, 9), (21, 31, 39))          # by the least there is
NEAR = (slice(30, 34), slice(40, 50), (202, 152, 102))      # 40 pixels by 2
LESS_NEAR = (slice(30, 31), slice(45, 46), (203, 150, 100)) # one pixel by 3
DEEPER = (slice(30, 34), slice(45, 50), 0.51)

# Errors of the second run: its images, further arguments of drawn() and registry.State, and the words that must be reported.
CASES = {
    "equal": ([ball()], {}, {}, None),
    "few pixels": ([changed(FEW)], {}, {}, None),
    "many pixels": ([changed(MANY)], {}, {}, "differ by more than 8/255"),
    "a tolerance": ([changed(MANY)], {}, {"beyond": 0.005}, None),
    "a pixel outside": ([changed(OUTSIDE)], {}, {}, "1 pixels away from every surface"),
    "roundings outside": ([changed(ROUNDED)], {}, {}, None),
    "a pixel outside where that is allowed": ([changed(OUTSIDE)], {}, {"outside": False}, None),
    "a close picture": ([changed(NEAR)], {}, {"close": True}, None),
    "a pixel that is not close": ([changed(LESS_NEAR)], {}, {"close": True}, "0.0125% of its pixels differ by more than 2/255"),
    "a pixel that need not be close": ([changed(LESS_NEAR)], {}, {}, None),
    "depth": ([changed(None, DEEPER)], {}, {}, "the depth of 0.2500%"),
    "depth that is not compared": ([changed(None, DEEPER)], {}, {"same_depth": False}, None),
    "size": ([(ball()[0][:, 1:], None)], {}, {}, "99x80 instead of 100x80"),
    "an image too few": ([], {}, {}, "0 images instead of 1"),
    "an image too many": ([ball(), ball()], {}, {}, "2 images instead of 1"),
    "other words": ([ball()], {"text": "cell 3"}, {}, "other words"),
    "an error": ([ball()], {"error": '"the process ended with -11"'}, {}, "ended with -11"),
    "no report": ([ball()], {"counts": "null"}, {}, "wrote no report"),
    "too little traced": ([ball()], {"counts": HALF_TRACED}, {"min_share": 0.9}, "50.00% of its triangles"),
    "a steady orbit": ([ball()], {"steady": '{"triangles.traced": 9, "mesh.built": 0}'}, {}, None),
    "meshes built in an orbit": ([ball()], {"steady": '{"triangles.traced": 9, "mesh.built": 2}'}, {}, "2 meshes were built"),
    "structures built in an orbit": ([ball()], {"steady": '{"triangles.traced": 9, "bvh.builds": 1}'}, {}, "1 acceleration structures"),
    "buffers sent in an orbit": ([ball()], {"steady": '{"triangles.traced": 9, "buffers.bytesSent": 64}'}, {}, "64 bytes of buffers"),
    "buffers that may be sent": ([ball()], {"steady": '{"triangles.traced": 9, "buffers.bytesSent": 64}'}, {"sends": 64}, None),
    "nothing traced in an orbit": ([ball()], {"steady": '{"triangles.traced": 0}'}, {}, "nothing was traced while"),
    "enough traced": ([ball()], {"counts": HALF_TRACED}, {"min_share": 0.4}, None),
}


def main():
    place = pathlib.Path(sys.argv[1]).resolve()
    failures = []
    for name, (shots, seen, asked, expected) in CASES.items():
        off = drawn(place / "off", [ball()])
        on = drawn(place / "on", shots, **seen)
        state = registry.State(**{"name": "state", "group": "none", "program": "vtk", "draw": None, "beyond": 0.0005, "reason": "",
                                  "min_share": None, "outside": True, "same_depth": True, "sends": 0, **asked})
        _, wrong = compare.compare_state(state, off, on, place / "failed")
        if expected is None and wrong:
            failures.append(f"{name}: blamed for {wrong}")
        if expected is not None and not any(expected in line for line in wrong):
            failures.append(f"{name}: expected '{expected}', got {wrong}")
    for tolerance in ({"beyond": 0.006, "reason": "too much"}, {"beyond": 0.001}):
        try:
            registry.state("vtk", **tolerance)
            failures.append(f"a state may have {tolerance}")
        except ValueError:
            pass
    print("\n".join(failures) or f"{len(CASES)} cases judged correctly")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
