"""The page of the paper's evaluation, its figures and meshes (no program is measured)."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
BENCH = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(BENCH))
from paper import engines, page, plan, results  # noqa: E402
from suites import paper as suite  # noqa: E402
from support.paper_samples import InFolder, measurement, result_of, small_rows  # noqa: E402


class Page(unittest.TestCase):
    def test_the_papers_figures_stand_beside_ours(self):
        text = page.page(result_of(small_rows()), {"figure7": "f/figure7.svg"})
        self.assertIn("| PV-Wavelet | 16 | 12.3 | 0.13 | 1.22 | 94.8 | 16.0 | 12.5 (10.4 to 13.9) | 0.25 (0.208 to 0.278) | 0.5 (0.417 to 0.556) "
                      "| 50 | 25 |", text)
        self.assertIn("| 4.00 | buffers | 25 (20.8 to 27.8) | 1 (0.833 to 1.11) | 2 (1.67 to 2.22) | 25 | 12.5 | 0.08 | 2 |", text)
        self.assertIn("| 16.00 | 0.8 | 2.4 | 70 | 70 | 4 | 2 |", text)
        self.assertIn("](f/figure7.svg)", text)
        self.assertNotIn("figure8.svg", text)
        self.assertIn("- a note.", text)
        self.assertIn("  - lines (ParaView, client)", text)

    def test_a_busy_machine_is_told(self):
        result = result_of(small_rows())
        self.assertNotIn("busy", page.page(result, {}))
        result["machine"]["load_before"] = 5.3
        self.assertIn("The machine was busy when the run began (load 5.3)", page.page(result, {}))

    def test_a_row_that_was_not_traced_is_no_comparison(self):
        row = results.row_of(plan.Row("PV-RMI", "ParaView", "buffers", "mixing", 2), {"gluray": [measurement(0.1, report={"draws": {"traced": 0}})]})
        self.assertIn("PV-RMI, ParaView, 2M: nothing was traced", page.page(result_of([row]), {}))

    def test_the_papers_ratios_are_those_of_its_table(self):
        said = {"PV-Wavelet": 94.85, "VI-Wavelet": 113.99, "PV-VPIC": 193.08, "VI-VPIC": 212.49, "EnSight-VPIC": 347.15, "PV-RMI": 180.71,
                "PV-RMO": 357.78, "VAPOR-Star": 95.60}
        for name, ratio in said.items():
            with self.subTest(name):
                self.assertAlmostEqual(plan.PAPER_TABLE[name]["gluray"] / plan.PAPER_TABLE[name]["mesa"] / ratio, 1, delta=0.002)


class Figures(InFolder):
    def test_they_are_drawn_and_the_same_again(self):
        file = self.folder / "r.json"
        file.write_text(json.dumps(result_of(small_rows())))
        for python in suite.PYTHONS:
            if pathlib.Path(python).exists() and subprocess.run([python, "-c", "import matplotlib"], capture_output=True, check=False).returncode == 0:
                break
        else:
            self.skipTest("no matplotlib")
        drawn = []
        for part in ("a", "b"):
            (self.folder / part).mkdir()
            done = subprocess.run([python, BENCH / "paper" / "figures.py", file, self.folder / part], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout.split()), (0, ["table1", "figure7", "figure8"]), done.stderr)
            drawn.append({path.name: path.read_bytes() for path in (self.folder / part).glob("*.svg")})
        self.assertEqual(drawn[0], drawn[1])
        self.assertTrue(all(text.startswith(b"<?xml") for text in drawn[0].values()))


class Meshes(InFolder):
    """measured_frames.py within Debian's Python, which has VTK."""
    LINE = ("import sys; sys.path.insert(0, sys.argv[1]); import measured_frames; m = measured_frames.read_mesh(sys.argv[2]);"
            "c = m.GetCell(1).GetPointIds(); print(m.GetNumberOfPolys(), m.GetPoint(3), [c.GetId(i) for i in range(3)], m.GetPointData().GetNormals().GetTuple(2))")

    def read(self, content):
        if subprocess.run(["/usr/bin/python3", "-c", "import vtkmodules.util.numpy_support"], capture_output=True, check=False).returncode:
            self.skipTest("no VTK for Python")
        file = self.folder / "a.mesh"
        file.write_bytes(content)
        return subprocess.run(["/usr/bin/python3", "-B", "-c", self.LINE, BENCH / "paper", file], capture_output=True, text=True, check=False)

    def test_two_triangles_come_as_they_are(self):
        corners = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 2]
        content = struct.pack("<16sQQ24f6I", b"GLuRay mesh 1\n", 4, 6, *corners, *[0, 0, 1] * 4, 0, 1, 2, 0, 2, 3)
        self.assertEqual(self.read(content).stdout, "2 (0.0, 1.0, 2.0) [0, 2, 3] (0.0, 0.0, 1.0)\n")
        self.assertIn("is not a mesh file of the benchmarks", self.read(content[:-4]).stderr)


class Gpu(InFolder):
    def told(self, answer):
        program = self.folder / "glxinfo"
        program.write_text(f"#!/bin/sh\ncat <<'END'\n{answer}\nEND\n")
        program.chmod(0o755)
        path = os.environ["PATH"]
        os.environ["PATH"] = f"{self.folder}:{path}"
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        return engines.gpu_renderer(":9")

    def test_software_is_no_gpu(self):
        self.assertEqual(self.told("OpenGL renderer string: llvmpipe (LLVM 15)")[0], None)
        self.assertEqual(self.told("Error: unable to open display")[0], None)

    def test_a_gpu_is_named(self):
        self.assertEqual(self.told("OpenGL vendor string: x\nOpenGL renderer string: NVIDIA H200/PCIe"), ("NVIDIA H200/PCIe", None))


if __name__ == "__main__":
    unittest.main()
