"""frames a second of ParaView (pvbatch): with its own OpenGL and with GLuRay

Contours of the Wavelet source, coloured by value, in a window of 1024x1024 with ParaView's own settings (FXAA on, orientation
axes), the camera in orbit. Measures with and without GLuRay in turn, round by round; results are medians. With GLuRay the orbit runs
for 5 seconds and 5 more for each million triangles before frames are measured, so that the better structure is in use; the
frames until then are the column "early". Results go to bench/results/NAME.json. Needs python3-paraview (scripts/setup installs it).
"""
import shutil
import sys

from support import pairs

SCRIPT = pairs.ROOT / "bench" / "support" / "paraview_orbit.py"
ISOVALUES = {1: 3, 4: 14, 16: 55, 32: 110}  # of the Wavelet on 201^3 points, by millions of triangles
GL_FRAMES = {1: 20, 4: 8, 16: 4, 32: 3}
RAY_FRAMES = {1: 60, 4: 40, 16: 30, 32: 24}


def arguments(argv):
    parser = pairs.parser("paraview", __doc__, "1,4,16", "millions of triangles (1,4,16; also 32)")
    parser.add_argument("--look", choices=["surface", "edges", "translucent", "summed"], default="surface",
                        help="how the surfaces are drawn (surface); translucent: opacity 0.4, depth peeling; summed: the same without peeling")
    options = pairs.parse(parser, argv)
    if any(size not in ISOVALUES for size in options.sizes):
        parser.error(f"sizes are {', '.join(map(str, ISOVALUES))}")
    return options


def main(argv):
    options = arguments(argv)
    if not shutil.which("pvbatch"):
        print("bench: pvbatch is missing: run scripts/setup (package python3-paraview)", file=sys.stderr)
        return 1

    def measure(size, environment):
        def command(frames, warm=0):
            return ["pvbatch", SCRIPT, ISOVALUES[size], frames[size], options.size, "-", options.look, warm]
        label = f"{size}M triangles"
        both = pairs.measure_size(options, label, command(GL_FRAMES), command(RAY_FRAMES, 5 + 5 * size), environment)
        pairs.add_stub_time(options, label, lambda n: command({size: n}), RAY_FRAMES[size], environment, both[1])
        return both
    return pairs.run("paraview", options, argv, measure)
