"""PyOpenGL (libraries opened by ctypes) with a GLUT window. The numbers are those of workload.h."""
import sys

from OpenGL import GL, GLUT

FRAMES, TRIANGLES, QUERIES, SIZE = 10, 50, 20, 64


def draw_frame() -> bool:
    GL.glClearColor(0, 0, 0, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glEnable(GL.GL_DEPTH_TEST)
    for _ in range(QUERIES):
        GL.glIsTexture(1)
    GL.glColor3f(1, 0, 0)
    GL.glBegin(GL.GL_TRIANGLES)
    for i in range(TRIANGLES):
        z = -0.5 + 0.01 * i
        for x, y in ((-0.9, -0.9), (0.9, -0.9), (0, 0.9)):
            GL.glVertex3f(x, y, z)
    GL.glEnd()
    pixel = bytes(GL.glReadPixels(SIZE // 2, SIZE // 2, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))
    GLUT.glutSwapBuffers()
    return pixel[0] > 250 and pixel[1] < 5 and pixel[2] < 5


GLUT.glutInit(["pyopengl"])
GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_DEPTH | GLUT.GLUT_RGBA)
GLUT.glutInitWindowSize(SIZE, SIZE)
GLUT.glutCreateWindow(b"pyopengl")
sys.exit(0 if all([draw_frame() for _ in range(FRAMES)]) else 1)
