/* Desktop OpenGL through EGL. Argument: window, or surfaceless (no display server; draws into a pbuffer of
   the surfaceless platform); moved, or bare: a window, after the context was made current with a pbuffer of
   one pixel, or without a surface, as Qt does. */
#include "egl_config.h"
#include "x_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string.h>

typedef struct Target {
  EGLDisplay display;
  EGLSurface surface;
} Target;

static void show(void* user) {
  const Target* target = (const Target*)user;
  eglSwapBuffers(target->display, target->surface);
}

static void* byName(const char* name) { return (void*)eglGetProcAddress(name); }

static EGLSurface windowSurface(EGLDisplay display, EGLConfig config, Display* x) {
  XVisualInfo wanted = {0};
  EGLint id = 0;
  int count = 0;
  eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &id);
  wanted.visualid = (VisualID)id;
  XVisualInfo* visual = XGetVisualInfo(x, VisualIDMask, &wanted, &count);
  if (!visual) return EGL_NO_SURFACE;
  return eglCreateWindowSurface(display, config, makeWindow(x, visual), NULL);
}

/* Makes the context current with another surface, or with none, and asks for its version. */
static int useElsewhere(EGLDisplay display, EGLContext context, EGLSurface surface) {
  Gl gl;
  return eglMakeCurrent(display, surface, surface, context) && loadGl(&gl, byName) &&
         gl.GetString(GL_VERSION) != NULL;
}

/* The workload without glFinish: frames end where buffers are swapped, and nowhere else. */
static int swappedWorkload(const Gl* gl, Target* target) {
  void (*drawBuffer)(GLenum) = (void (*)(GLenum))byName("glDrawBuffer");
  void (*readBuffer)(GLenum) = (void (*)(GLenum))byName("glReadBuffer");
  void (*viewport)(GLint, GLint, GLsizei, GLsizei) =
      (void (*)(GLint, GLint, GLsizei, GLsizei))byName("glViewport");
  int right = 1;
  /* Those of the surface that was current first. */
  drawBuffer(GL_BACK), readBuffer(GL_BACK), viewport(0, 0, kWindowSize, kWindowSize);
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(gl);
    right = middleIsRed(gl) && right;
    show(target);
  }
  return right;
}

int main(int argc, char** argv) {
  const char* way = argc < 2 ? "window" : argv[1];
  const int window = strcmp(way, "surfaceless") != 0, moved = strcmp(way, "moved") == 0,
            bare = strcmp(way, "bare") == 0;
  Display* x = window ? openDisplay() : NULL;
  const EGLDisplay display = window ? eglGetDisplay((EGLNativeDisplayType)x)
                                    : eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API))
    return fprintf(stderr, "no EGL\n"), 1;
  const EGLConfig config = chooseEglConfig(display, window);
  const EGLint size[] = {EGL_WIDTH, kWindowSize, EGL_HEIGHT, kWindowSize, EGL_NONE};
  if (!config) return fprintf(stderr, "no configuration\n"), 1;
  Target target = {
      display, window ? windowSurface(display, config, x) : eglCreatePbufferSurface(display, config, size)};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
  if (moved || bare) {
    const EGLint one[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    const EGLSurface first = moved ? eglCreatePbufferSurface(display, config, one) : EGL_NO_SURFACE;
    if (!context || !useElsewhere(display, context, first)) return fprintf(stderr, "no pbuffer\n"), 1;
  }
  if (!context || !eglMakeCurrent(display, target.surface, target.surface, context))
    return fprintf(stderr, "no context\n"), 1;
  Gl gl;
  if (!loadGl(&gl, byName)) return 1;
  const int right = moved || bare ? swappedWorkload(&gl, &target) : workload(&gl, show, &target);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
  eglTerminate(display);
  return !right;
}
