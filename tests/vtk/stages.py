"""Stages: windows of ParaView or plain VTK in which states draw; their images and depth are written to files."""
import os
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "live"))
import images  # noqa: E402

WIDTH, HEIGHT = 400, 300
NEWER = {"Position": "Translation"}  # what ParaView 5.13 calls a representation's properties


class Stage:
    """Writes images as NAME-NUMBER.png and NAME-NUMBER.npy: window depth, float32, top row first."""

    def __init__(self, folder, name):
        self.folder, self.name, self.count = pathlib.Path(folder), name, 0
        self.counts = None  # runner.Counts where GLuRay counts
        self.steady = None  # what it counted while only the camera moved

    def keep(self, image, depth=None):
        """`image`: height x width x 3 bytes, top row first."""
        base = self.folder / f"{self.name}-{self.count}"
        images.write_png(base.with_suffix(".png"), np.ascontiguousarray(image))
        if depth is not None:
            np.save(base.with_suffix(".npy"), depth.astype(np.float32))
        self.count += 1

    def keep_text(self, lines):
        """Text beside a state's images, which must be equal with and without GLuRay."""
        with open(self.folder / f"{self.name}.txt", "a") as file:
            file.writelines(f"{line}\n" for line in lines)

    def read(self, window):
        """Colour and depth of a vtkRenderWindow as they stand after its last frame."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
        width, height = window.GetSize()
        colors, depth = vtkUnsignedCharArray(), vtkFloatArray()
        window.GetPixelData(0, 0, width - 1, height - 1, 0, colors, 0)
        window.GetZbufferData(0, 0, width - 1, height - 1, depth)
        self.keep(vtk_to_numpy(colors).reshape(height, width, -1)[::-1, :, :3].copy(),
                  vtk_to_numpy(depth).reshape(height, width)[::-1].copy())


    def counted(self, render, turn, frames=5):
        """Frames between which only the camera moves, after two frames of preparation; `steady` holds the counts of
        these frames."""
        for _ in range(2):
            render()
            turn()
        before = self.counts.fresh() if self.counts else None
        for _ in range(frames):
            render()
            turn()
        after = self.counts.fresh() if self.counts else None
        if before and after:
            self.steady = {name: value - before.get(name, 0) for name, value in after.items()}


class ParaViewStage(Stage):
    connected = False  # to the server that VTK_STATES_SERVER names

    def __init__(self, folder, name):
        super().__init__(folder, name)
        import paraview.simple
        self.simple = paraview.simple
        if "VTK_STATES_SERVER" in os.environ and not ParaViewStage.connected:
            host, port = os.environ["VTK_STATES_SERVER"].split(":")
            paraview.simple.Connect(host, int(port))
            ParaViewStage.connected = True
        self.settings, self.views = {}, []
        self.view = self.new_view()

    def new_view(self, **properties):
        size = properties.pop("ViewSize", [WIDTH, HEIGHT])
        view = self.simple.CreateRenderView(ViewSize=size, OrientationAxesVisibility=0, **properties)
        view.RemoteRenderThreshold = 0  # a server's data are drawn by the server
        self.views.append(view)
        return view

    def set(self, **settings):
        """Settings of all render views, put back when the state ends."""
        proxy = self.simple.GetSettingsProxy("RenderViewSettings")
        for name, value in settings.items():
            self.settings.setdefault(name, proxy.GetProperty(name).GetData())
            setattr(proxy, name, value)

    def change(self, display, **properties):
        for name, value in properties.items():
            newer = NEWER.get(name)
            setattr(display, newer if newer in display.ListProperties() else name, value)

    def show(self, source, view=None, color_by=None, **properties):
        """The representation of `source`. `color_by`: ("POINTS" or "CELLS", array)."""
        display = self.simple.Show(source, view or self.view)
        self.change(display, **properties)
        if color_by:
            self.simple.ColorBy(display, color_by)
            display.RescaleTransferFunctionToDataRange(True, False)
        return display

    def data(self, data):
        """A ParaView source that outputs a given vtkDataObject."""
        producer = self.simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(data)
        producer.UpdatePipeline()
        return producer

    def look(self, azimuth=30, elevation=25, zoom=1.0, view=None):
        view = view or self.view
        self.simple.ResetCamera(view)
        camera = view.GetActiveCamera()
        camera.Azimuth(azimuth)
        camera.Elevation(elevation)
        camera.Dolly(zoom)
        view.GetRenderer().ResetCameraClippingRange()

    def shoot(self, view=None):
        view = view or self.view
        self.simple.Render(view)
        self.read(view.GetRenderWindow())

    def orbit(self, frames=2, degrees=25, view=None):
        """Images of several frames between which only the camera moves."""
        view = view or self.view
        for frame in range(frames):
            if frame:
                view.GetActiveCamera().Azimuth(degrees)
                view.GetRenderer().ResetCameraClippingRange()
            self.shoot(view)

    def steady_orbit(self):
        def turn():
            self.view.GetActiveCamera().Azimuth(11)
            self.view.GetRenderer().ResetCameraClippingRange()

        self.counted(lambda: self.simple.Render(self.view), turn)
        self.shoot()

    def end(self):
        for view in self.views:
            self.simple.Delete(view)
        for source in list(self.simple.GetSources().values()):
            self.simple.Delete(source)
        # Colour maps belong to names of arrays, which states share.
        for group in ("lookup_tables", "piecewise_functions"):
            for function in list(self.simple.servermanager.ProxyManager().GetProxiesInGroup(group).values()):
                self.simple.Delete(function)
        proxy = self.simple.GetSettingsProxy("RenderViewSettings")
        for name, value in self.settings.items():
            setattr(proxy, name, value)


class VtkStage(Stage):
    def __init__(self, folder, name):
        super().__init__(folder, name)
        import vtk
        self.vtk = vtk
        self.window = vtk.vtkRenderWindow()
        self.window.SetSize(WIDTH, HEIGHT)
        self.window.SetMultiSamples(0)  # as many as the machine has otherwise
        self.renderer = self.new_renderer()

    def new_renderer(self, box=(0, 0, 1, 1), background=(0.2, 0.25, 0.35), layer=0):
        renderer = self.vtk.vtkRenderer()
        renderer.SetViewport(*box)
        renderer.SetBackground(*background)
        renderer.SetLayer(layer)
        self.window.SetNumberOfLayers(max(layer + 1, self.window.GetNumberOfLayers()))
        self.window.AddRenderer(renderer)
        return renderer

    def mapper(self, source):
        mapper = self.vtk.vtkPolyDataMapper()
        if isinstance(source, self.vtk.vtkDataObject):
            mapper.SetInputData(source)
        else:
            mapper.SetInputConnection(source.GetOutputPort())
        return mapper

    def show(self, source, color=(0.9, 0.6, 0.3), at=(0, 0, 0), renderer=None):
        """The vtkActor of a source, a vtkPolyData or a mapper."""
        actor = self.vtk.vtkActor()
        actor.SetMapper(source if isinstance(source, self.vtk.vtkMapper) else self.mapper(source))
        actor.GetProperty().SetColor(*color)
        actor.SetPosition(*at)
        (renderer or self.renderer).AddActor(actor)
        return actor

    def keep_selected(self, *places):
        """Numbers that VTK's selector finds in squares of five pixels, each from its lower left corner."""
        for x, y in places:
            picker = self.vtk.vtkHardwareSelector()
            picker.SetRenderer(self.renderer)
            picker.SetArea(x, y, x + 4, y + 4)
            found = picker.Select()
            self.keep_text([str(sorted(found.GetNode(i).GetSelectionList().GetValue(0) for i in range(found.GetNumberOfNodes())))])

    def look(self, azimuth=30, elevation=25, zoom=1.0, renderer=None):
        renderer = renderer or self.renderer
        renderer.ResetCamera()
        camera = renderer.GetActiveCamera()
        camera.Azimuth(azimuth)
        camera.Elevation(elevation)
        camera.Dolly(zoom)
        renderer.ResetCameraClippingRange()

    def shoot(self):
        self.window.Render()
        self.read(self.window)

    def orbit(self, frames=2, degrees=25):
        for frame in range(frames):
            if frame:
                for renderer in self.window.GetRenderers():
                    renderer.GetActiveCamera().Azimuth(degrees)
                    renderer.ResetCameraClippingRange()
            self.shoot()

    def steady_orbit(self):
        def turn():
            self.renderer.GetActiveCamera().Azimuth(11)
            self.renderer.ResetCameraClippingRange()

        self.counted(self.window.Render, turn)
        self.shoot()

    def end(self):
        self.window.Finalize()


def open_stage(program, folder, name):
    return (VtkStage if program in ("vtk", "newer_vtk") else ParaViewStage)(folder, name)
