/* A program that watches what its double-buffered window shows: client HABIT FRAMES.
 *
 * Frame n is cleared to a red of 20 + 10 n. After each swap, and while it rests, the client looks at its
 * window through X; a frame that it has not seen before is written to standard output as PPM, after a line
 * "N" that names it. */
#include "tests/doors/programs/ring.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { kWidth = 200, kHeight = 150, kFirstRed = 20, kStep = 10 };

static Display* g_display;
static XVisualInfo* g_visual;
static Window g_window;
static GLXContext g_context;
static int g_seen = -1;

static Window makeWindow(int x) {
  XSetWindowAttributes attributes;
  attributes.border_pixel = 0;
  attributes.override_redirect = True;
  attributes.colormap = XCreateColormap(g_display, DefaultRootWindow(g_display), g_visual->visual, AllocNone);
  const Window window = XCreateWindow(g_display, DefaultRootWindow(g_display), x, 0, kWidth, kHeight, 0,
                                      g_visual->depth, InputOutput, g_visual->visual,
                                      CWBorderPixel | CWColormap | CWOverrideRedirect, &attributes);
  XMapWindow(g_display, window);
  XSync(g_display, False);
  return window;
}

static int openWindow(void) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  g_display = XOpenDisplay(NULL);
  g_visual = g_display ? glXChooseVisual(g_display, DefaultScreen(g_display), wanted) : NULL;
  if (!g_visual) return fprintf(stderr, "no such window\n"), 0;
  g_context = glXCreateContext(g_display, g_visual, NULL, True);
  g_window = makeWindow(0);
  return glXMakeCurrent(g_display, g_window, g_context);
}

static void nap(long milliseconds) {
  const struct timespec time = {milliseconds / 1000, milliseconds % 1000 * 1000000};
  nanosleep(&time, NULL);
}

static double milliseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec * 1e3 + (double)now.tv_nsec / 1e6;
}

/* Number of the frame that the window shows; -1: none. */
static int look(void) {
  XImage* image = XGetImage(g_display, g_window, 0, 0, kWidth, kHeight, AllPlanes, ZPixmap);
  const int red = (int)(XGetPixel(image, 1, 1) >> 16 & 255);
  const int frame = red >= kFirstRed ? (red - kFirstRed + kStep / 2) / kStep : -1;
  if (frame > g_seen) {
    printf("%d\nP6\n%d %d\n255\n", frame, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const unsigned long pixel = XGetPixel(image, x, y);
        putchar((int)(pixel >> 16 & 255)), putchar((int)(pixel >> 8 & 255)), putchar((int)(pixel & 255));
      }
    g_seen = frame;
  } else if (frame >= 0 && frame < g_seen) {
    fprintf(stderr, "frame %d after frame %d\n", frame, g_seen);
  }
  XDestroyImage(image);
  return frame;
}

static void draw(int frame) {
  glClearColor((GLfloat)(kFirstRed + kStep * frame) / 255, 0.1f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setRingView(kWidth, kHeight, 15 * (float)frame);
  glBegin(GL_LINES); /* of the real OpenGL, in the same frame */
  glVertex3f(-1.5f, 0, 0), glVertex3f(-1.5f, 0.1f * (GLfloat)frame, 0);
  glEnd();
  sendRing();
}

static void frames(int from, int to) {
  for (int frame = from; frame < to; ++frame) {
    draw(frame);
    glXSwapBuffers(g_display, g_window);
    look();
  }
}

/* The program stops drawing: the newest frame must be shown by itself. */
static void rest(int last) {
  const double start = milliseconds();
  while (look() < last && milliseconds() - start < 30000) nap(1);
  fprintf(stderr, "rest %.0f ms\n", milliseconds() - start);
}

/* As in toolkits: binds the window's framebuffer again before every swap. */
static void binds(int count) {
  void (*const bind)(GLenum, GLuint) =
      (void (*)(GLenum, GLuint))glXGetProcAddress((const GLubyte*)"glBindFramebuffer");
  for (int frame = 0; frame < count; ++frame) {
    draw(frame);
    bind(GL_FRAMEBUFFER, 0);
    glXSwapBuffers(g_display, g_window);
    look();
  }
  glFinish();
  look();
}

static void finished(int count) {
  frames(0, count);
  glFinish();
  look();
}

static void still(int count) {
  frames(0, count);
  rest(count - 1);
  frames(count, count + 2);
  rest(count + 1);
}

static void leaves(int count) {
  frames(0, count);
  exit(0);
}

static void destroysWindow(int count) {
  frames(0, count);
  XDestroyWindow(g_display, g_window);
  glXMakeCurrent(g_display, None, NULL);
  g_window = makeWindow(0);
  glXMakeCurrent(g_display, g_window, g_context);
  frames(count, count + 2);
  glFinish();
  look();
}

static void closesDisplay(int count) {
  frames(0, count);
  XCloseDisplay(g_display);
  exit(0);
}

static void destroysContext(int count) {
  frames(0, count);
  glXDestroyContext(g_display, g_context);
  glXMakeCurrent(g_display, None, NULL);
  look();
}

static void forks(int count) {
  frames(0, count);
  fflush(stdout);
  const pid_t child = fork();
  if (child == 0) exit(0);
  int status = 1;
  waitpid(child, &status, 0);
  if (status) fprintf(stderr, "the child ended with %d\n", status);
  frames(count, count + 2);
  glFinish();
  look();
}

static void resizes(int count) {
  frames(0, count);
  XResizeWindow(g_display, g_window, kWidth + 50, kHeight + 40);
  XSync(g_display, False);
  frames(count, count + 2);
  XResizeWindow(g_display, g_window, kWidth, kHeight);
  XSync(g_display, False);
  frames(count + 2, count + 5);
  glFinish();
  look();
}

static void otherWindow(int count) {
  frames(0, count);
  const Window first = g_window, second = makeWindow(2 * kWidth);
  glXMakeCurrent(g_display, second, g_context);
  look(); /* the first window still shows its last frame */
  draw(count);
  glXSwapBuffers(g_display, second);
  glXMakeCurrent(g_display, first, g_context);
  frames(count + 1, count + 3);
  glFinish();
  look();
}

int main(int argc, char** argv) {
  const struct {
    const char* name;
    void (*run)(int count);
  } habits[] = {{"finished", finished},
                {"binds", binds},
                {"still", still},
                {"leaves", leaves},
                {"destroys-window", destroysWindow},
                {"closes-display", closesDisplay},
                {"destroys-context", destroysContext},
                {"forks", forks},
                {"resizes", resizes},
                {"other-window", otherWindow}};
  for (size_t i = 0; argc > 2 && i < sizeof habits / sizeof *habits; ++i) {
    if (strcmp(argv[1], habits[i].name) != 0) continue;
    if (!openWindow()) return 1;
    habits[i].run(atoi(argv[2]));
    return 0;
  }
  fprintf(stderr, "client HABIT FRAMES\n");
  return 2;
}
