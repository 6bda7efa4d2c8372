"""What a reader sees of a look: a picture compared with the program's own.

All quantities are over the pixels of surfaces, all but the brightness without their outermost pixels, which smoothing mixes with the background. Under a light
at the viewer the outermost pixels are the darkest: the brightness of a picture with other light counts them. Luminance is that of displayed values, 0.2126 R + 0.7152 G + 0.0722 B, from 0 to 1.

The order of colours is that of the colour map, as surfaces without light show it, or that of the program's own picture, whichever the look is nearer to. The
own picture alone is no reference: its light brightens some values and darkens others, so that a picture in the very colours of the map may differ from it by
more than the limit allows.
"""
import dataclasses
import json
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
from support.options import Parser  # noqa: E402


def arguments():
    parser = Parser("Prints the figures of each scene as a line of JSON.")
    parser.add_argument("own", type=pathlib.Path, help="folder of the program's own pictures, made by draw.py --values")
    parser.add_argument("--values", type=pathlib.Path, help="folder of depths and scalars, made without --samples (OWN)")
    parser.add_argument("look", type=pathlib.Path, help="folder of the pictures to measure")
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    return parser.parse_args()


OPTIONS = arguments() if __name__ == "__main__" else None  # before the imports of what a machine may lack
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from rules import beyond  # noqa: E402

LOST_FROM, LOST_TO = 0.15, 0.06  # luminance of the program's own picture, and of one in which it is lost
COLORFUL = 0.1                   # chroma from which hues count
BINS = 32                        # of the colour map


@dataclasses.dataclass
class Measures:
    brightness: float  # mean luminance over that of the program's own picture
    lost: float        # share of pixels that became nearly black
    hue: float         # mean change of hue in degrees, of colourful pixels
    burnt: float       # share of pixels with a channel at 255 that was below 250
    order: float       # rank correlation of mean luminance along the colour map with the map's colours or the own picture; 1 without scalars
    depth: float       # spread (from the 10th to the 90th percentile) of luminance over the program's own, around their median


def luminance(image):
    return image @ (0.2126, 0.7152, 0.0722) / 255


def hue(image):
    """Degrees, and chroma from 0 to 1."""
    r, g, b = (image[..., i] / 255 for i in range(3))
    most, least = image.max(-1) / 255, image.min(-1) / 255
    chroma = most - least
    safe = np.where(chroma > 0, chroma, 1)
    sector = np.where(most == r, (g - b) / safe % 6, np.where(most == g, (b - r) / safe + 2, (r - g) / safe + 4))
    return 60 * sector, chroma


def inner(mask):
    """The pixels whose eight neighbours belong to the mask, too: edges that smoothing mixes with the background are left out."""
    padded = np.pad(mask, 1)
    height, width = mask.shape
    return np.logical_and.reduce([padded[y:y + height, x:x + width] for y in range(3) for x in range(3)])


def ranks(values):
    order = np.empty(len(values))
    order[np.argsort(values)] = np.arange(len(values))
    return order


def order_along_map(own, look, values):
    """Rank correlation between the luminance of both pictures over equal ranges of the scalar. `values`: bytes, 0: no scalar."""
    which = (values.astype(int) * BINS) // 256
    bins = [i for i in range(BINS) if ((which == i) & (values > 0)).sum() >= 50]
    if len(bins) < 3:
        return 1.0
    means = [[picture[(which == i) & (values > 0)].mean() for i in bins] for picture in (own, look)]
    return float(np.corrcoef(ranks(means[0]), ranks(means[1]))[0, 1])


def measure(own, look, surfaces, values, colors):
    """`own`, `look`, and `colors`, those of the map: bytes, height x width x 3; `surfaces`: of bools; `values`: bytes, height x width."""
    brightness = luminance(look[surfaces]).mean() / luminance(own[surfaces]).mean()
    surfaces = inner(surfaces)
    own, look, colors, values = own[surfaces].astype(float), look[surfaces].astype(float), colors[surfaces], values[surfaces]
    a, b = luminance(own), luminance(look)
    order = max(order_along_map(reference, b, values) for reference in (a, luminance(colors)))
    (hue_a, chroma_a), (hue_b, chroma_b) = hue(own), hue(look)
    colorful = (chroma_a > COLORFUL) & (chroma_b > COLORFUL)
    turned = np.abs((hue_b - hue_a + 180) % 360 - 180)[colorful]
    seen = a > LOST_TO
    gain = b[seen] / a[seen]
    low, middle, high = np.percentile(gain, (10, 50, 90)) if seen.any() else (1, 1, 1)
    return Measures(brightness=brightness, lost=float(((a > LOST_FROM) & (b < LOST_TO)).mean()), hue=float(turned.mean()) if turned.size else 0.0,
                    burnt=float(((look == 255) & (own < 250)).any(-1).mean()), order=order, depth=float((high - low) / max(middle, 1e-6)))


def figures_of(own, look, scene, values=None):
    """Measures of a scene whose pictures lie in the folders `own`, with its colours without light, `look`, and `values` (own), with its depths and scalars."""
    values = values or own
    read = lambda folder, end, mode: np.asarray(Image.open(folder / f"{scene}{end}").convert(mode))
    surfaces = np.load(values / f"{scene}.depth.npy") < 1
    return measure(read(own, ".png", "RGB"), read(look, ".png", "RGB"), surfaces, read(values, ".values.png", "L"), read(own, ".colors.png", "RGB"))


if __name__ == "__main__":
    for name in OPTIONS.scenes:
        found = vars(figures_of(OPTIONS.own, OPTIONS.look, name, OPTIONS.values))
        print(json.dumps({"scene": name, **{k: round(float(v), 4) for k, v in found.items()}, "beyond": beyond(found)}))
