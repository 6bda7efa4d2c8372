"""Shared libraries and programs as files: names of libraries and symbols, which can be changed, and tables for the dynamic linker.

Files: ELF of 64 bits, little endian. The new names and tables are appended and mapped by the program header of a note, which
nothing reads at run time. Format: System V ABI, chapters 4 and 5; DT_GNU_HASH and versions of symbols as the GNU C library reads them.
Raises Unsupported for files of another kind.
"""
from __future__ import annotations

import pathlib
import struct

PT_LOAD, PT_DYNAMIC, PT_NOTE = 1, 2, 4
DT_NULL, DT_NEEDED, DT_PLTRELSZ, DT_HASH, DT_STRTAB, DT_SYMTAB, DT_RELA, DT_RELASZ = 0, 1, 2, 4, 5, 6, 7, 8
DT_STRSZ, DT_SONAME, DT_RPATH, DT_JMPREL, DT_RUNPATH = 10, 14, 15, 23, 29
DT_GNU_HASH, DT_VERSYM, DT_VERDEF, DT_VERDEFNUM, DT_VERNEED, DT_VERNEEDNUM = (
    0x6FFFFEF5, 0x6FFFFFF0, 0x6FFFFFFC, 0x6FFFFFFD, 0x6FFFFFFE, 0x6FFFFFFF)
PAGE, SYMBOL_BYTES, RELA_BYTES, SECTION_BYTES = 4096, 24, 24, 64
GLOBAL_VERSION, VERSION_INDEX = 1, 0x7FFF  # of a symbol without a version; bits of an entry of DT_VERSYM


class Unsupported(Exception):
    """A file that this tool cannot change; str() says which and why."""


def gnu_hash(name: bytes) -> int:
    value = 5381
    for byte in name:
        value = (value * 33 + byte) & 0xFFFFFFFF
    return value


def elf_hash(name: bytes) -> int:
    value = 0
    for byte in name:
        value = (value << 4) + byte
        value = (value ^ (value & 0xF0000000) >> 24) & 0x0FFFFFFF
    return value


class Elf:
    """A shared library or a program. Names are read at once and written by rename() and save()."""

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
        self.read_requirements()

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

    def read_requirements(self) -> None:
        """self.requirements: index in DT_VERSYM -> library, version and flags."""
        self.requirements: dict[int, tuple[str, str, int]] = {}
        at = self.offset(self.values[DT_VERNEED]) if DT_VERNEED in self.values else 0
        for _ in range(self.values.get(DT_VERNEEDNUM, 0)):
            count, library, aux, following = struct.unpack_from("<HIII", self.data, at + 2)
            entry = at + aux
            for _ in range(count):
                _, flags, index, name, step = struct.unpack_from("<IHHII", self.data, entry)
                self.requirements[index] = (self.string(library), self.string(name), flags)
                entry += step
            at += following

    def definitions(self) -> dict[int, str]:
        """Versions that the file defines, by their index in DT_VERSYM."""
        found = {}
        for entry in self.definition_names():
            index, = struct.unpack_from("<H", self.data, entry[0] + 4)
            found[index & VERSION_INDEX] = self.string(struct.unpack_from("<I", self.data, entry[1])[0])
        return found

    def definition_names(self):
        """Of each version that the file defines: places of its entry and of the names in it, the version's own first."""
        at = self.offset(self.values[DT_VERDEF]) if DT_VERDEF in self.values else 0
        for _ in range(self.values.get(DT_VERDEFNUM, 0)):
            count, _, aux, following = struct.unpack_from("<HIII", self.data, at + 6)
            names = [at + aux]
            for _ in range(count - 1):
                names.append(names[-1] + struct.unpack_from("<I", self.data, names[-1] + 4)[0])
            yield at, *names
            at += following

    def version_index(self, symbol: int) -> int:
        if DT_VERSYM not in self.values:
            return GLOBAL_VERSION
        return struct.unpack_from("<H", self.data, self.offset(self.values[DT_VERSYM]) + 2 * symbol)[0] & VERSION_INDEX

    def require(self, symbol: int, library: str, version: str) -> None:
        """The undefined symbol is of this version of the library. An empty version: of any."""
        index = GLOBAL_VERSION
        if version:
            index = next((i for i, (l, v, _) in self.requirements.items() if (l, v) == (library, version)), 0)
        if not index:
            index = max([GLOBAL_VERSION, *self.requirements, *self.definitions()]) + 1
            self.requirements[index] = (library, version, 0)
        struct.pack_into("<H", self.data, self.offset(self.values[DT_VERSYM]) + 2 * symbol, index)

    @property
    def exports(self) -> set[str]:
        return set(self.symbol_names[self.first_export:])

    def need(self, library: str) -> None:
        """Adds a library to those that it needs. Before rename()."""
        if library not in self.needed:
            self.needed.append(library)

    def rename(self, libraries: dict[str, str], symbols: dict[str, str]) -> None:
        """Names of libraries in DT_NEEDED, DT_SONAME and versions, and of symbols, by these tables.

        DT_HASH, whose order would have to be kept, goes: the GNU C library reads DT_GNU_HASH.
        """
        self.new_strings = bytearray(b"\0")
        self.string_places: dict[str, int] = {"": 0}
        for _, *names in self.definition_names():
            for at in names:
                old = self.string(struct.unpack_from("<I", self.data, at)[0])
                struct.pack_into("<I", self.data, at, self.place(libraries.get(old, old)))
        self.requirements = {i: (libraries.get(l, l), v, f) for i, (l, v, f) in self.requirements.items()}
        self.symbol_names = [symbols.get(name, name) for name in self.symbol_names]
        self.dynamic = ([(DT_NEEDED, self.place(libraries.get(name, name))) for name in self.needed]
                        + [(tag, self.place(libraries.get(self.string(value), self.string(value))) if tag in (DT_SONAME, DT_RPATH, DT_RUNPATH) else value)
                           for tag, value in self.dynamic if tag not in (DT_HASH, DT_NEEDED)])

    def place(self, text: str) -> int:
        """Where the text stands in the new strings; it is added at its first use."""
        if text not in self.string_places:
            self.string_places[text] = len(self.new_strings)
            self.new_strings += text.encode() + b"\0"
        return self.string_places[text]

    def look_in(self, folder: str) -> None:
        """Needed libraries are searched for in this folder, "$ORIGIN" for instance, the file's own. After rename()."""
        self.dynamic = [(tag, value) for tag, value in self.dynamic if tag not in (DT_RPATH, DT_RUNPATH)]
        self.dynamic.append((DT_RUNPATH, self.place(folder)))

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

    def requirements_table(self) -> bytes:
        """DT_VERNEED: of each library, its versions that symbols ask for."""
        used = {self.version_index(i) for i in range(len(self.symbols))}
        libraries: dict[str, list[tuple[int, str, int]]] = {}
        for index, (library, version, flags) in sorted(self.requirements.items()):
            if index in used:
                libraries.setdefault(library, []).append((index, version, flags))
        self.requirement_count = len(libraries)
        table = b""
        for n, (library, versions) in enumerate(libraries.items(), 1):
            following = 16 * (1 + len(versions)) if n < len(libraries) else 0
            table += struct.pack("<HHIII", 1, len(versions), self.place(library), 16, following)
            for m, (index, version, flags) in enumerate(versions, 1):
                table += struct.pack("<IHHII", elf_hash(version.encode()), flags, index, self.place(version), 16 if m < len(versions) else 0)
        return table

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

    def move_section(self, name: str, address: int, size: int, count: int | None = None) -> None:
        """For debuggers and readelf: the dynamic linker reads no section headers. `count`: of its entries, in sh_info."""
        names = struct.unpack_from("<Q", self.data, self.sections + SECTION_BYTES * self.names_section + 24)[0]
        for i in range(self.section_count):
            at = self.sections + SECTION_BYTES * i
            here = names + struct.unpack_from("<I", self.data, at)[0]
            if self.data[here:self.data.index(b"\0", here)].decode() == name:
                struct.pack_into("<QQQ", self.data, at + 16, address, self.offset(address), size)
                if count is not None:
                    struct.pack_into("<I", self.data, at + 44, count)

    def save(self, path: pathlib.Path) -> None:
        tables = {DT_GNU_HASH: self.hash_table(), DT_VERNEED: self.requirements_table()}
        for symbol, name in zip(self.symbols, self.symbol_names):
            struct.pack_into("<I", symbol, 0, self.place(name))
        start = self.offset(self.values[DT_SYMTAB])
        self.data[start:start + SYMBOL_BYTES * len(self.symbols)] = b"".join(self.symbols)
        tables[DT_STRTAB] = bytes(self.new_strings)
        places, blob = {}, b""
        for tag, table in tables.items():
            places[tag] = len(blob)
            blob += table + bytes(-len(table) % 8)
        address = self.append(blob)
        changed = {tag: address + place for tag, place in places.items()}
        changed |= {DT_STRSZ: len(self.new_strings), DT_VERNEEDNUM: self.requirement_count}
        self.write_dynamic(changed)
        for name, tag in ((".gnu.hash", DT_GNU_HASH), (".gnu.version_r", DT_VERNEED), (".dynstr", DT_STRTAB)):
            self.move_section(name, changed[tag], len(tables[tag]), self.requirement_count if tag == DT_VERNEED else None)
        fresh = path.with_name(path.name + ".new")
        fresh.write_bytes(self.data)
        fresh.chmod(self.path.stat().st_mode & 0o777)
        fresh.replace(path)

    def write_dynamic(self, changed: dict[int, int]) -> None:
        entries = [(tag, changed.get(tag, value)) for tag, value in self.dynamic
                   if self.requirement_count or tag not in (DT_VERNEED, DT_VERNEEDNUM)]
        if len(entries) >= self.dynamic_slots:
            raise Unsupported(f"{self.path} has no free entry in its dynamic section")
        entries += [(DT_NULL, 0)] * (self.dynamic_slots - len(entries))
        for i, entry in enumerate(entries):
            struct.pack_into("<qQ", self.data, self.dynamic_at + 16 * i, *entry)
