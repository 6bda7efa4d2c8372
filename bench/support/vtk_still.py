"""Run by python3 with VTK: a sphere, drawn so many times turned by a degree each, and so many times unchanged; prints one line of JSON.

usage: vtk_still.py RESOLUTION FRAMES [SAMPLES]
"""
import json
import sys
import time

import vtk


def main():
    resolution, frames = int(sys.argv[1]), int(sys.argv[2])
    source, mapper, actor = vtk.vtkSphereSource(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
    window.SetSize(1024, 1024)
    window.SetMultiSamples(int(sys.argv[3]) if len(sys.argv) > 3 else 0)
    window.AddRenderer(renderer)
    renderer.AddActor(actor)
    renderer.ResetCamera()
    for _ in range(2):
        window.Render()

    def milliseconds(degrees=None):
        """Milliseconds of a frame; without degrees nothing changes in between."""
        start = time.perf_counter()
        for _ in range(frames):
            if degrees is not None:
                renderer.GetActiveCamera().Azimuth(degrees)
            window.Render()
        return 1000 * (time.perf_counter() - start) / frames

    rounds = [(milliseconds(1), milliseconds()) for _ in range(3)]
    print(json.dumps({"triangles": source.GetOutput().GetNumberOfCells(), "moving_ms": [a for a, _ in rounds],
                      "unchanged_ms": [b for _, b in rounds]}))


main()
