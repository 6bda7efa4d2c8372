"""The wheel in a new virtual environment, with programs from PyPI: enabled in the process, with and without a screen; removed without a trace.

    wheel_test.py [--wheel FILE] [unittest arguments]     without FILE, scripts/package wheel makes one. Takes packages from PyPI.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = ("pyvista", "vedo", "f3d", "moderngl", "glcontext", "pyqtgraph", "PyOpenGL", "PySide6_Essentials")
# Each draws one surface. The first line is run before the library is imported.
SCENES = {
    "vtk": """
        import vtk
        source, mapper, actor = vtk.vtkSphereSource(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
        mapper.SetInputConnection(source.GetOutputPort()), actor.SetMapper(mapper)
        renderer, window = vtk.vtkRenderer(), vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1), window.AddRenderer(renderer), renderer.AddActor(actor), window.Render()
        """,
    "pyvista": """
        import pyvista
        plotter = pyvista.Plotter(off_screen=True)
        plotter.add_mesh(pyvista.Sphere()), plotter.screenshot("picture.png")
        """,
    "vedo": """
        import vedo
        vedo.settings.default_backend = "vtk"
        vedo.Plotter(offscreen=True).show(vedo.Sphere())
        """,
    "f3d": """
        import f3d, pyvista
        pyvista.Sphere().save("model.stl")
        engine = f3d.Engine.create(True)
        engine.scene.add("model.stl"), engine.window.render_to_image()
        """,
}
WITH_SCREEN = {
    "pyqtgraph": """
        import pyqtgraph, pyqtgraph.opengl as gl
        application, view = pyqtgraph.mkQApp(), gl.GLViewWidget()
        view.addItem(gl.GLMeshItem(meshdata=gl.MeshData.sphere(20, 20), shader="shaded")), view.show()
        for _ in range(20): application.processEvents()
        """,
}


def make_wheel(folder):
    done = subprocess.run([ROOT / "scripts/package", "wheel", folder], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"wheel: scripts/package wheel failed: {done.stderr[-2000:]}")
    return pathlib.Path(done.stdout.strip().splitlines()[-1])


class Wheel(unittest.TestCase):
    wheel = None

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gluray-wheel-")))
        cls.environment = cls.folder / "an environment"
        subprocess.run([sys.executable, "-m", "venv", cls.environment], check=True)
        cls.before = cls.files()
        subprocess.run([cls.environment / "bin/python", "-m", "pip", "install", "--quiet", cls.wheel or make_wheel(cls.folder / "made"), *PACKAGES],
                       check=True)

    @classmethod
    def files(cls):
        return {path.relative_to(cls.environment).as_posix() for path in cls.environment.rglob("*") if "__pycache__" not in path.parts}

    def run_python(self, *words, screen):
        clean = {name: value for name, value in os.environ.items() if not name.startswith("GLURAY") and name not in ("DISPLAY", "PYTHONPATH")}
        command = [self.environment / "bin/python", *words]
        if screen:
            command = [sys.executable, ROOT / "tests/doors/with_display.py", *command]
        return subprocess.run(command, capture_output=True, text=True, timeout=200, cwd=self.folder, env=clean)

    def traced(self, text, screen):
        lines = [line.strip() for line in text.strip().splitlines()]
        script = "\n".join(["import gluray, json", "assert gluray.enable({'engine': 'always'}, quiet=True)", *lines,
                            "print(json.dumps(gluray.report()['triangles']))"])
        done = self.run_python("-c", script, screen=screen)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(json.loads(done.stdout.strip().splitlines()[-1])["traced"], 0, done.stderr)

    def test_enabled_without_a_screen(self):
        for name, text in SCENES.items():
            with self.subTest(program=name):
                self.traced(text, screen=False)

    def test_enabled_with_a_screen(self):
        for name, text in {**SCENES, **WITH_SCREEN}.items():
            with self.subTest(program=name):
                self.traced(text, screen=True)

    def test_launched(self):
        report = self.folder / "report.json"
        lines = [line.strip() for line in SCENES["pyvista"].strip().splitlines()]
        (self.folder / "script.py").write_text("\n".join(lines))
        for command in (["-m", "gluray", "--engine", "always", "--report", report, "script.py"],):
            done = self.run_python(*command, screen=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreater(json.loads(report.read_text())["triangles"]["traced"], 0)
        said = subprocess.run([self.environment / "bin/gluray", "doctor"], capture_output=True, text=True)
        self.assertIn(f"the Python wheel in {self.environment}", " ".join(said.stdout.split()))

    def test_zz_removed_without_a_trace(self):
        subprocess.run([self.environment / "bin/python", "-m", "pip", "uninstall", "--quiet", "--yes", "gluray"], check=True)
        self.assertEqual([name for name in self.files() - self.before if "gluray" in name], [])


if __name__ == "__main__":
    words = sys.argv[1:]
    if words[:1] == ["--wheel"]:
        Wheel.wheel, words = pathlib.Path(words[1]).resolve(), words[2:]
    unittest.main(argv=sys.argv[:1] + words, verbosity=2)
