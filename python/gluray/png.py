"""PNG files (ISO/IEC 15948) of 8-bit RGB images."""
import os
import stat
import struct
import tempfile
import zlib

from .errors import GlurayError

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def check_file(file):
    """Raises GlurayError if the name does not end in .png, or if something else than a PNG file stands there."""
    file = os.fspath(file)
    if not isinstance(file, str) or not file.endswith(".png"):
        raise GlurayError(f"{file}: use a name that ends in .png")
    try:
        regular = stat.S_ISREG(os.lstat(file).st_mode)
        with open(file if regular else os.devnull, "rb") as opened:
            begin = opened.read(len(SIGNATURE))
    except FileNotFoundError:
        return
    except OSError as error:
        raise GlurayError(f"{file}: {error.strerror}") from None
    if begin != SIGNATURE:
        raise GlurayError(f"{file} exists and is no PNG file; remove it, or use another name")


def png_of(width, height, rgb):
    """The bytes of a file; `rgb`: three bytes a pixel, the top row first."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    rows = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))  # 0: no filter
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def write_png(file, width, height, rgb):
    """Replaces the file at once. Raises GlurayError."""
    check_file(file)
    file = os.fspath(file)
    try:
        with tempfile.NamedTemporaryFile(dir=os.path.dirname(file) or ".", prefix=".gluray-", delete=False) as written:
            try:
                written.write(png_of(width, height, rgb))
                written.flush()
                mask = os.umask(0o077)
                os.umask(mask)
                os.chmod(written.name, 0o666 & ~mask)
                os.replace(written.name, file)
            except BaseException:
                os.unlink(written.name)
                raise
    except OSError as error:
        raise GlurayError(f"{file}: {error.strerror}") from None
