"""Compresses what is in a wheel as small as the format allows: libdeflate's highest level in place of zlib's.

    smaller_wheel.py WHEEL    takes the wheel's place; needs the module deflate (PyPI)

Names, order, dates, rights and contents of the members stay. Python and pip read both alike.
"""
from __future__ import annotations

import pathlib
import struct
import zipfile
from collections.abc import Callable

from command_line import Parser

LOCAL, CENTRAL, END = b"PK\3\4", b"PK\1\2", b"PK\5\6"
VERSION = 20  # of the format: folders and deflate
LEVEL = 12


def entry(info: zipfile.ZipInfo, method: int, size: int) -> bytes:
    """What the local and the central header of a member share: version to the lengths of its name and extra field."""
    year, month, day, hour, minute, second = info.date_time
    flags = 0 if info.filename.isascii() else 0x800  # names in UTF-8
    return struct.pack("<5H3I2H", VERSION, flags, method, hour << 11 | minute << 5 | second // 2, (year - 1980) << 9 | month << 5 | day,
                       info.CRC, size, info.file_size, len(info.filename.encode()), 0)


def compress_again(source: pathlib.Path, target: pathlib.Path, compressed: Callable[[bytes], bytes]) -> None:
    """`compressed` makes a raw stream of deflate. What does not become smaller is stored."""
    central = []
    with zipfile.ZipFile(source) as old, target.open("wb") as new:
        for info in old.infolist():
            content = old.read(info)
            body = compressed(content)
            method = zipfile.ZIP_DEFLATED
            if len(body) >= len(content):
                body, method = content, zipfile.ZIP_STORED
            shared = entry(info, method, len(body))
            made_by = info.create_system << 8 | VERSION
            central.append(CENTRAL + struct.pack("<H", made_by) + shared + struct.pack("<3H2I", 0, 0, 0, info.external_attr, new.tell()) + info.filename.encode())
            new.write(LOCAL + shared + info.filename.encode() + body)
        start = new.tell()
        new.write(b"".join(central))
        new.write(END + struct.pack("<4H2IH", 0, 0, len(central), len(central), new.tell() - start, start, 0))


def main() -> None:
    parser = Parser(__doc__)
    parser.add_argument("wheel", type=pathlib.Path, metavar="WHEEL")
    wheel = parser.parse_args().wheel
    import deflate  # after the options: other scripts of this folder need the standard library only
    made = wheel.with_suffix(".smaller")
    compress_again(wheel, made, lambda content: bytes(deflate.deflate_compress(content, LEVEL)))
    made.replace(wheel)


if __name__ == "__main__":
    main()
