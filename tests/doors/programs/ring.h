/* A lit ring about the y axis, for the clients of several tests. */
#pragma once
#include <GL/gl.h>
#include <math.h>

/* Camera, light and material; the ring is turned by `angle` degrees. */
static void setRingView(int width, int height, float angle) {
  const GLfloat toViewer[4] = {0.5f, 0.7f, 1, 0}, color[4] = {0.9f, 0.6f, 0.2f, 1};
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION), glLoadIdentity();
  glFrustum(-0.1 * width / height, 0.1 * width / height, -0.1, 0.1, 0.3, 20);
  glMatrixMode(GL_MODELVIEW), glLoadIdentity();
  glEnable(GL_DEPTH_TEST), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, toViewer);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  glTranslatef(0, 0, -4), glRotatef(25, 1, 0, 0), glRotatef(angle, 0, 1, 0);
}

static void sendRing(void) {
  glBegin(GL_QUAD_STRIP);
  for (int i = 0; i <= 40; ++i) {
    const float t = 2 * (float)M_PI * (float)i / 40;
    glNormal3f(cosf(t), 0, sinf(t));
    glVertex3f(cosf(t), -0.5f, sinf(t)), glVertex3f(cosf(t), 0.4f + 0.2f * sinf(3 * t), sinf(t));
  }
  glEnd();
}
