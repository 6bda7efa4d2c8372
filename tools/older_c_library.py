"""Makes libraries and programs run with an older C library than the one that they were linked with.

The GNU C library keeps the versions that its functions had: a symbol of a newer version gets its newest version that the older
library has. That is the same function where it only moved (pthread_create, dlopen), and one with the same results where only
its treatment of errors changed (pow, hypot). Functions that have no such version come from a library of substitutes
(src/portable/substitutes.c).
"""
from __future__ import annotations

import re

from elf_library import Elf, Unsupported

C_LIBRARY = ("libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "ld-linux")
# Functions of C 2023, which read binary numbers ("0b1"), too; the others do otherwise the same.
C23 = "__isoc23_"
# Libraries that older C libraries have these functions in, and newer ones keep for old programs.
HOMES = {"libpthread.so.0": r"(__)?pthread_|sem_", "libdl.so.2": r"dl(v?sym|open|close|error|addr|info|mopen)"}


def number(version: str) -> tuple[int, ...] | None:
    """Of GLIBC_2.34: (2, 34)."""
    match = re.fullmatch(r"GLIBC_(\d+(?:\.\d+)*)", version)
    return tuple(map(int, match.group(1).split("."))) if match else None


class OlderCLibrary:
    """The C library of version `newest`, (2, 28) for instance, as the files of a newer one describe it."""

    def __init__(self, newest: tuple[int, ...], files: list[Elf], substitutes: Elf) -> None:
        self.newest = newest
        self.substitutes = substitutes
        self.versions: dict[str, list[str]] = {}
        for file in files:
            names = file.definitions()
            for symbol in range(file.first_export, len(file.symbols)):
                version = names.get(file.version_index(symbol), "")
                if number(version):
                    self.versions.setdefault(file.symbol_names[symbol], []).append(version)

    def newer(self, library: Elf) -> list[tuple[int, str, str]]:
        """Symbols of newer versions that others define (variables of which a program has the only copy, too): their index, the library, the version."""
        asked = ((i, *library.requirements.get(library.version_index(i), ("", "", 0))[:2]) for i in range(1, len(library.symbols)))
        return [(i, file, version) for i, file, version in asked if (number(version) or ()) > self.newest]

    def suit(self, library: Elf) -> dict[str, str]:
        """Lowers versions in `library`, before rename(), for which it returns names of substitutes."""
        replaced, lacking = {}, []
        for symbol, file, version in self.newer(library):
            name = library.symbol_names[symbol]
            plain = name.removeprefix(C23)
            older = max((v for v in self.versions.get(plain, []) if number(v) <= self.newest), key=number, default="")
            if older:
                library.require(symbol, file, older)
                if plain != name:
                    replaced[name] = plain
                for home, pattern in HOMES.items():
                    if re.match(pattern, name):
                        library.need(home)
            elif name + "_substitute" in self.substitutes.exports:
                library.require(symbol, file, "")
                replaced[name] = name + "_substitute"
            else:
                lacking.append(f"{name} ({version})")
        if any(new.endswith("_substitute") for new in replaced.values()):
            library.need(self.substitutes.path.name)
        if lacking:
            raise Unsupported(f"{library.path} needs functions that no older C library has: {', '.join(sorted(lacking))}")
        return replaced
