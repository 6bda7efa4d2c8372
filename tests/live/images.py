"""Images of an X display: taking, comparing and keeping them. Arrays are height x width x 3 bytes, top row first."""
import struct
import subprocess
import zlib

import numpy as np

EDGE = 24    # of 255: a pixel whose neighbours differ by more lies on an edge
VISIBLE = 8  # of 255: the difference that counts for the share of pixels that differ


def grab():
    """The content of the whole screen."""
    for attempt in range(5):  # fails if a window is closed meanwhile
        done = subprocess.run(["xwd", "-root", "-silent"], capture_output=True)
        if done.returncode == 0:
            break
    done.check_returncode()
    data = done.stdout
    header = struct.unpack(">25I", data[:100])
    size, width, height, big_endian, bits, stride, colors = (header[i] for i in (0, 4, 5, 7, 11, 12, 19))
    rows = np.frombuffer(data, np.uint8, stride * height, size + colors * 12).reshape(height, stride)
    # Four bytes a pixel, or three if windows have other visuals than the screen.
    pixels = rows[:, : width * bits // 8].reshape(height, width, bits // 8)
    return (pixels[:, :, -3:] if big_endian else pixels[:, :, 2::-1]).copy()


def color_count(image):
    wide = image.astype(np.uint32)
    return len(np.unique(wide[:, :, 0] << 16 | wide[:, :, 1] << 8 | wide[:, :, 2]))


def window_box(image):
    """Rows and columns that hold anything but the empty screen's black, as slices."""
    lit = image.any(axis=2)
    if not lit.any():
        return slice(0, image.shape[0]), slice(0, image.shape[1])
    rows, columns = np.flatnonzero(lit.any(axis=1)), np.flatnonzero(lit.any(axis=0))
    return slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)


def edges(image):
    """Pixels whose 3x3 neighbourhood spans more than EDGE in some channel."""
    wide = np.pad(image.astype(np.int16), ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width = image.shape[:2]
    around = [wide[y : y + height, x : x + width] for y in range(3) for x in range(3)]
    return (np.maximum.reduce(around) - np.minimum.reduce(around)).max(axis=2) > EDGE


def share_beyond(off, on, limit=VISIBLE):
    """Share of pixels that differ by more than `limit`."""
    return float((np.abs(off.astype(np.int16) - on.astype(np.int16)).max(axis=2) > limit).mean())


def compare(off, on):
    """Largest difference of 255, and shares of the window's pixels that differ by more than 2, on and off edges."""
    box = window_box(np.maximum(off, on))
    off, on = off[box], on[box]
    difference = np.abs(off.astype(np.int16) - on.astype(np.int16)).max(axis=2)
    edge = edges(off) | edges(on)
    beyond = difference > 2
    return {
        "largest": int(difference.max()),
        "largest_off_edges": int(difference[~edge].max(initial=0)),
        "beyond": float(beyond.mean()),
        "visible": share_beyond(off, on),
        "beyond_off_edges": float((beyond & ~edge).mean()),
        "width": off.shape[1],
        "height": off.shape[0],
    }


def read_pnms(data):
    """The images of a row of binary PPM files, as glretrace writes them."""
    at = 0
    while at < len(data):
        words = []
        while len(words) < 4:  # the kind, width, height, largest value; comments between them
            end = data.index(b"\n", at)
            words += data[at:end].split(b"#")[0].split()
            at = end + 1
        width, height = int(words[1]), int(words[2])
        yield np.frombuffer(data, np.uint8, width * height * 3, at).reshape(height, width, 3)
        at += width * height * 3


def difference_image(off, on):
    """The difference, eight times as bright."""
    return np.minimum(np.abs(off.astype(np.int16) - on.astype(np.int16)) * 8, 255).astype(np.uint8)


def write_png(path, image):
    height, width = image.shape[:2]
    rows = np.concatenate([np.zeros((height, 1), np.uint8), image.reshape(height, width * 3)], axis=1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))
