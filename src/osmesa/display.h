/* The EGL display without a screen on which all contexts are made. Any thread. */
#pragma once
#include <EGL/egl.h>

/* EGL's software device if it has one, else the display without surfaces. EGL_NO_DISPLAY: there is none, and
   one line on standard error has said so. */
EGLDisplay osmesaDisplay(void);

/* A configuration of RGBA8 pixels for pbuffers with at least so many bits of depth and stencil. 0: there is
   none. */
int osmesaConfig(EGLDisplay display, int depthBits, int stencilBits, EGLConfig* config);
