"""A batch program that draws a time series off the screen, and reads a picture of each step: series.py STEPS [FAILS]. After so many
steps it ends by a signal."""
import os
import sys

import vtk

steps, fails = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else -1
window, renderer = vtk.vtkRenderWindow(), vtk.vtkRenderer()
window.SetOffScreenRendering(True)
window.SetSize(120, 90)
window.AddRenderer(renderer)
sphere, mapper, actor = vtk.vtkSphereSource(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
mapper.SetInputConnection(sphere.GetOutputPort())
actor.SetMapper(mapper)
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(0, 0, 4)
for step in range(steps):
    if step == fails:
        os.abort()
    actor.SetVisibility(step != 2)  # an empty step
    sphere.SetRadius(0.4 + 0.1 * step)
    renderer.ResetCameraClippingRange()
    window.Render()  # a picture that nobody sees
    window.Render()
    reader, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    reader.SetInput(window)
    reader.ShouldRerenderOff()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(f"own-{step + 1}.png")
    writer.Write()
