"""Run by pvbatch, on any number of ranks: isosurfaces of ParaView's Wavelet source, cut among the ranks; prints one line of JSON on rank 0.

usage: pvbatch gather_orbit.py EXTENT ISOVALUES FRAMES
The picture has 1000x800 pixels; each frame turns the camera by 5 degrees. "frame_s" is the median of FRAMES frames after two others.
"""
import json
import statistics
import sys
import time

from paraview import simple


def main():
    extent, count, frames = map(int, sys.argv[1:4])
    low, high = 33.951, 286.341
    wavelet = simple.Wavelet(WholeExtent=[-extent, extent] * 3)
    values = [low + (i + 0.5) / count * (high - low) for i in range(count)]
    contour = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=values)
    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 800]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.9, 0.9, 1]
    simple.Show(contour, view)
    simple.ResetCamera(view)
    seconds = []
    for frame in range(frames + 2):
        simple.GetActiveCamera().Azimuth(5)
        begin = time.monotonic()
        simple.Render(view)
        if frame >= 2:
            seconds.append(time.monotonic() - begin)
    triangles = contour.GetDataInformation().GetNumberOfCells()  # of all ranks
    print(json.dumps({"frame_s": statistics.median(seconds), "triangles": triangles}), flush=True)


main()
