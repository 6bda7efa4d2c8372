#!/usr/bin/env python3
"""Makes the picture of the window of `gluray view` in docs/guide/pictures.md: a saved scene, turned, in a look.

The scene is that of bench/guide/draw.py, with VTK; bench/guide/view.py needs the program view_live of the build.

python3 bench/guide/view.py [--build build/release]
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "bench" / "guide"
sys.path[:0] = [str(HERE), str(ROOT / "bench")]
sys.dont_write_bytecode = True
import pictures  # noqa: E402
from support.display import NoDisplay, display  # noqa: E402
from support.options import Parser  # noqa: E402

OUT = ROOT / "docs" / "guide" / "view.png"
PYTHON = "/usr/bin/python3"  # Debian's, which has VTK
ROW = pictures.table()["guide/view"]
SCENE, LOOK, TURN = ROW["scene"], ROW["commands"][1].rsplit(" ", 1)[-1], ROW["turned"]
PATIENCE = 1800  # seconds


def main():
    parser = Parser(__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    build = parser.parse_args().build.resolve()
    gluray, live = build / "apps" / "gluray" / "gluray", build / "apps" / "panel" / "view_live"
    try:
        with display() as screen, tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "DISPLAY": screen, "QT_QPA_PLATFORM": "xcb", "GLURAY_RUNTIME": folder}
            scene = pathlib.Path(folder) / "bearing.gluray"
            program = [PYTHON, str(HERE / "draw.py"), SCENE, str(pathlib.Path(folder) / "own.png"), "--samples", "0"]
            subprocess.run([gluray, "run", "--shot", scene, "--quit", "--", *program], cwd=HERE, env=environment, timeout=PATIENCE, check=True)
            command = [live, build / "lib" / "gluray" / "libgluray-engine.so", gluray, scene.name, OUT, "--picture", LOOK, TURN]
            subprocess.run(command, cwd=folder, env=environment, timeout=PATIENCE, check=True)
    except NoDisplay as error:
        print(f"view: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
