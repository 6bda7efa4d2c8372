"""Copies the licence texts of the libraries that private_libraries.py has copied.

    library_licences.py --copies FOLDER --licences FOLDER --search DIRECTORY...

The text of LIBRARY goes to licences/LIBRARY.txt. It is the copyright file of the Debian package that the library comes from
(Debian Policy, 12.5). A library of no package gets no text; a line on standard error says so.
"""
from __future__ import annotations

import pathlib
import shutil
import subprocess
import sys

from command_line import Parser
from private_libraries import NAME_SUFFIX, Unsupported, find


def package_of(library: pathlib.Path) -> str | None:
    try:
        # By the file's name: packages may record /lib for /usr/lib.
        asked = subprocess.run(["dpkg-query", "--search", f"*/{library.name}"], capture_output=True, text=True)
    except FileNotFoundError:
        return None
    owners = [line.split(": ", 1) for line in asked.stdout.splitlines() if ": " in line]
    return next((names.split(",")[0].split(":")[0] for names, path in owners if pathlib.Path(path).resolve() == library), None)


def copy(copies: pathlib.Path, licences: pathlib.Path, folders: list[pathlib.Path]) -> None:
    """The texts for the libraries in `copies` to the folder `licences`, whose other files go. `folders`: where the libraries may lie."""
    shutil.rmtree(licences, ignore_errors=True)
    licences.mkdir(parents=True)
    for path in sorted(copies.glob("*" + NAME_SUFFIX)):
        name = path.name.removesuffix(NAME_SUFFIX)
        package = package_of(find(name, folders))
        text = pathlib.Path("/usr/share/doc") / (package or "") / "copyright"
        if package and text.is_file():
            shutil.copyfile(text, licences / f"{name}.txt")
        else:
            print(f"library_licences: {name} is of no Debian package; a package of GLuRay needs its licence text", file=sys.stderr)


def main(arguments: list[str]) -> None:
    parser = Parser(__doc__)
    parser.add_argument("--copies", type=pathlib.Path, required=True)
    parser.add_argument("--licences", type=pathlib.Path, required=True)
    parser.add_argument("--search", type=pathlib.Path, nargs="*", default=[])
    chosen = parser.parse_args(arguments)
    copy(chosen.copies, chosen.licences, chosen.search)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Unsupported as why:
        sys.exit(f"library_licences: {why}")
