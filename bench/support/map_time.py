"""When a program's window appears on the X server; Xlib by ctypes."""
import ctypes
import select
import struct
import time

from support import programs

SUBSTRUCTURE_NOTIFY, MAP_NOTIFY = 1 << 19, 19
LEAST = 200  # pixels: smaller windows are helpers


class Maps:
    """Sees windows of `display` appear."""

    def __init__(self, display):
        self.x = ctypes.CDLL("libX11.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        self.x.XSelectInput(self.display, ctypes.c_ulong(self.x.XDefaultRootWindow(self.display)), ctypes.c_long(SUBSTRUCTURE_NOTIFY))
        self.x.XSync(self.display, 0)

    def wide(self, window):
        root, integers = ctypes.c_ulong(), [ctypes.c_int() for _ in range(2)]
        sizes = [ctypes.c_uint() for _ in range(4)]
        self.x.XGetGeometry(self.display, ctypes.c_ulong(window), *map(ctypes.byref, [root, *integers, *sizes]))
        return sizes[0].value >= LEAST

    def wait(self, patience=30):
        """Waits until a wide window is mapped."""
        until, event = time.monotonic() + patience, ctypes.create_string_buffer(192)
        while time.monotonic() < until:
            while self.x.XPending(self.display):
                self.x.XNextEvent(self.display, event)
                if struct.unpack_from("i", event)[0] == MAP_NOTIFY and self.wide(struct.unpack_from("L", event, 40)[0]):
                    return
            select.select([self.x.XConnectionNumber(self.display)], [], [], 0.1)
        raise programs.Failed("no window appeared")
