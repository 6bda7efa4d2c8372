/* A window with a scene of rings on a floor, and images of it as X shows it and as OpenGL reads it.
 * Included by one program. */
#pragma once
#define GL_GLEXT_PROTOTYPES
#include "tests/doors/programs/two_rings.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { kWidth = 240, kHeight = 180 };

static Display* g_display;
static XVisualInfo* g_visual;
static Window g_window;
static GLXContext g_context;

static int openWindow(int mapped) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  g_display = XOpenDisplay(NULL);
  g_visual = g_display ? glXChooseVisual(g_display, DefaultScreen(g_display), wanted) : NULL;
  if (!g_visual) return fprintf(stderr, "no such window\n"), 0;
  XSetWindowAttributes attributes;
  attributes.border_pixel = 0;
  attributes.override_redirect = True;
  attributes.colormap = XCreateColormap(g_display, DefaultRootWindow(g_display), g_visual->visual, AllocNone);
  g_window = XCreateWindow(g_display, DefaultRootWindow(g_display), 0, 0, kWidth, kHeight, 0, g_visual->depth,
                           InputOutput, g_visual->visual, CWBorderPixel | CWColormap | CWOverrideRedirect,
                           &attributes);
  if (mapped) XMapWindow(g_display, g_window);
  XSync(g_display, False);
  g_context = glXCreateContext(g_display, g_visual, NULL, True);
  return glXMakeCurrent(g_display, g_window, g_context);
}

static void nap(long milliseconds) {
  const struct timespec time = {milliseconds / 1000, milliseconds % 1000 * 1000000};
  nanosleep(&time, NULL);
}

static void begin(const char* name) { printf("%s\nP6\n%d %d\n255\n", name, kWidth, kHeight); }

static void look(const char* name) {
  XImage* image = XGetImage(g_display, g_window, 0, 0, kWidth, kHeight, AllPlanes, ZPixmap);
  begin(name);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      putchar((int)(pixel >> 16 & 255)), putchar((int)(pixel >> 8 & 255)), putchar((int)(pixel & 255));
    }
  XDestroyImage(image);
}

static void readPixels(const char* name) {
  static unsigned char pixels[kHeight][kWidth][4];
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  begin(name);
  for (int y = kHeight - 1; y >= 0; --y)
    for (int x = 0; x < kWidth; ++x) fwrite(pixels[y][x], 1, 3, stdout);
}

/* The same by floats, into a buffer object, with rows that have room. */
static void readFloats(const char* name) {
  enum { kRoom = kWidth + 3 };
  GLuint buffer;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, sizeof(float) * 3 * kRoom * kHeight, NULL, GL_STREAM_READ);
  glPixelStorei(GL_PACK_ROW_LENGTH, kRoom);
  glReadPixels(0, 0, kWidth, kHeight, GL_BGR, GL_FLOAT, NULL);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  const float(*pixels)[kRoom][3] = glMapBuffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
  begin(name);
  for (int y = kHeight - 1; y >= 0; --y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 2; c >= 0; --c) putchar((int)(pixels[y][x][c] * 255 + 0.5f));
  glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

static void drawScene(float angle) {
  drawTwoRings(kWidth, kHeight, angle);
  glNormal3f(0, 1, 0);
  glBegin(GL_QUADS);
  glVertex3f(-2, -0.5f, -2), glVertex3f(-2, -0.5f, 2), glVertex3f(2, -0.5f, 2), glVertex3f(2, -0.5f, -2);
  glEnd();
}

/* Over the scene: a blended rectangle at the left and a line of pixels at the top, as programs draw their
 * text. */
static void drawOverlay(void) {
  glDisable(GL_LIGHTING), glDisable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION), glLoadIdentity();
  glMatrixMode(GL_MODELVIEW), glLoadIdentity();
  glEnable(GL_BLEND), glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 1, 0, 0.5f);
  glRectf(-1, -1, -0.6f, 1);
  glDisable(GL_BLEND);
  glColor3f(1, 0, 1);
  glRectf(-1, 0.8f, 1, 0.9f);
}

static void show(float angle, int overlay) {
  drawScene(angle);
  if (overlay) drawOverlay();
  glXSwapBuffers(g_display, g_window);
}
