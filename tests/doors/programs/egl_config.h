/* The EGL configuration that clients draw into. */
#pragma once
#include <EGL/egl.h>
#include <stddef.h>

/* A configuration with eight bits a colour and a depth buffer, for pixel buffers, and for windows too if
   `window`; NULL: there is none. */
static inline EGLConfig chooseEglConfig(EGLDisplay display, int window) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           window ? EGL_WINDOW_BIT | EGL_PBUFFER_BIT : EGL_PBUFFER_BIT,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_DEPTH_SIZE,
                           24,
                           EGL_NONE};
  EGLConfig configs[64];
  EGLint count = 0;
  eglChooseConfig(display, wanted, configs, 64, &count);
  for (EGLint i = 0; i < count; ++i) { /* eight bits a colour: the default order puts deeper ones first */
    EGLint red = 0;
    if (eglGetConfigAttrib(display, configs[i], EGL_RED_SIZE, &red) && red == 8) return configs[i];
  }
  return NULL;
}
