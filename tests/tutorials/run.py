"""Runs a tutorial as it stands: its files are the blocks that follow "Save ... as `NAME`", its commands the blocks of `sh`.

    run.py PAGE --gluray GLURAY --python FOLDER [--update]

Needs an X server of its own (tests/doors/with_display.py). Each picture that the page shows must have been made; --update puts it beside the page. Exit code 77:
a program that the page needs is not installed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from command_line import Parser  # noqa: E402

PATIENCE = 600  # seconds for a command
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"[Ss]ave (?:it )?as `([\w.-]+)`[^`]*$")
PICTURE = re.compile(r"!\[[^\]]*\]\(([\w.-]+\.png)\)")
PROGRAMS = ("pvbatch", "pvpython", "pymol")


def steps(text):
    """(file name or None for commands, text) of each block, in order."""
    for block in BLOCK.finditer(text):
        named = NAMED.search(text[:block.start()].rstrip().rstrip(":.").split("\n\n")[-1])
        if block[1] == "sh":
            yield None, block[2]
        elif named:
            yield named[1], block[2]


def whole_png(file):
    data = file.read_bytes() if file.exists() else b""
    return data.startswith(b"\x89PNG") and data.endswith(b"IEND\xaeB`\x82")


def run(page, gluray, python, update):
    text = page.read_text()
    commands = [line for name, block in steps(text) if name is None for line in block.splitlines()]
    missing = [name for name in PROGRAMS if any(name in line for line in commands) and not shutil.which(name)]
    if missing or (any("python3" in line for line in commands) and subprocess.run(["/usr/bin/python3", "-c", "import vtk"], capture_output=True).returncode):
        print("skipped:", *missing or ["VTK for Python"], "is not installed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        environment = {**os.environ, "PATH": f"{gluray.parent}:/usr/bin:/bin", "PYTHONPATH": str(python), "HOME": name, "XDG_CONFIG_HOME": name, "GLURAY_RUNTIME": f"{name}/run",
                       "QT_QPA_PLATFORM": "xcb"}
        environment.pop("GLURAY_ENGINE", None)
        for file, block in steps(text):
            if file:
                (folder / file).write_text(block)
                continue
            for line in filter(None, block.splitlines()):
                print("$", line, flush=True)
                if subprocess.run(line, shell=True, cwd=folder, env=environment, timeout=PATIENCE).returncode:
                    return 1
        for picture in PICTURE.findall(text):
            if not whole_png(folder / picture):
                print(f"{picture} was not made")
                return 1
            if update:
                shutil.copy(folder / picture, page.parent / picture)
    return 0


def main():
    parser = Parser(__doc__)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--gluray", type=pathlib.Path, required=True)
    parser.add_argument("--python", type=pathlib.Path, required=True, help="folder of the module gluray")
    parser.add_argument("--update", action="store_true", help="put the page's pictures beside it")
    options = parser.parse_args()
    return run(options.page, options.gluray.resolve(), options.python.resolve(), options.update)


if __name__ == "__main__":
    sys.exit(main())
