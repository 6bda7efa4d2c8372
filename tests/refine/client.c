/* A program whose window is refined: client HABIT.
 *
 * Draws a scene of rings on a floor, and lines over it, then does as its habit says. Pictures of the window,
 * as X shows it, go to standard output as PPM after a line that names them. */
#include "tests/doors/ring.h"

#include <GL/gl.h>
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

static void drawScene(float angle) {
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setRingView(kWidth, kHeight, angle);
  sendRing();
  glPushMatrix(), glScalef(0.5f, 1.2f, 0.5f);
  sendRing();
  glPopMatrix();
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

static void waits(int overlay) {
  show(0, overlay);
  XSync(g_display, False);
  look("first");
  nap(4000);
  look("last");
}

static void plain(void) { waits(0); }
static void overlays(void) { waits(1); }

static void redraws(void) {
  for (int i = 0; i < 60; ++i) {
    show(0, 1);
    if (i == 0) look("first");
  }
  look("last");
}

static void reads(void) {
  drawScene(0);
  readPixels("last");
}

/* Waits, then goes on: what the window shows is always the newest frame. */
static void goesOn(void) {
  for (int i = 0; i < 6; ++i) {
    show(0, 1);
    nap(100 + 37 * i);
    show(90, 1);
    look("moved");
    nap(i % 3 * 60);
  }
}

/* Draws into the window behind OpenGL's back while it rests. */
static void paints(void) {
  show(0, 1);
  const GC gc = XCreateGC(g_display, g_window, 0, NULL);
  nap(120);
  XSetForeground(g_display, gc, 0x00ff00);
  XFillRectangle(g_display, g_window, gc, 100, 60, 40, 40);
  XSync(g_display, False);
  nap(2000);
  look("last");
}

static void leaves(void) {
  show(0, 0);
  nap(250);
  exit(0);
}

static void closes(void) {
  show(0, 0);
  nap(250);
  XCloseDisplay(g_display);
  nap(300);
}

static void destroys(void) {
  show(0, 0);
  nap(200);
  XDestroyWindow(g_display, g_window);
  XSync(g_display, False);
  nap(300);
  glXMakeCurrent(g_display, None, NULL);
  glXDestroyContext(g_display, g_context);
}

static void resizes(void) {
  show(0, 1);
  nap(150);
  XResizeWindow(g_display, g_window, kWidth + 40, kHeight + 40);
  XSync(g_display, False);
  nap(300);
  XResizeWindow(g_display, g_window, kWidth, kHeight);
  XSync(g_display, False);
  show(0, 1), show(0, 1);
  nap(3000);
  look("last");
}

int main(int argc, char** argv) {
  const struct {
    const char* name;
    void (*run)(void);
    int hidden;
  } habits[] = {{"plain", plain, 0},       {"overlays", overlays, 0}, {"redraws", redraws, 0},
                {"reads", reads, 0},       {"hidden", reads, 1},      {"goes-on", goesOn, 0},
                {"paints", paints, 0},     {"leaves", leaves, 0},     {"closes", closes, 0},
                {"destroys", destroys, 0}, {"resizes", resizes, 0}};
  for (size_t i = 0; argc > 1 && i < sizeof habits / sizeof *habits; ++i) {
    if (strcmp(argv[1], habits[i].name) != 0) continue;
    if (!openWindow(!habits[i].hidden)) return 1;
    habits[i].run();
    return 0;
  }
  fprintf(stderr, "client HABIT\n");
  return 2;
}
