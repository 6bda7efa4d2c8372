"""Run by pvbatch: streamlines as tubes through isosurfaces of a field, with a colour legend, into a PNG. flow.py OUT.png"""
import sys

from paraview.simple import *  # noqa: F403

wave = Wavelet(WholeExtent=[-30, 30, -30, 30, -30, 30])  # noqa: F405
flow = Calculator(Input=wave, ResultArrayName="Flow")  # noqa: F405
flow.Function = "iHat*(sin(coordsZ/6)+cos(coordsY/6)) + jHat*(sin(coordsX/6)+cos(coordsZ/6)) + kHat*(sin(coordsY/6)+cos(coordsX/6))"
speed = Calculator(Input=flow, ResultArrayName="Speed", Function="mag(Flow)")  # noqa: F405
lines = StreamTracer(Input=speed, Vectors=["POINTS", "Flow"], SeedType="Point Cloud")  # noqa: F405
lines.SeedType.Radius, lines.SeedType.NumberOfPoints, lines.MaximumStreamlineLength = 26, 220, 70
tubes = Tube(Input=lines, Radius=0.42, NumberofSides=16)  # noqa: F405
view = GetActiveViewOrCreate("RenderView")  # noqa: F405
view.ViewSize, view.OrientationAxesVisibility = [680, 540], 0
view.UseColorPaletteForBackground, view.Background = 0, [1, 1, 1]
shown = Show(tubes, view)  # noqa: F405
ColorBy(shown, ("POINTS", "Speed"))  # noqa: F405
colors = GetColorTransferFunction("Speed")  # noqa: F405
colors.ApplyPreset("Viridis (matplotlib)", True)
legend = GetScalarBar(colors, view)  # noqa: F405
legend.TitleColor = legend.LabelColor = [0, 0, 0]
legend.ComponentTitle, legend.Title = "", "speed"
shown.SetScalarBarVisibility(view, True)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewAngle = [95, 62, 100], [0, -1, 0], 32
SaveScreenshot(sys.argv[1], view)  # noqa: F405
