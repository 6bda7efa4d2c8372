"""Gives a library copies of the libraries that it needs, under names that nobody else has.

    private_libraries.py --library LIBRARY --folder FOLDER --search DIRECTORY... [--shared NAME...]

The dynamic linker knows libraries by their DT_SONAME and functions by their names: in a process that holds another version of
a library, each may get the other's functions. Copies in FOLDER, of all that LIBRARY needs but the C and C++ runtimes and NAMEs,
get the suffix "-gluray" in their DT_SONAMEs and the suffix ".gluray" in the names of all that they export. LIBRARY, which must
have been linked just now, and the copies then refer to these names alone. Their code does not change.

Files: ELF of 64 bits, little endian. The new names and hash tables are appended and mapped by the program header of a note.
Format: System V ABI, chapters 4 and 5; DT_GNU_HASH as the GNU C library reads it. Raises Unsupported for files of another kind.
"""
from __future__ import annotations

import pathlib
import struct
import subprocess
import sys

from command_line import Parser

NAME_SUFFIX, SYMBOL_SUFFIX = "-gluray", ".gluray"
# Those of the process: exceptions, memory and threads pass between it and the library.
RUNTIMES = ("libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "libgcc_s.so", "libstdc++.so", "ld-linux", "linux-vdso")
PT_LOAD, PT_DYNAMIC, PT_NOTE = 1, 2, 4
DT_NULL, DT_NEEDED, DT_PLTRELSZ, DT_HASH, DT_STRTAB, DT_SYMTAB, DT_RELA, DT_RELASZ = 0, 1, 2, 4, 5, 6, 7, 8
DT_STRSZ, DT_SONAME, DT_RPATH, DT_JMPREL, DT_RUNPATH = 10, 14, 15, 23, 29
DT_GNU_HASH, DT_VERSYM, DT_VERDEF, DT_VERDEFNUM, DT_VERNEED, DT_VERNEEDNUM = (
    0x6FFFFEF5, 0x6FFFFFF0, 0x6FFFFFFC, 0x6FFFFFFD, 0x6FFFFFFE, 0x6FFFFFFF)
PAGE, SYMBOL_BYTES, RELA_BYTES, SECTION_BYTES = 4096, 24, 24, 64


class Unsupported(Exception):
    """A file that this tool cannot change; str() says which and why."""


def gnu_hash(name: bytes) -> int:
    value = 5381
    for byte in name:
        value = (value * 33 + byte) & 0xFFFFFFFF
    return value


class Elf:
    """A shared library. Names are read at once and written by save()."""

    def __init__(self, path: pathlib.Path) -> None:
        self.path = path
        self.data = bytearray(path.read_bytes())
        if self.data[:6] != b"\x7fELF\x02\x01":
            raise Unsupported(f"{path} is no ELF file of 64 bits, little endian")
        self.programs, self.sections = (struct.unpack_from("<Q", self.data, at)[0] for at in (32, 40))
        self.program_count, self.section_count, self.names_section = (
            struct.unpack_from("<H", self.data, at)[0] for at in (56, 60, 62))
        self.segments = [list(struct.unpack_from("<IIQQQQQQ", self.data, self.programs + 56 * i)) for i in range(self.program_count)]
        self.read_dynamic()
        self.read_symbols()

    def offset(self, address: int) -> int:
        """The place in the file of an address in memory."""
        for kind, _, start, begin, _, size, _, _ in self.segments:
            if kind == PT_LOAD and begin <= address < begin + size:
                return address - begin + start
        raise Unsupported(f"{self.path} has no segment with address {address:#x}")

    def read_dynamic(self) -> None:
        found = [s for s in self.segments if s[0] == PT_DYNAMIC]
        if not found:
            raise Unsupported(f"{self.path} is not linked dynamically")
        self.dynamic_at, self.dynamic_slots = found[0][2], found[0][5] // 16
        entries = [struct.unpack_from("<qQ", self.data, self.dynamic_at + 16 * i) for i in range(self.dynamic_slots)]
        end = next((i for i, (tag, _) in enumerate(entries) if tag == DT_NULL), len(entries))
        self.dynamic = entries[:end]
        self.values = {tag: value for tag, value in self.dynamic if tag != DT_NEEDED}
        if DT_GNU_HASH not in self.values:
            raise Unsupported(f"{self.path} has no DT_GNU_HASH")
        start = self.offset(self.values[DT_STRTAB])
        self.strings = bytes(self.data[start:start + self.values[DT_STRSZ]])
        self.needed = [self.string(value) for tag, value in self.dynamic if tag == DT_NEEDED]

    def string(self, at: int) -> str:
        return self.strings[at:self.strings.index(b"\0", at)].decode()

    def read_symbols(self) -> None:
        at = self.offset(self.values[DT_GNU_HASH])
        buckets, self.first_export, bloom, self.bloom_shift = struct.unpack_from("<IIII", self.data, at)
        chains_at = at + 16 + 8 * bloom + 4 * buckets
        heads = struct.unpack_from(f"<{buckets}I", self.data, at + 16 + 8 * bloom)
        count = last = max(heads, default=0)
        if last >= self.first_export:
            while not struct.unpack_from("<I", self.data, chains_at + 4 * (last - self.first_export))[0] & 1:
                last += 1
            count = last + 1
        else:
            count = self.first_export
        table = self.offset(self.values[DT_SYMTAB])
        self.symbols = [self.data[table + SYMBOL_BYTES * i:table + SYMBOL_BYTES * (i + 1)] for i in range(count)]
        self.symbol_names = [self.string(struct.unpack_from("<I", s)[0]) for s in self.symbols]

    @property
    def exports(self) -> set[str]:
        return set(self.symbol_names[self.first_export:])

    def rename(self, libraries: dict[str, str], symbols: dict[str, str]) -> None:
        """Names of libraries in DT_NEEDED, DT_SONAME and requirements of versions, and of symbols, by these tables.

        DT_HASH, whose order would have to be kept, goes: the GNU C library reads DT_GNU_HASH.
        """
        self.dynamic = [(tag, value) for tag, value in self.dynamic if tag != DT_HASH]
        self.new_strings = bytearray(b"\0")
        self.string_places: dict[str, int] = {"": 0}
        self.rename_versions(libraries)
        self.symbol_names = [symbols.get(name, name) for name in self.symbol_names]
        named = (DT_NEEDED, DT_SONAME, DT_RPATH, DT_RUNPATH)
        self.dynamic = [(tag, self.place(libraries.get(self.string(value), self.string(value))) if tag in named else value)
                        for tag, value in self.dynamic]

    def place(self, text: str) -> int:
        """Where the text stands in the new strings; it is added at its first use."""
        if text not in self.string_places:
            self.string_places[text] = len(self.new_strings)
            self.new_strings += text.encode() + b"\0"
        return self.string_places[text]

    def put_string(self, at: int, table: dict[str, str]) -> None:
        old = self.string(struct.unpack_from("<I", self.data, at)[0])
        struct.pack_into("<I", self.data, at, self.place(table.get(old, old)))

    def rename_versions(self, libraries: dict[str, str]) -> None:
        at = self.offset(self.values[DT_VERNEED]) if DT_VERNEED in self.values else 0
        for _ in range(self.values.get(DT_VERNEEDNUM, 0)):
            count, _, aux, following = struct.unpack_from("<HIII", self.data, at + 2)
            self.put_string(at + 4, libraries)
            entry = at + aux
            for _ in range(count):
                self.put_string(entry + 8, {})
                entry += struct.unpack_from("<I", self.data, entry + 12)[0]
            at += following
        at = self.offset(self.values[DT_VERDEF]) if DT_VERDEF in self.values else 0
        for _ in range(self.values.get(DT_VERDEFNUM, 0)):
            count, _, aux, following = struct.unpack_from("<HIII", self.data, at + 6)
            entry = at + aux
            for _ in range(count):
                self.put_string(entry, libraries)
                entry += struct.unpack_from("<I", self.data, entry + 4)[0]
            at += following

    def look_beside(self) -> None:
        """Needed libraries are searched for in the library's own folder."""
        self.dynamic = [(tag, value) for tag, value in self.dynamic if tag not in (DT_RPATH, DT_RUNPATH)]
        self.dynamic.append((DT_RUNPATH, self.place("$ORIGIN")))

    def sort_exports(self, buckets: int) -> None:
        """Exported symbols in the order of their buckets, as DT_GNU_HASH needs them; relocations follow."""
        first, count = self.first_export, len(self.symbols)
        order = sorted(range(first, count), key=lambda i: (gnu_hash(self.symbol_names[i].encode()) % buckets, i))
        moved = {old: first + i for i, old in enumerate(order)}
        self.symbols[first:] = [self.symbols[i] for i in order]
        self.symbol_names[first:] = [self.symbol_names[i] for i in order]
        if DT_VERSYM in self.values:
            at = self.offset(self.values[DT_VERSYM])
            versions = [struct.unpack_from("<H", self.data, at + 2 * i)[0] for i in order]
            struct.pack_into(f"<{len(versions)}H", self.data, at + 2 * first, *versions)
        for table, size in ((DT_RELA, DT_RELASZ), (DT_JMPREL, DT_PLTRELSZ)):
            if table not in self.values:
                continue
            start = self.offset(self.values[table])
            for at in range(start + 8, start + self.values[size], RELA_BYTES):
                kind, symbol = struct.unpack_from("<II", self.data, at)
                if symbol in moved:
                    struct.pack_into("<I", self.data, at + 4, moved[symbol])

    def hash_table(self) -> bytes:
        first = self.first_export
        buckets = max(1, (len(self.symbols) - first) // 4)
        self.sort_exports(buckets)
        hashes = [gnu_hash(name.encode()) for name in self.symbol_names[first:]]
        words = 1
        while words * 8 < len(hashes):  # eight bits of a filter's word for each symbol
            words *= 2
        bloom, heads, chains = [0] * words, [0] * buckets, []
        for i, value in enumerate(hashes):
            bloom[value // 64 % words] |= 1 << value % 64 | 1 << (value >> 26) % 64
            heads[value % buckets] = heads[value % buckets] or first + i
            ends = i + 1 == len(hashes) or hashes[i + 1] % buckets != value % buckets
            chains.append(value & ~1 | int(ends))
        return struct.pack(f"<IIII{words}Q{buckets}I{len(chains)}I", buckets, first, words, 26, *bloom, *heads, *chains)

    def append(self, blob: bytes) -> int:
        """Maps more bytes, read only, after all others. Returns their address."""
        note = next((i for i, s in enumerate(self.segments) if s[0] == PT_NOTE), None)
        loads = [i for i, s in enumerate(self.segments) if s[0] == PT_LOAD]
        if note is None or note < loads[-1]:
            raise Unsupported(f"{self.path} has no note after its segments, whose header could map more")
        self.data += bytes(-len(self.data) % PAGE)
        start = len(self.data)
        end = max(self.segments[i][3] + self.segments[i][6] for i in loads)
        address = (end + PAGE - 1) // PAGE * PAGE
        self.data += blob
        self.segments[note] = [PT_LOAD, 4, start, address, address, len(blob), len(blob), PAGE]
        struct.pack_into("<IIQQQQQQ", self.data, self.programs + 56 * note, *self.segments[note])
        return address

    def move_section(self, name: str, address: int, size: int) -> None:
        """For debuggers and readelf: the dynamic linker reads no section headers."""
        names = struct.unpack_from("<Q", self.data, self.sections + SECTION_BYTES * self.names_section + 24)[0]
        for i in range(self.section_count):
            at = self.sections + SECTION_BYTES * i
            here = names + struct.unpack_from("<I", self.data, at)[0]
            if self.data[here:self.data.index(b"\0", here)].decode() == name:
                struct.pack_into("<QQQ", self.data, at + 16, address, self.offset(address), size)

    def save(self, path: pathlib.Path) -> None:
        if len(self.dynamic) >= self.dynamic_slots:
            raise Unsupported(f"{self.path} has no free entry in its dynamic section")
        table = self.hash_table()
        for symbol, name in zip(self.symbols, self.symbol_names):
            struct.pack_into("<I", symbol, 0, self.place(name))
        start = self.offset(self.values[DT_SYMTAB])
        self.data[start:start + SYMBOL_BYTES * len(self.symbols)] = b"".join(self.symbols)
        table += bytes(-len(table) % 8)
        hash_at = self.append(table + bytes(self.new_strings))
        strings_at = hash_at + len(table)
        changed = {DT_GNU_HASH: hash_at, DT_STRTAB: strings_at, DT_STRSZ: len(self.new_strings)}
        entries = [(tag, changed.get(tag, value)) for tag, value in self.dynamic]
        entries += [(DT_NULL, 0)] * (self.dynamic_slots - len(entries))
        for i, entry in enumerate(entries):
            struct.pack_into("<qQ", self.data, self.dynamic_at + 16 * i, *entry)
        self.move_section(".gnu.hash", hash_at, len(table))
        self.move_section(".dynstr", strings_at, len(self.new_strings))
        fresh = path.with_name(path.name + ".new")
        fresh.write_bytes(self.data)
        fresh.chmod(0o755)
        fresh.replace(path)


def is_runtime(name: str) -> bool:
    return name.startswith(RUNTIMES)


def find(name: str, folders: list[pathlib.Path]) -> pathlib.Path:
    for folder in folders:
        if (folder / name).exists():
            return (folder / name).resolve()
    asked = subprocess.run(["cc", f"-print-file-name={name}"], check=True, capture_output=True, text=True).stdout.strip()
    if asked == name:
        raise Unsupported(f"library {name} is not found; name its directory by --search")
    return pathlib.Path(asked).resolve()


def closure(library: Elf, folders: list[pathlib.Path], shared: list[str]) -> dict[str, Elf]:
    """The libraries to copy, by their names in DT_NEEDED."""
    found: dict[str, Elf] = {}
    waiting = list(library.needed)
    while waiting:
        name = waiting.pop()
        if name in found or is_runtime(name) or any(name.startswith(one) for one in shared):
            continue
        found[name] = Elf(find(name, folders))
        waiting += found[name].needed
    return found


def main(arguments: list[str]) -> None:
    parser = Parser(__doc__)
    parser.add_argument("--library", type=pathlib.Path, required=True)
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--search", type=pathlib.Path, nargs="*", default=[])
    parser.add_argument("--shared", nargs="*", default=[])
    chosen = parser.parse_args(arguments)

    library = Elf(chosen.library)
    copies = closure(library, chosen.search, chosen.shared)
    runtime = {name for one in sorted({n for e in [library, *copies.values()] for n in e.needed if is_runtime(n)})
               for name in Elf(find(one, [])).exports}
    libraries = {name: name + NAME_SUFFIX for name in copies}
    # A name that a runtime has, too, replaces the runtime's: operator new, for example.
    symbols = {name: name + SYMBOL_SUFFIX for elf in copies.values() for name in elf.exports if name and name not in runtime}
    chosen.folder.mkdir(parents=True, exist_ok=True)
    for name, elf in copies.items():
        elf.rename(libraries, symbols)
        elf.look_beside()
        elf.save(chosen.folder / libraries[name])
    library.rename(libraries, symbols)
    library.save(chosen.library)
    for path in chosen.folder.iterdir():
        if path.name not in libraries.values():
            path.unlink()


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Unsupported as why:
        sys.exit(f"private_libraries: {why}")
