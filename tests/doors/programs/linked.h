/* Fills the tables with the functions that this program is linked with. */
#pragma once
#include "glx_client.h"

static inline Gl linkedGl(void) {
  Gl gl;
#define X(ret, name, args) gl.name = gl##name;
  GL_FUNCTIONS(X)
#undef X
  return gl;
}

static inline Glx linkedGlx(void) {
  Glx glx;
#define X(name) glx.name = glX##name;
  GLX_FUNCTIONS(X)
#undef X
  return glx;
}
