"""Run by Debian's Python with Pillow: puts pictures of one height side by side, with a white gap, into a PNG that is as small as can be."""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from support.options import Parser  # noqa: E402

GAP = 8  # pixels


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("out", metavar="OUT.png")
    parser.add_argument("pictures", nargs="+", metavar="PICTURE.png")
    parser.add_argument("--labels", nargs="+", default=[], help="a line of text below each picture")
    return parser.parse_args()


OPTIONS = arguments()  # before the imports of what a machine may lack
from PIL import Image, ImageDraw, ImageFont  # noqa: E402

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def labelled(picture, text):
    """The picture with a line of text below it."""
    whole = Image.new("RGB", (picture.width, picture.height + 40), "white")
    whole.paste(picture, (0, 0))
    ImageDraw.Draw(whole).text((picture.width // 2, picture.height + 20), text, fill="black", anchor="mm", font=ImageFont.truetype(FONT, 17))
    return whole


def main(out, names, labels):
    pictures = [Image.open(name).convert("RGB") for name in names]
    if labels:
        pictures = [labelled(picture, text) for picture, text in zip(pictures, labels, strict=True)]
    both = Image.new("RGB", (sum(p.width for p in pictures) + GAP * (len(pictures) - 1), max(p.height for p in pictures)), "white")
    left = 0
    for picture in pictures:
        both.paste(picture, (left, 0))
        left += picture.width + GAP
    both.save(out, optimize=True)


main(OPTIONS.out, OPTIONS.pictures, OPTIONS.labels)
