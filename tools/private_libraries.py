"""Gives a library copies of the libraries that it needs, under names that nobody else has.

    private_libraries.py --library LIBRARY --folder FOLDER --search DIRECTORY...

The dynamic linker knows libraries by their DT_SONAME and functions by their names: in a process that holds another version of
a library, each may get the other's functions. Copies in FOLDER, of all that LIBRARY needs but the C and C++ runtimes,
get the suffix "-gluray" in their DT_SONAMEs and the suffix ".gluray" in the names of all that they export. LIBRARY, which must
have been linked just now, and the copies then refer to these names alone. Their code does not change.
"""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

from command_line import Parser
from elf_library import Elf, Unsupported
from older_c_library import OlderCLibrary

NAME_SUFFIX, SYMBOL_SUFFIX = "-gluray", ".gluray"
# Those of the process: memory and threads pass between it and the library, and exceptions unless the C++ runtime is copied.
C_RUNTIMES = ("libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "libgcc_s.so", "ld-linux", "linux-vdso")
CXX_RUNTIME = "libstdc++.so"


def is_runtime(name: str) -> bool:
    """Of C or C++."""
    return name.startswith((*C_RUNTIMES, CXX_RUNTIME))


def find(name: str, folders: list[pathlib.Path]) -> pathlib.Path:
    for folder in folders:
        if (folder / name).exists():
            return (folder / name).resolve()
    asked = subprocess.run(["cc", f"-print-file-name={name}"], check=True, capture_output=True, text=True).stdout.strip()
    if asked == name:
        raise Unsupported(f"library {name} is not found; name its directory by --search")
    return pathlib.Path(asked).resolve()


def closure(libraries: list[Elf], folders: list[pathlib.Path], shared: tuple[str, ...]) -> dict[str, Elf]:
    """The libraries to copy, by their names in DT_NEEDED: all but those whose names begin with one of `shared`."""
    found: dict[str, Elf] = {}
    waiting = [name for library in libraries for name in library.needed]
    while waiting:
        name = waiting.pop()
        if name in found or name.startswith(shared):
            continue
        found[name] = Elf(find(name, folders))
        waiting += found[name].needed
    return found


def give_copies(roots: list[Elf], folder: pathlib.Path, folders: list[pathlib.Path], shared: tuple[str, ...],
                older: OlderCLibrary | None = None) -> None:
    """Fills `folder` with the copies that `roots` need, and saves the roots. Other files there go, but the library of substitutes."""
    copies = closure(roots, folders, shared)
    kept = {name for elf in [*roots, *copies.values()] for name in elf.needed if name not in copies}
    # A name that a runtime has, too, replaces the runtime's: operator new, for example.
    runtime = {name for one in sorted(kept) if is_runtime(one) for name in Elf(find(one, [])).exports}
    libraries = {name: name + NAME_SUFFIX for name in copies}
    symbols = {name: name + SYMBOL_SUFFIX for elf in copies.values() for name in elf.exports if name and name not in runtime}
    folder.mkdir(parents=True, exist_ok=True)
    for elf in [*copies.values(), *roots]:
        replaced = older.suit(elf) if older else {}
        elf.rename(libraries, {**symbols, **replaced})
    for name, elf in copies.items():
        elf.look_in("$ORIGIN")
        elf.save(folder / libraries[name])
    for elf in roots:
        elf.look_in(f"$ORIGIN/{os.path.relpath(folder, elf.path.parent)}")
        elf.save(elf.path)
    ours = {*libraries.values(), older.substitutes.path.name if older else ""}
    for path in folder.iterdir():
        if path.name not in ours:
            path.unlink()


def main(arguments: list[str]) -> None:
    parser = Parser(__doc__)
    parser.add_argument("--library", type=pathlib.Path, required=True)
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--search", type=pathlib.Path, nargs="*", default=[])
    chosen = parser.parse_args(arguments)
    give_copies([Elf(chosen.library)], chosen.folder, chosen.search, (*C_RUNTIMES, CXX_RUNTIME))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Unsupported as why:
        sys.exit(f"private_libraries: {why}")
