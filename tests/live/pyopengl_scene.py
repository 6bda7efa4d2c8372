"""A still scene through PyOpenGL and GLUT: display list, client arrays, immediate mode, two lights, text on top."""
import numpy as np
from OpenGL.GL import (GL_AMBIENT_AND_DIFFUSE, GL_COLOR_BUFFER_BIT, GL_COLOR_MATERIAL, GL_COMPILE, GL_DEPTH_BUFFER_BIT,
                       GL_DEPTH_TEST, GL_DIFFUSE, GL_FLOAT, GL_FRONT_AND_BACK, GL_LIGHT0, GL_LIGHT1, GL_LIGHTING,
                       GL_MODELVIEW, GL_NORMAL_ARRAY, GL_NORMALIZE, GL_POSITION, GL_PROJECTION, GL_QUADS, GL_SHININESS,
                       GL_SPECULAR, GL_TRIANGLES, GL_UNSIGNED_INT, GL_VERTEX_ARRAY, glBegin, glCallList, glClear,
                       glClearColor, glColor3f, glColorMaterial, glDisable, glDrawElements, glEnable,
                       glEnableClientState, glEnd, glEndList, glGenLists, glLightfv, glLoadIdentity, glMaterialf,
                       glMaterialfv, glMatrixMode, glNewList, glNormal3f, glNormalPointer, glPopMatrix, glPushMatrix,
                       glRasterPos2f, glRotatef, glTranslatef, glVertex3f, glVertexPointer)
from OpenGL.GLU import gluLookAt, gluPerspective
from OpenGL.GLUT import (GLUT_BITMAP_HELVETICA_18, GLUT_DEPTH, GLUT_DOUBLE, GLUT_RGB, glutBitmapString, glutCreateWindow,
                         glutDisplayFunc, glutInit, glutInitDisplayMode, glutInitWindowPosition, glutInitWindowSize,
                         glutMainLoop, glutSolidTeapot, glutSwapBuffers)

from models import knot

glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(640, 480)
glutInitWindowPosition(20, 20)
glutCreateWindow(b"PyOpenGL")

positions, normals, triangles = (np.ascontiguousarray(a, t) for a, t in zip(knot(200, 24), ("f4", "f4", "u4")))
teapot = glGenLists(1)
glNewList(teapot, GL_COMPILE)
glutSolidTeapot(0.8)
glEndList()


def display():
    glClearColor(0.1, 0.15, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 640 / 480, 1, 30)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(2, -6, 7, 0, 0, 0, 0, 1, 0)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_NORMALIZE, GL_COLOR_MATERIAL):
        glEnable(capability)
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE)
    glLightfv(GL_LIGHT0, GL_POSITION, (3, 4, 5, 0))
    glLightfv(GL_LIGHT1, GL_POSITION, (-4, 0, 3, 1))
    glLightfv(GL_LIGHT1, GL_DIFFUSE, (0.2, 0.3, 0.5, 1))
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (0.5, 0.5, 0.5, 1))
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 30)

    glColor3f(0.8, 0.3, 0.2)
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_NORMAL_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, positions)
    glNormalPointer(GL_FLOAT, 0, normals)
    glDrawElements(GL_TRIANGLES, triangles.size, GL_UNSIGNED_INT, triangles)

    glColor3f(0.3, 0.7, 0.4)
    glPushMatrix()
    glRotatef(70, 1, 0, 0)
    glCallList(teapot)
    glPopMatrix()

    glColor3f(0.5, 0.5, 0.6)
    glPushMatrix()
    glTranslatef(0, 0, -1.2)
    glBegin(GL_QUADS)
    glNormal3f(0, 0, 1)
    for x in range(-4, 4):
        for y in range(-4, 4):
            if (x + y) % 2:
                for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    glVertex3f(x + dx, y + dy, 0.1 * np.sin(x + dx))
    glEnd()
    glPopMatrix()

    glDisable(GL_LIGHTING)
    glDisable(GL_DEPTH_TEST)
    glColor3f(1, 1, 0)
    glRasterPos2f(-1, 2.4)
    glutBitmapString(GLUT_BITMAP_HELVETICA_18, b"text over a traced image")
    glutSwapBuffers()


glutDisplayFunc(display)
glutMainLoop()
