"""Draws states of ParaView and VTK under GLuRay without and with an effect of light, and compares the images.

    light.py --gluray GLURAY --out FOLDER --effect ao|shadows|path [--group GROUP] [NAME ...]

Needs an X server of its own (tests/doors/with_display.py). GROUP is a module of states/. An effect changes colours of traced
surfaces alone: window depth, and pixels away from all surfaces where depth shows what is away, must be equal. Ambient
occlusion may only darken. The images must show the effect. Images of states that fail are in FOLDER/failed. Exit code 77: ParaView or VTK is not
installed.
"""
import dataclasses
import pathlib
import sys

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
from compare import MARGIN, grown, keep_failure, read_png  # noqa: E402

APART = 3            # of 255: larger differences count
BRIGHTENED = 0.0003  # share of pixels that anti-aliasing of the whole image may brighten beyond those around
SAME_DEPTH = 2e-6    # structures that were replaced meanwhile give other roundings
# Backgrounds with edges: FXAA follows one from a surface for up to 12 pixels (EndpointSearchIterations of VTK).
BACKGROUND_EDGES = {"textured_background": 12}
# Surfaces without depth: those at the far plane, seen from inside of impostors, or translucent.
DEPTHLESS = {"camera_inside", "spheres_near", "sphere_around_viewer", "spheres_recolored"}


@dataclasses.dataclass(frozen=True)
class Effect:
    settings: tuple
    darkens: bool  # whether it only darkens


# One pass for each image: what is looked at is not their noise.
EFFECTS = {
    "ao": Effect(("ao=on", "ao.radius=0.3", "noise=0"), True),
    "shadows": Effect(("shadows=on", "lights=headlight+key", "noise=0"), False),
    "path": Effect(("integrator=path", "path.samples=2", "noise=0"), False),
}


def options(effect):
    return [word for setting in effect.settings for word in ("--set", setting)]


def luminance(image):
    """Of pixels, 0 to 255: anti-aliasing mixes coloured lines with less of a darker surface, which makes some channels larger."""
    return image[..., :3] @ np.array([0.2126, 0.7152, 0.0722])


def around(image):
    """The largest value in the 5x5 pixels around: the brightest that anti-aliasing can mix."""
    wide = np.pad(image, 2, mode="edge")
    height, width = image.shape[:2]
    return np.maximum.reduce([wide[y:y + height, x:x + width] for y in range(5) for x in range(5)])


def compare_shot(state, effect, off_file, on_file):
    """The share of surfaces that changed, and the errors."""
    off, on = read_png(off_file).astype(np.int16), read_png(on_file).astype(np.int16)
    if off.shape != on.shape:
        return 0.0, [f"{on.shape[1]}x{on.shape[0]} instead of {off.shape[1]}x{off.shape[0]} pixels"]
    wrong = []
    changed = np.abs(off - on).max(axis=2) > APART
    brighter = float((luminance(on) - around(luminance(off)) > APART).mean())
    if effect.darkens and brighter > BRIGHTENED:
        wrong.append(f"{brighter:.4%} of its pixels are brighter")
    if not state.same_depth:
        return float(changed.mean()), wrong
    depth_files = [file.with_suffix(".npy") for file in (off_file, on_file)]
    if not all(file.exists() for file in depth_files):
        return float(changed.mean()), wrong
    off_depth, on_depth = map(np.load, depth_files)
    deeper = float((np.abs(off_depth - on_depth) > SAME_DEPTH).mean())
    if deeper:
        wrong.append(f"the depth of {deeper:.4%} of its pixels differs")
    surfaces = grown(off_depth < 1, BACKGROUND_EDGES.get(state.name, MARGIN))
    known = state.outside and state.group != "translucent" and state.name not in DEPTHLESS
    if known and (count := int((off != on).any(axis=2)[~surfaces].sum())):
        wrong.append(f"{count} pixels away from every surface are not equal")
    return float(changed.sum() / max(surfaces.sum(), 1)), wrong


def compare_state(state, effect, off, on, failed):
    """The largest share of surfaces that changed, and the errors."""
    name = state.name
    wrong = [f"{name}: {kind}: {batch_.result(name)['error']}" for kind, batch_ in (("without", off), ("with", on))
             if batch_.result(name)["error"]]
    off_shots, on_shots = off.shots(name), on.shots(name)
    if len(off_shots) != len(on_shots):
        wrong.append(f"{name}: {len(on_shots)} images instead of {len(off_shots)}")
    most = 0.0
    for number, files in enumerate(zip(off_shots, on_shots)):
        share, lines = compare_shot(state, effect, *files)
        most = max(most, share)
        if lines:
            wrong += keep_failure(failed, state, number, *files, lines)
    return most, wrong


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", required=True)
    parser.add_argument("--out", required=True)
    parser.add_argument("--effect", required=True, choices=EFFECTS)
    parser.add_argument("--group", default="")
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    states = [s for s in registry.load().values() if (s.name in given.names if given.names else given.group in ("", s.group))]
    if not states or len(states) < len(given.names):
        sys.exit(f"light.py: no such states: {given.group} {given.names}")
    effect = EFFECTS[given.effect]
    out, gluray = pathlib.Path(given.out).resolve() / "light", str(pathlib.Path(given.gluray).resolve())
    label, failed = given.group or ("some" if given.names else "all"), out / "failed" / given.effect
    wrong, skipped, changed = [], [], []
    for program in dict.fromkeys(s.program for s in states):
        chosen = [s for s in states if s.program == program]
        names, place = [s.name for s in chosen], f"{given.effect}-{label}-{program}"
        try:
            off = batch.draw_traced(program, names, out / "off" / place, gluray)
            on = batch.draw_traced(program, names, out / "on" / place, gluray, options(effect))
        except batch.Skipped as why:
            skipped.append(f"skipped: {program}: {why}")
            continue
        for state in chosen:
            most, lines = compare_state(state, effect, off, on, failed)
            print(f"{state.name:36} {state.program:8} {most:8.2%} of its surfaces changed")
            changed.append(most > 0)
            wrong += lines
    # Nothing hides the sky of a ball; what the real OpenGL draws stays, and so do insets.
    if sum(changed) < min(len(changed) / 4, 3):
        wrong.append(f"{given.effect} changes {sum(changed)} of {len(changed)} states")
    print("\n".join(skipped + wrong))
    return 1 if wrong else 77 if not changed else 0


if __name__ == "__main__":
    sys.exit(main())
