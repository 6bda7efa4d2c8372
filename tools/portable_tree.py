"""Makes an installed tree run from any folder and with older C and C++ libraries: docs/adr/0108.

    portable_tree.py --tree PREFIX --c-library VERSION --search DIRECTORY...

The tree is that of a build with GLURAY_PORTABLE, installed just now. Programs and libraries are stripped. The engine and the
worker's MPI modules get copies of what they need, the C++ runtime among them (private_libraries.py). All then ask for no C library newer than VERSION
(older_c_library.py). Raises Unsupported if something would still be asked of the machine that not every machine has.
"""
from __future__ import annotations

import pathlib
import subprocess
import sys

import library_licences
from command_line import Parser
from elf_library import Elf, Unsupported
from older_c_library import OlderCLibrary
from private_libraries import C_RUNTIMES, CXX_RUNTIME, NAME_SUFFIX, find, give_copies

PRIVATE = "lib/gluray/private"
OTHERS = ("libEGL.so", "libOpenGL.so", "libmpi.so", "libmpich.so", "libQt6")  # of the machine: without them there is no OSMesa, no job of many, no panel
WITH_COPIES = ("lib/gluray/libgluray-engine.so", "lib/gluray/libgluray-mpi-openmpi.so", "lib/gluray/libgluray-mpi-mpich.so")
WITH_QT = ("bin/gluray-panel",)  # Qt's C++ runtime is the machine's


def is_elf(path: pathlib.Path) -> bool:
    if path.is_symlink() or not path.is_file():
        return False
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def missing_elsewhere(elf: Elf, tree: pathlib.Path, c_library: OlderCLibrary) -> list[str]:
    """What the file asks of a machine that not every machine has."""
    qt = elf.path.relative_to(tree).as_posix() in WITH_QT
    allowed = (*C_RUNTIMES, *OTHERS, *((CXX_RUNTIME,) if qt else ()))
    libraries = [name for name in elf.needed if not name.startswith(allowed) and not (tree / PRIVATE / name).exists()]
    return libraries + [f"{elf.symbol_names[symbol]} ({version})" for symbol, _, version in c_library.newer(elf)]


def make_portable(tree: pathlib.Path, newest: str, folders: list[pathlib.Path]) -> None:
    private = tree / PRIVATE
    files = [path for path in sorted(tree.rglob("*")) if is_elf(path)]
    subprocess.run(["strip", "--strip-unneeded", *map(str, files)], check=True)
    c_library = OlderCLibrary(tuple(map(int, newest.split("."))), [Elf(find(name, [])) for name in ("libc.so.6", "libm.so.6")],
                              Elf(private / "libgluray-substitutes.so"))
    roots = [tree / name for name in WITH_COPIES if (tree / name).exists()]
    give_copies([Elf(path) for path in roots], private, folders, (*C_RUNTIMES, *OTHERS), c_library)
    for path in files:
        if path not in roots:
            elf = Elf(path)
            elf.rename({}, c_library.suit(elf))
            elf.save(path)
    for path in [*files, *private.glob("*" + NAME_SUFFIX)]:
        if found := missing_elsewhere(Elf(path), tree, c_library):
            raise Unsupported(f"{path} needs {', '.join(found)}")
    library_licences.copy(private, tree / "share/doc/gluray/licences", folders)


def main(arguments: list[str]) -> None:
    parser = Parser(__doc__)
    parser.add_argument("--tree", type=pathlib.Path, required=True)
    parser.add_argument("--c-library", metavar="VERSION", required=True)
    parser.add_argument("--search", type=pathlib.Path, nargs="*", default=[])
    chosen = parser.parse_args(arguments)
    make_portable(chosen.tree, chosen.c_library, chosen.search)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Unsupported as why:
        sys.exit(f"portable_tree: {why}")
