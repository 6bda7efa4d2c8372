"""Windows under VTK's FXAA get better while the program waits: fxaa_test.py GLURAY, with an X server at hand."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

# More passes than the program's own frames have time for, however fast the machine is.
OCCLUSION = ("--ao", "--set", "ao.samples=4", "--set", "noise=0.0001", "--set", "refine.passes=40")
SCRIPT = """
import sys, time
import vtk
source = vtk.vtkRTAnalyticSource()
contour = vtk.vtkContourFilter()
contour.SetInputConnection(source.GetOutputPort())
contour.SetValue(0, 150)
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(contour.GetOutputPort())
mapper.ScalarVisibilityOff()
actor = vtk.vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().EdgeVisibilityOn()  # contrast everywhere, which FXAA changes
renderer = vtk.vtkRenderer()
renderer.AddActor(actor)
renderer.SetBackground(0.2, 0.3, 0.4)
renderer.SetUseFXAA(sys.argv[1] == "on")
window = vtk.vtkRenderWindow()
window.SetMultiSamples(0)
window.SetSize(200, 200)
window.AddRenderer(renderer)
window.Render()
window.Render()
time.sleep(5)
"""


class Fxaa(unittest.TestCase):
    def idle(self, fxaa, *options):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            subprocess.run([GLURAY, "--report", report, *OCCLUSION, *options, "--", "/usr/bin/python3", "-c", SCRIPT, fxaa],
                           capture_output=True, timeout=100, check=True)
            return json.loads(report.read_text())["light"]["idle"]

    def test_windows_are_refined_with_and_without_fxaa(self):
        for fxaa in ("off", "on"):
            idle = self.idle(fxaa)
            print(f"FXAA {fxaa}: {idle}")
            self.assertEqual(idle["refused"], 0, fxaa)
            self.assertGreaterEqual(idle["shown"], 1, fxaa)
            self.assertEqual(idle["finished"], 1, fxaa)

    def test_what_opengl_filters_is_left_alone(self):
        idle = self.idle("on", "--quirk", "software-fxaa=off")
        self.assertEqual((idle["refused"], idle["shown"]), (1, 0))


if __name__ == "__main__":
    GLURAY = sys.argv[1]
    if subprocess.run(["/usr/bin/python3", "-c", "import vtk"], capture_output=True).returncode:
        print("no VTK")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
