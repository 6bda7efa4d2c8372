"""Films and repeats of saved scenes: films_test.py GLURAY CLIENT TOOLKIT, with an X server at hand. Films along paths are compared with
what VTK shows from the same cameras, where VTK is installed."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

from saved_case import GLURAY, PATIENCE, SavedCase, chunks, pixels

PYTHON = "/usr/bin/python3"  # Debian's own, for which Debian's VTK is built
HAS_VTK = subprocess.run([PYTHON, "-c", "import vtkmodules.vtkRenderingOpenGL2"], capture_output=True).returncode == 0
# Of cameras: position, focal point, up, view angle, parallel scale or 0.
FIRST, SECOND = [3, 2, 5, 0.1, 0, 0, 0, 1, 0, 25, 0], [-2, 3, -4, 0.2, 0.1, 0, 0.1, 1, 0, 35, 0]
FLAT, FLAT_SECOND = FIRST[:10] + [1.5], SECOND[:10] + [1.2]


def camera(values):
    height = {"parallel_scale": values[10]} if values[10] else {"view_angle": values[9]}
    return {"position": values[0:3], "focal_point": values[3:6], "up": values[6:9]} | height


def pvcc(values):
    """As ParaView writes cameras."""
    def of(name, numbers):
        elements = "".join(f'<Element index="{i}" value="{n}"/>' for i, n in enumerate(numbers))
        return f'<Property name="{name}" id="1.{name}" number_of_elements="{len(numbers)}">{elements}</Property>\n'
    return ('<?xml version="1.0"?>\n<PVCameraConfiguration description="ParaView camera configuration" version="1.0">\n'
            '<Proxy group="views" type="RenderView" id="1" servers="21">\n' + of("CameraPosition", values[0:3]) +
            of("CameraFocalPoint", values[3:6]) + of("CameraViewUp", values[6:9]) + of("CameraViewAngle", [values[9]]) +
            of("CameraParallelScale", [values[10] or 1]) + of("CameraParallelProjection", [int(values[10] > 0)]) +
            "</Proxy>\n</PVCameraConfiguration>\n")


def decoded(stream):
    """Width, height, and of each frame its planes, of a YUV4MPEG2 stream in 4:2:0."""
    head, _, rest = stream.partition(b"\n")
    words = head.decode().split()
    assert words[0] == "YUV4MPEG2", head
    values = {word[0]: word[1:] for word in words[1:] if word[0] != "X"}
    assert values["C"] == "420jpeg" and "XCOLORRANGE=LIMITED" in words, head
    width, height = int(values["W"]), int(values["H"])
    luma, chroma, frames = width * height, width * height // 4, []
    while rest:
        assert rest.startswith(b"FRAME\n")
        planes, rest = rest[6:6 + luma + 2 * chroma], rest[6 + luma + 2 * chroma:]
        assert len(planes) == luma + 2 * chroma
        frames.append((planes[:luma], planes[luma:luma + chroma], planes[luma + chroma:]))
    return values["F"], width, height, frames


def converted(rgba, width, height):
    """Luma of ITU-R BT.709 in 8 bits of limited range, and the mean colour differences of 2x2 pixels; of even sides."""
    rgb = [(rgba[i], rgba[i + 1], rgba[i + 2]) for i in range(0, len(rgba), 4)]
    y = [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in rgb]
    planes = [[16 + 219 * v / 255 for v in y], [], []]
    for row in range(0, height, 2):
        for column in range(0, width, 2):
            block = [row * width + column, row * width + column + 1, (row + 1) * width + column, (row + 1) * width + column + 1]
            planes[1].append(128 + 224 * sum(rgb[i][2] - y[i] for i in block) / 4 / 1.8556 / 255)
            planes[2].append(128 + 224 * sum(rgb[i][0] - y[i] for i in block) / 4 / 1.5748 / 255)
    return planes


class Films(SavedCase):
    def stream(self, *words):
        run = subprocess.run([GLURAY, "render", "scene.gluray", "-", "--y4m", *words], cwd=self.folder, env=self.environment,
                             capture_output=True, timeout=PATIENCE)
        self.assertEqual((run.returncode, run.stderr), (0, b""))
        return run.stdout

    def test_streams_are_the_pictures(self):
        self.saved()
        self.done("render", "scene.gluray", "turn-%d.png", "--turntable", "3", "--size", "80x60")
        rate, width, height, frames = decoded(self.stream("--turntable", "3", "--size", "80x60", "--fps", "29.97"))
        self.assertEqual((rate, width, height, len(frames)), ("2997:100", 80, 60, 3))
        for number, frame in enumerate(frames, 1):
            for got, wanted in zip(frame, converted(pixels(self.file(f"turn-{number}.png")), width, height)):
                self.assertLessEqual(max(abs(a - b) for a, b in zip(got, wanted)), 0.51, number)

    def test_streams_have_even_sides(self):
        self.saved()
        whole, odd = (decoded(self.stream("--size", size, "--no-overlays")) for size in ("80x60", "79x59"))
        self.assertEqual(odd[1:3], whole[1:3])
        luma = odd[3][0][0]
        self.assertEqual(luma[59 * 80:], luma[58 * 80:59 * 80])
        self.assertEqual(luma[79::80], luma[78::80])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_ffmpeg_reads_streams(self):
        self.saved()
        stream = self.stream("--turntable", "2", "--size", "80x60")
        run = subprocess.run(["ffmpeg", "-v", "error", "-i", "-", "-f", "rawvideo", "-pix_fmt", "yuv420p", "-"], input=stream,
                             capture_output=True, check=True)
        self.assertEqual((run.stdout, run.stderr), (b"".join(b"".join(frame) for frame in decoded(stream)[3]), b""))

    def test_nobody_need_read_a_stream(self):
        self.saved()
        process = subprocess.Popen([GLURAY, "render", "scene.gluray", "-", "--y4m", "--turntable", "50", "--size", "640x480"],
                                   cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.read(1000)
        process.stdout.close()
        said = process.stderr.read().decode()
        process.stderr.close()
        self.assertEqual(process.wait(PATIENCE), 1)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertIn("nobody reads", said)

    def test_streams_do_not_fill_terminals(self):
        self.saved()
        ours, terminal = os.openpty()
        run = subprocess.run([GLURAY, "render", "scene.gluray", "-", "--y4m"], cwd=self.folder, env=self.environment, stdout=terminal,
                             stderr=subprocess.PIPE, text=True)
        os.close(terminal), os.close(ours)
        self.assertEqual((run.returncode, run.stderr.count("\n")), (1, 1))
        self.assertIn("is a terminal", run.stderr)

    def with_command(self, picture, command):
        """A copy of the picture that says something else made it. Checksums of texts are not looked at."""
        changed, whole = b"", picture.read_bytes()
        for kind, content in chunks(picture):
            if kind == "iTXt" and content.startswith(b"Command\0"):
                content = b"Command\0\0\0\0\0" + command.encode()
            changed += len(content).to_bytes(4, "big") + kind.encode() + content + bytes(4)
        other = self.file("tampered.png")
        other.write_bytes(whole[:8] + changed)
        return other.name

    def test_pictures_are_made_again(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png", "--size", "90x70", "--ao", "--set", "ao.samples=4", "--fit", "crop")
        before = self.file("picture.png").read_bytes()
        self.file("moved.png").write_bytes(before)
        self.file("picture.png").unlink()
        self.done("render", "--again", "moved.png")
        self.file("before.png").write_bytes(before)
        self.assertTrue(pixels(self.file("moved.png")) == pixels(self.file("before.png")))
        first = self.file("moved.png").read_bytes()  # with its new name in the command
        self.done("render", "--again", "moved.png")
        self.assertTrue(self.file("moved.png").read_bytes() == first)
        self.assertFalse(self.file("picture.png").exists())
        self.done("render", "scene.gluray", "turn-%d.png", "--turntable", "3", "--size", "40x30")
        films = {name: self.file(name).read_bytes() for name in ("turn-1.png", "turn-2.png", "turn-3.png")}
        self.file("turn-3.png").unlink()
        self.done("render", "--again", "turn-2.png")
        self.assertTrue(films == {name: self.file(name).read_bytes() for name in films})

    def test_shots_are_made_again(self):
        self.start()
        self.done("shot", "shot.png", "--size", "90x70")
        self.file("first.png").write_bytes(self.file("shot.png").read_bytes())
        said = self.done("shot", "--again", "shot.png").stdout
        self.assertIn("shot.png, 90 x 70", said)
        self.same("shot.png", "first.png")
        before = self.file("shot.png").read_bytes()
        self.refused(1, ["render", "--again", "shot.png"], "use gluray shot --again")
        self.done("set", "ao=true")
        self.refused(1, ["shot", "--again", "shot.png"], "another one than that of the picture")
        self.assertTrue(self.file("shot.png").read_bytes() == before)

    def test_other_scenes_are_not_taken(self):
        scene = self.saved()
        self.done("render", "scene.gluray", "picture.png")
        self.file("first.png").write_bytes(self.file("picture.png").read_bytes())
        self.done("save", "again.gluray")  # the same, later
        self.file("again.gluray").replace(scene)
        self.done("render", "--again", "picture.png")
        self.same("picture.png", "first.png")
        before = self.file("picture.png").read_bytes()
        self.done("set", "ao=true")
        self.done("save", "scene.gluray")
        self.refused(1, ["render", "--again", "picture.png"], "another one than that of the picture")
        scene.unlink()
        self.refused(1, ["render", "--again", "picture.png"], "No such file")
        self.assertTrue(self.file("picture.png").read_bytes() == before)

    def test_only_commands_of_pictures_are_repeated(self):
        self.saved()
        self.done("render", "scene.gluray", "picture.png", "--size", "40x30")
        for command in ("touch ran", "gluray run touch ran", "gluray render scene.gluray x.png; touch ran", "gluray render $(touch ran) x.png",
                        "gluray hub", "gluray render --again picture.png", "gluray render scene.gluray x.png --help",
                        "gluray render scene.gluray x.png --wrong", "gluray render scene.gluray - --y4m", "gluray", "", "gluray render 'x"):
            self.refused(1, ["render", "--again", self.with_command(self.file("picture.png"), command)], "tampered.png: ")
        self.done("render", "--again", self.with_command(self.file("picture.png"), "gluray render scene.gluray /tmp/elsewhere/x.png --size 40x30"))
        self.assertEqual(self.names(), ["picture.png", "scene.gluray", "tampered.png"])
        self.refused(2, ["render", "--again", "picture.png", "--size", "5x5"], "--again")
        self.refused(1, ["render", "--again", "scene.gluray"], "no PNG file")
        self.refused(1, ["render", "--again", "missing.png"], "cannot be read")

    def test_mistakes_get_one_line(self):
        self.saved()
        self.file("path.json").write_text(json.dumps({"cameras": [camera(FIRST)]}))
        self.refused(1, ["render", "scene.gluray", "x.png", "--path", "path.json"], "--saved-camera")
        self.refused(1, ["render", "scene.gluray", "x.png", "--path", "missing.json"], "No such file")
        self.refused(1, ["render", "scene.gluray", "x.png", "--path", "scene.gluray"], "use one .json or .pvsm file")
        self.refused(2, ["render", "scene.gluray", "x.png", "--path", "path.json", "--turntable", "3"], "--turntable")
        self.refused(2, ["render", "scene.gluray", "x.png", "--frames", "3"], "--path")
        self.refused(2, ["render", "scene.gluray", "x.png", "--y4m"], "both")
        self.refused(2, ["render", "scene.gluray", "-"], "both")
        self.refused(2, ["render", "scene.gluray", "-", "--y4m", "--json"], "--json")
        self.refused(2, ["render", "scene.gluray", "-", "--y4m", "--fps", "0"], "--fps")
        self.refused(2, ["render", "scene.gluray", "-", "--y4m", "--background", "transparent"], "transparency")
        self.refused(2, ["render", "scene.gluray"], "FILE is required")
        self.assertEqual(self.names(), ["path.json", "scene.gluray"])


@unittest.skipUnless(HAS_VTK, "VTK is not installed")
class Paths(SavedCase):
    def look(self, values):
        print(*values, file=self.client.stdin, flush=True)
        self.assertEqual(self.client.stdout.readline(), "shown\n")

    def start_vtk(self):
        self.spawn(GLURAY, "hub", "--with-parent")
        self.client = self.spawn(GLURAY, "--", PYTHON, str(pathlib.Path(__file__).with_name("vtk_scene.py")))
        self.look(FIRST)
        end = time.monotonic() + PATIENCE
        while not json.loads(self.gluray("list", "--json").stdout or "[]"):
            self.assertLess(time.monotonic(), end)

    def test_cameras_are_those_of_vtk(self):
        self.start_vtk()
        for name, first, second in (("deep", FIRST, SECOND), ("flat", FLAT, FLAT_SECOND)):
            self.look(first)
            self.done("save", f"{name}.gluray")
            self.look(second)
            self.done("shot", f"{name}-second.png")
            self.done("render", f"{name}.gluray", f"{name}-first.png", "--no-overlays")
            self.file("path.json").write_text(json.dumps({"cameras": [camera(first), camera(second)]}))
            self.done("render", f"{name}.gluray", "path-%d.png", "--path", "path.json")
            self.same("path-1.png", f"{name}-first.png")
            self.same("path-2.png", f"{name}-second.png")
            for number, values in enumerate((first, second)):
                self.file(f"{number}.pvcc").write_text(pvcc(values))
            self.done("render", f"{name}.gluray", "pv-%d.png", "--path", "0.pvcc", "--path", "1.pvcc", "--frames", "3")
            self.same("pv-1.png", f"{name}-first.png")
            self.same("pv-3.png", f"{name}-second.png")
            self.refused(1, ["render", f"{name}.gluray", "one.png", "--path", "1.pvcc"], "--saved-camera")
            self.done("render", f"{name}.gluray", "one.png", "--path", "1.pvcc", "--saved-camera", "0.pvcc")
            self.same("one.png", f"{name}-second.png")
            self.refused(1, ["render", f"{name}.gluray", "x.png", "--path", "1.pvcc", "--saved-camera", "1.pvcc"], "not the camera")

    def test_pictures_of_a_still_camera_are_equal(self):
        self.start_vtk()
        self.done("save", "scene.gluray")
        self.file("path.json").write_text(json.dumps({"cameras": [camera(FIRST), camera(SECOND), camera(SECOND)]}))
        self.done("render", "scene.gluray", "path-%d.png", "--path", "path.json", "--ao", "--set", "ao.samples=2", "--set", "denoise=off",
                  "--set", "refine.passes=1")
        self.same("path-2.png", "path-3.png")

    def test_paths_are_repeated_with_their_cameras(self):
        self.start_vtk()
        self.done("save", "scene.gluray")
        path = self.file("path.json")
        path.write_text(json.dumps({"cameras": [camera(FIRST), camera(SECOND)]}))
        self.done("render", "scene.gluray", "path-%d.png", "--path", "path.json", "--frames", "3")
        before = self.file("path-2.png").read_bytes()
        self.done("render", "--again", "path-2.png")
        self.assertTrue(self.file("path-2.png").read_bytes() == before)
        path.write_text(json.dumps({"cameras": [camera(FIRST), camera(FIRST)]}))
        self.refused(1, ["render", "--again", "path-2.png"], "cameras of the path")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
