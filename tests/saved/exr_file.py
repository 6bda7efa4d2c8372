"""Reads OpenEXR files of one part of scan lines, stored as they are or by ZIP, without a library of its own.

    file = ExrFile(path)
    file.attributes["Software"]        # texts; of other attributes their bytes
    file.channels["R"]                 # "half", "float" or "uint"
    file.values("R")                   # numbers, row by row from the top
"""
import array
import struct
import sys
import zlib

TYPES = {0: ("uint", "I", 4), 1: ("half", "e", 2), 2: ("float", "f", 4)}
ROWS = {0: 1, 2: 1, 3: 16}  # of a block, by the compression: none, ZIPS, ZIP


def text_at(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def unpacked(data):
    """Of ZIP: bytes as differences, those of even places first."""
    data = bytearray(zlib.decompress(data))
    for i in range(1, len(data)):
        data[i] = (data[i - 1] + data[i] - 128) & 255
    result, half = bytearray(len(data)), (len(data) + 1) // 2
    result[0::2], result[1::2] = data[:half], data[half:]
    return bytes(result)


class ExrFile:
    def __init__(self, path):
        data = path.read_bytes()
        magic, version = struct.unpack("<II", data[:8])
        if magic != 20000630 or version & 0xff != 2 or version & 0x1a00:
            raise ValueError(f"{path} is no OpenEXR file of scan lines")
        at, self.attributes = 8, {}
        while data[at]:
            name, at = text_at(data, at)
            kind, at = text_at(data, at)
            size, = struct.unpack("<i", data[at:at + 4])
            value = data[at + 4:at + 4 + size]
            self.attributes[name] = value.decode() if kind == "string" else value
            at += 4 + size
        self.read_channels(self.attributes["channels"])
        left, top, right, bottom = struct.unpack("<4i", self.attributes["dataWindow"])
        self.width, self.height = right - left + 1, bottom - top + 1
        self.read_blocks(data, at + 1, top)

    def read_channels(self, table):
        at, self.channels = 0, {}
        while table[at]:
            name, at = text_at(table, at)
            self.channels[name] = TYPES[struct.unpack("<i", table[at:at + 4])[0]][0]
            at += 16

    def read_blocks(self, data, at, top):
        compression = self.attributes["compression"][0]
        count = -(-self.height // ROWS[compression])
        self.rows = [None] * self.height
        for place in struct.unpack(f"<{count}Q", data[at:at + 8 * count]):
            y, size = struct.unpack("<ii", data[place:place + 8])
            rows = min(ROWS[compression], self.height - (y - top))
            block, whole = data[place + 8:place + 8 + size], rows * self.row_bytes()
            if compression and size < whole:
                block = unpacked(block)
            for row in range(rows):
                self.rows[y - top + row] = block[row * self.row_bytes():(row + 1) * self.row_bytes()]

    def sizes(self):
        return {name: next(size for kind, _, size in TYPES.values() if kind == of) for name, of in self.channels.items()}

    def row_bytes(self):
        return self.width * sum(self.sizes().values())

    def values(self, channel):
        sizes = self.sizes()
        start = self.width * sum(size for name, size in sizes.items() if name < channel)
        kind = next(code for of, code, _ in TYPES.values() if of == self.channels[channel])
        parts = [row[start:start + self.width * sizes[channel]] for row in self.rows]
        if kind == "e":
            return [value for part in parts for value in struct.unpack(f"<{self.width}e", part)]
        values = array.array(kind, b"".join(parts))
        if sys.byteorder == "big":
            values.byteswap()
        return values.tolist()
