"""Shared by the measured Python programs: meshes from files, the benchmark's orbit, and frames measured as the client measures them.

Imported by paraview_program.py (within pvbatch) and vtk_program.py (within Debian's Python), both with VTK's numpy support.
"""
import json
import math
import os
import pathlib
import resource
import statistics
import struct
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_INT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

MAGIC = b"GLuRay mesh 1\n\0\0"
ELEVATION = math.radians(35.26)
IDLE_S = 0.1  # between the frames of a program that hardly moves


def read_mesh(path):
    """The mesh of a file by gluray-bench-paper-data as vtkPolyData, with 32 bits an index."""
    with open(path, "rb") as file:
        magic, vertices, indices = struct.unpack("<16sQQ", file.read(32))
        if magic != MAGIC or pathlib.Path(path).stat().st_size != 32 + 24 * vertices + 4 * indices:
            raise ValueError(f"{path} is not a mesh file of the benchmarks")
        positions = np.fromfile(file, "<f4", 3 * vertices).reshape(-1, 3)
        normals = np.fromfile(file, "<f4", 3 * vertices).reshape(-1, 3)
        corners = np.fromfile(file, "<i4", indices)
    offsets = np.arange(0, indices + 1, 3, dtype=np.int32)
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(positions))
    cells.SetData(numpy_to_vtk(offsets, array_type=VTK_INT), numpy_to_vtk(corners, array_type=VTK_INT))
    data.SetPoints(points)
    data.SetPolys(cells)
    shading = numpy_to_vtk(normals)
    shading.SetName("Normals")
    data.GetPointData().SetNormals(shading)
    data.kept = (positions, normals, corners, offsets)  # VTK reads them in place
    return data


def place(frame, frames, distance):
    """The camera's position in one of `frames` frames that go once around; it looks at the origin, +y is up."""
    azimuth = math.pi / 4 + 2 * math.pi * frame / max(frames, 1)
    flat = math.cos(ELEVATION)
    return [distance * flat * math.sin(azimuth), distance * math.sin(ELEVATION), distance * flat * math.cos(azimuth)]


def resident():
    """Bytes of memory of this process."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def quartiles(times):
    """First quartile, median and third quartile."""
    if len(times) < 2:
        return [times[0]] * 3
    return statistics.quantiles(times, n=4, method="inclusive")


def measure(options, triangles, draw_first, draw, renderer):
    """Prints one line of JSON. draw_first() shows the mesh for the first time, draw(position) from somewhere; both wait until all
    is drawn. renderer(): the name of the OpenGL."""
    before = resident()
    start = time.perf_counter()
    draw_first()
    first = time.perf_counter() - start
    start = time.perf_counter()
    while time.perf_counter() - start < options.warm:
        time.sleep(IDLE_S)
        draw(place(0, 1, options.distance))
    frames = options.frames
    if options.seconds:
        start = time.perf_counter()
        draw(place(1, max(frames, 2), options.distance))
        frames = min(frames, max(2, round(options.seconds / max(time.perf_counter() - start, 1e-4))))
    times = []
    for frame in range(1, frames + 1):
        start = time.perf_counter()
        draw(place(frame, frames, options.distance))
        times.append(time.perf_counter() - start)
    low, middle, high = quartiles(times)
    print(json.dumps({"triangles": triangles, "renderer": renderer(), "first_image_s": first, "frame_s": middle, "frame_low_s": low,
                      "frame_high_s": high, "frames": frames, "build_s": 0, "rss_bytes": resident() - before,
                      "peak_bytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}), flush=True)
