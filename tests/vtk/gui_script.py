"""The content of the ParaView window of gui.py: two render views, one of them split off a spreadsheet. Run by paraview --script."""
import os
import pathlib

import paraview.simple as simple

view = simple.GetActiveViewOrCreate("RenderView")
wavelet = simple.Wavelet()
simple.Show(wavelet, view).SetRepresentationType("Outline")
contour = simple.Contour(wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[130, 200])
simple.Show(contour, view).SetScalarBarVisibility(view, True)
simple.ResetCamera(view)
view.GetActiveCamera().Azimuth(30)

layout = simple.GetLayout()
layout.SplitHorizontal(0, 0.55)
other = simple.CreateView("RenderView")
simple.AssignViewToLayout(view=other, layout=layout, hint=2)
sphere = simple.Sphere(ThetaResolution=32, PhiResolution=32)
simple.Show(sphere, other).SetRepresentationType("Surface With Edges")
simple.ResetCamera(other)

layout.SplitVertical(2, 0.5)
sheet = simple.CreateView("SpreadSheetView")
simple.AssignViewToLayout(view=sheet, layout=layout, hint=6)
simple.Show(sphere, sheet)
simple.SetActiveView(view)
simple.SetActiveSource(contour)
simple.RenderAllViews()
pathlib.Path(os.environ["VTK_GUI_READY"]).touch()
