"""Options of the measured Python programs."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
from options import Parser  # noqa: E402


def arguments(description):
    parser = Parser(description)
    parser.add_argument("--mesh", required=True, help="file by gluray-bench-paper-data")
    parser.add_argument("--distance", type=float, default=669.2, help="of the camera from the origin (669.2)")
    parser.add_argument("--frames", type=int, default=60, help="largest number of frames (60)")
    parser.add_argument("--seconds", type=float, default=2, help="time of the measurement (2)")
    parser.add_argument("--warm", type=float, default=0, help="seconds of slow frames before it (0)")
    parser.add_argument("--size", type=int, default=1024, help="pixels of the image, both ways (1024)")
    parser.add_argument("--dump", help="PNG file of the first image of the orbit")
    return parser.parse_args()
