"""A VTK program with a ground, a catcher and a background of GLuRay's settings: what it shows, and what stays.

Draws the same scene in child processes, one for each choice of settings, and compares their images."""

import os
import pathlib
import subprocess
import sys

try:
    import numpy
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    sys.exit(77)
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

SIZE = 200
LIGHT = ["shadows=on", "shadows.size=0", "lights=sun", "lights.elevation=60"]


def draw(path):
    """A ball over nothing, a text, and an orientation marker; transparent background."""
    renderer = vtk.vtkRenderer()
    source = vtk.vtkSphereSource()
    source.SetThetaResolution(32), source.SetPhiResolution(32)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1, 0.5, 0)
    renderer.AddActor(actor)
    text = vtk.vtkTextActor()
    text.SetInput("ground")
    text.SetPosition(5, SIZE - 25)
    renderer.AddViewProp(text)
    window = vtk.vtkRenderWindow()
    window.SetMultiSamples(0), window.SetAlphaBitPlanes(1), window.SetSize(SIZE, SIZE)
    window.SetOffScreenRendering(1)
    renderer.SetBackground(0, 0, 0), renderer.SetBackgroundAlpha(0)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(35)
    renderer.GetActiveCamera().Zoom(0.6)
    renderer.ResetCameraClippingRange()
    window.Render(), window.Render()
    pixels = vtk.vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, SIZE - 1, SIZE - 1, 1, pixels)
    numpy.save(path, vtk_to_numpy(pixels).reshape(SIZE, SIZE, 4))


def image(gluray, out, name, settings):
    """RGBA, bottom row first."""
    path = os.path.join(out, f"ground-{name}.npy")
    arguments = [argument for setting in settings for argument in ("--set", setting)]
    subprocess.run([gluray, "--set", "engine=always", *arguments, sys.executable, __file__, "--draw", path],
                   check=True, timeout=120)
    return numpy.load(path).astype(int)


def check(condition, what):
    if not condition:
        sys.exit("FAILED: " + what)


def main():
    parser = Parser(__doc__)
    parser.add_argument("--gluray")
    parser.add_argument("--out")
    parser.add_argument("--draw")
    options = parser.parse_args()
    if options.draw:
        return draw(options.draw)
    os.makedirs(options.out, exist_ok=True)

    def shows(name, *settings):
        return image(options.gluray, options.out, name, settings)

    before = shows("off", *LIGHT)
    empty = before[..., 3] == 0
    ball = (before[..., 0] > before[..., 2] + 20) & ~empty
    check(empty.mean() > 0.5 and ball.mean() > 0.03, "the scene is as the test expects it")

    plane = shows("plane", *LIGHT, "ground=plane")
    check((plane[: SIZE // 4, :, 3] == 255).all(), "the ground fills the view below the ball, far and near")
    local, grounded = shows("local"), shows("grounded", "ground=plane")
    check((local[ball] == grounded[ball]).all(), "without effects of light the ball stays as it is")
    check((local[empty] == 0).all() and (grounded[2, :, 0] > 20).all(), "the program's own light reaches it")
    grey = plane[: SIZE // 4, :, 0]
    check(grey.max() > 120, "the sun shines on the ground")

    catcher = shows("catcher", *LIGHT, "ground=catcher")
    shadow = catcher[empty][:, 3]
    check((shadow > 100).sum() > 200, "the ball's shadow is in alpha")
    check((shadow < 20).mean() > 0.5, "alpha is small where the sun shines")
    check(catcher[empty][:, :3].max() == 0, "a catcher has no colour")

    color = shows("color", *LIGHT, "background=color", "background.color=#0000ff")
    check((color[empty] == (0, 0, 255, 255)).all(), "the background is blue where nothing was drawn")
    check((color[ball] == before[ball]).all(), "the ball stays")

    rules = os.path.join(options.out, "ground-rules.toml")
    with open(rules, "w", encoding="utf-8") as file:
        file.write('[[rule]]\nhidden-from = ["camera"]\n')
    hidden = shows("hidden", *LIGHT, "ground=catcher", f"material.file={rules}")
    check((hidden[ball][:, 0] == 0).all(), "a ball that is hidden from the camera is not seen")
    check((hidden[..., 3] > 100).sum() > 200, "but casts its shadow")
    print("ground: all as it should be")


if __name__ == "__main__":
    main()
