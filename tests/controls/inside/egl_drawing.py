"""Draws with OpenGL in this process, without a screen, as Python programs do: libEGL and libOpenGL opened by ctypes, for nobody else."""
import ctypes

SURFACELESS, PBUFFER, OPENGL, OPENGL_BIT = 0x31DD, 0x0001, 0x30A2, 0x0008
SIDE = 64  # pixels


class Window:
    """Not one on a screen: a pbuffer."""

    def __init__(self):
        self.egl, self.gl = ctypes.CDLL("libEGL.so.1"), ctypes.CDLL("libOpenGL.so.0")
        for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglCreatePbufferSurface"):
            getattr(self.egl, name).restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.egl.eglGetPlatformDisplay(SURFACELESS, None, None))
        if not self.egl.eglInitialize(self.display, None, None):
            raise OSError("no EGL without a screen")
        config, count = ctypes.c_void_p(), ctypes.c_int()
        wanted = self._list(0x3033, PBUFFER, 0x3040, OPENGL_BIT, 0x3024, 8, 0x3025, 24)  # surface, renderable, red, depth
        self.egl.eglChooseConfig(self.display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
        self.egl.eglBindAPI(OPENGL)
        self.surface = ctypes.c_void_p(self.egl.eglCreatePbufferSurface(self.display, config, self._list(0x3057, SIDE, 0x3056, SIDE)))
        self.context = ctypes.c_void_p(self.egl.eglCreateContext(self.display, config, None, None))
        if not self.egl.eglMakeCurrent(self.display, self.surface, self.surface, self.context):
            raise OSError("no OpenGL context")

    @staticmethod
    def _list(*values):
        return (ctypes.c_int * (len(values) + 1))(*values, 0x3038)

    def draw(self, frames=1):
        """A green square of 200 triangles, aslant, in each frame. Returns the pixel in the middle, (r, g, b, a)."""
        gl, f = self.gl, ctypes.c_float
        pixel = (ctypes.c_ubyte * 4)()
        for _ in range(frames):
            gl.glEnable(0x0B71)
            gl.glClear(0x4100)
            gl.glColor3f(f(0), f(1), f(0))
            gl.glBegin(4)
            for i in range(100):
                left, right = -0.9 + 0.018 * i, -0.9 + 0.018 * (i + 1)
                for x, y in ((left, -0.9), (right, -0.9), (right, 0.9), (left, -0.9), (right, 0.9), (left, 0.9)):
                    gl.glVertex3f(f(x), f(y), f(0.3 * x))
            gl.glEnd()
            gl.glReadPixels(SIDE // 2, SIDE // 2, 1, 1, 0x1908, 0x1401, pixel)
            self.egl.eglSwapBuffers(self.display, self.surface)
        return tuple(pixel)
