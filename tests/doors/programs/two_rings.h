/* Two rings in each other, which throw shadows on each other. */
#pragma once
#include "tests/doors/programs/ring.h"

/* Clears colour and depth, and draws them turned by `angle` degrees. */
static void drawTwoRings(int width, int height, float angle) {
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setRingView(width, height, angle);
  sendRing();
  glPushMatrix(), glScalef(0.5f, 1.2f, 0.5f);
  sendRing();
  glPopMatrix();
}
