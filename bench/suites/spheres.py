"""frames a second of VTK's sphere impostors: with its own OpenGL and with GLuRay

Clouds of spheres by vtkOpenGLSphereMapper in a window of 1024x1024, the camera in orbit. Measures with and without GLuRay in turn,
round by round; results are medians; "Mtri" counts spheres. Results go to bench/results/NAME.json. Needs python3-paraview.
"""
from support import pairs

PROGRAM = ["/usr/bin/python3", pairs.ROOT / "bench" / "support" / "sphere_orbit.py"]
GL_FRAMES, RAY_FRAMES = 8, 40


def main(argv):
    options = pairs.parse(pairs.parser("spheres", __doc__, "1,4", "millions of spheres (1,4)"), argv)

    def measure(size, environment):
        def command(frames):
            return [*PROGRAM, size * 1_000_000, frames, options.size]
        return pairs.measure_size(options, f"{size}M spheres", command(GL_FRAMES), command(RAY_FRAMES), environment)
    return pairs.run("spheres", options, argv, measure)
