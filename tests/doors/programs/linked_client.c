/* Linked functions and the oldest kind of context. Built twice: with libGL, and with libOpenGL and libGLX. */
#include "linked.h"

int main(void) {
  const Gl gl = linkedGl();
  const Glx glx = linkedGlx();
  return runGlxClient(&glx, &gl);
}
