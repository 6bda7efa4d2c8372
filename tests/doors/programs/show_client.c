/* show_client: writes to standard output, as PPMs, what a window shows frame after frame, and its buffers.
 * Draws frames of only a clear and surfaces, and everything that can follow such a frame. Needs an X
 * server. */
#include "show_stage.h"

#include <X11/Xutil.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void moving(void) {
  for (int i = 0; i < 4; ++i) frame(20.0f * (float)i), window_shows();
}
static void unchanged(void) {
  for (int i = 0; i < 3; ++i) frame(90), window_shows(); /* as the frame before, which was swapped */
}
static void swapped_again(void) { frame(10), swap(), window_shows(); }
static void read_afterwards(void) {
  frame(15), buffer_holds(), window_shows();
  surface(60), swap(), window_shows();
}
static void drawn_over(void) {
  frame(25);
  surface(70), lines(), swap(), window_shows();
  buffer_holds();
}
static void lines_over(void) { frame(35), lines(), swap(), window_shows(); }
static void depth_cleared(void) {
  frame(45), glClear(GL_DEPTH_BUFFER_BIT), surface(110), swap(), window_shows();
}
static void colour_cleared(void) { frame(55), glClear(GL_COLOR_BUFFER_BIT), lines(), swap(), window_shows(); }
static void part_cleared(void) {
  frame(65);
  glEnable(GL_SCISSOR_TEST), glScissor(40, 30, 90, 60);
  clear(), surface(0);
  glDisable(GL_SCISSOR_TEST);
  swap(), window_shows();
}
static void masked_clear(void) {
  frame(12);
  glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE), clear(), glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  surface(75), swap(), window_shows();
}
static void smaller_viewport(void) {
  glViewport(30, 20, 111, 77), frame(40), window_shows();
  glViewport(-30, -20, 300, 180), frame(40), window_shows(), buffer_holds();
  glViewport(0, 0, width, height);
}
static void far_plane(void) {
  for (int k = 0; k < 2; ++k) {
    glDepthFunc(k ? GL_LEQUAL : GL_LESS);
    clear();
    glLoadIdentity();
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0), glVertex3f(-1, -1, 1), glVertex3f(1, -1, 1), glVertex3f(0, 1, 0.9999f);
    glEnd();
    swap(), window_shows(), buffer_holds();
  }
  glDepthFunc(GL_LESS);
}
static void copied(void) {
  frame(50);
  GLuint texture = 0;
  glGenTextures(1, &texture), glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, 128, 128, 0);
  clear(), glLoadIdentity(), glEnable(GL_TEXTURE_2D), glColor3f(1, 1, 1);
  glBegin(GL_QUADS);
  glTexCoord2f(0, 0), glVertex2f(-0.8f, -0.8f), glTexCoord2f(1, 0), glVertex2f(0.8f, -0.8f);
  glTexCoord2f(1, 1), glVertex2f(0.8f, 0.8f), glTexCoord2f(0, 1), glVertex2f(-0.8f, 0.8f);
  glEnd();
  glDisable(GL_TEXTURE_2D), swap(), window_shows();
  glDeleteTextures(1, &texture);
}
static void blitted(void) {
  const GLuint framebuffer = framebuffer_of(0);
  frame(80);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer), clear();
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer), buffer_holds();
  surface(5);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, 100, 100, 50, 40, 150, 140, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0), swap(), window_shows();
  glDeleteFramebuffers(1, &framebuffer);
}
static void other_context(void) {
  GLXContext other = glXCreateContext(display, visual, NULL, True);
  frame(85), window_shows();
  glXMakeCurrent(display, window, other), glEnable(GL_DEPTH_TEST), lines(), swap(), window_shows();
  frame(20), window_shows();
  glXMakeCurrent(display, window, context), lines(), swap(), window_shows();
  glXDestroyContext(display, other);
}
static void other_window(void) {
  Window first = window;
  XSetWindowAttributes attributes = {.override_redirect = True,
                                     .colormap = XCreateColormap(display, first, visual->visual, AllocNone)};
  const Window another =
      XCreateWindow(display, DefaultRootWindow(display), 300, 0, 200, 150, 0, visual->depth, InputOutput,
                    visual->visual, CWBorderPixel | CWColormap | CWOverrideRedirect, &attributes);
  XMapWindow(display, another);
  for (int i = 0; i < 5; ++i) {
    window = i % 2 ? another : first;
    glXMakeCurrent(display, window, context), frame(17.0f * (float)i), window_shows();
  }
  window = first, glXMakeCurrent(display, first, context);
  lines(), swap(), window_shows();
  XDestroyWindow(display, another);
}
static void resize(int to_width, int to_height) {
  width = to_width, height = to_height;
  XResizeWindow(display, window, (unsigned)width, (unsigned)height), XSync(display, False);
  glViewport(0, 0, width, height);
}
static void resized(void) {
  frame(33);
  for (int i = 0; i < 3; ++i) {
    resize(200 + 60 * (i % 2), 150 + 40 * i);
    frame(33), frame(34), window_shows(), buffer_holds();
    frame(35), lines(), swap(), window_shows();
  }
}
/* The first frame after a change of the window's size is the only one at that size. */
static void resized_each(void) {
  frame(40), frame(41);
  for (int i = 0; i < 4; ++i) resize(200 + 30 * i, 190 - 20 * i), frame(42), window_shows();
  buffer_holds();
}
/* The window's upper left corner, of that size. */
static void corner_shows(int of_width, int of_height) {
  const int now[2] = {width, height};
  width = of_width, height = of_height, window_shows();
  width = now[0], height = now[1];
}
static void resized_after_clear(void) { /* that frame is still as large as its clear */
  frame(51), frame(52);
  for (int i = 0; i < 2; ++i) {
    clear(), resize(240 - 50 * i, 170 + 20 * i), surface(53), swap();
    frame(54), window_shows(), frame(55);
    glClearColor(0.7f, 0.3f * (float)i, 0.1f, 1), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const int before[2] = {width, height};
    resize(250 + 40 * i, 180 + 30 * i), surface(56), swap();
    corner_shows(before[0], before[1]), frame(57), window_shows();
  }
  buffer_holds();
}
static void resized_then_drawn(void) {
  frame(43), frame(44), resize(260, 190);
  clear(), surface(45), lines(), corner_shows(200, 150), swap(), window_shows(), buffer_holds();
  frame(46), frame(47), resize(180, 210), clear(), buffer_holds(), surface(48), swap(), window_shows();
  frame(49), frame(50), resize(230, 160), glClear(GL_DEPTH_BUFFER_BIT), clear(), lines(), swap();
  window_shows();
}
/* A new context whose first frame is empty; the window may change its size before its first image. */
static void after_empty(int wider) {
  GLXContext other = glXCreateContext(display, visual, NULL, True);
  glXMakeCurrent(display, window, other), glEnable(GL_DEPTH_TEST);
  clear(), swap();
  if (wider) resize(width + wider, height);
  glViewport(0, 0, width, height);
  frame(65), window_shows(), buffer_holds();
  lines(), swap(), window_shows();
  frame(40), window_shows(), buffer_holds();
  glXMakeCurrent(display, window, context), glXDestroyContext(display, other);
}
static void empty_first(void) { after_empty(0); }
static void empty_then_resized(void) { after_empty(70); }
static void on_and_on(void) { /* a program that never clears everything: GLuRay soon stops trying */
  for (int i = 0; i < 12; ++i) {
    frame(9.0f * (float)i);
    if (i % 5 != 4) lines(), swap();
    window_shows();
  }
}
static void queried(void) {
  GLuint query = 0, samples = 0;
  glGenQueries(1, &query);
  frame(3);
  glBeginQuery(GL_SAMPLES_PASSED, query), surface(3), lines(), glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  swap(), window_shows(), buffer_holds();
  glDeleteQueries(1, &query);
}
static void glx_window(void) { /* GLX 1.3 has names of its own */
  static const int wanted[] = {GLX_DOUBLEBUFFER, True, GLX_DEPTH_SIZE, 24, None};
  int count = 0;
  GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  GLXFBConfig same = NULL;
  for (int i = 0; i < count && !same; ++i) {
    XVisualInfo* its = glXGetVisualFromFBConfig(display, configs[i]);
    if (its && its->visualid == visual->visualid) same = configs[i];
    if (its) XFree(its);
  }
  if (!same) fprintf(stderr, "no such configuration\n"), exit(1);
  glXMakeCurrent(display, None, NULL), glXDestroyContext(display, context);
  context = glXCreateNewContext(display, same, GLX_RGBA_TYPE, NULL, True);
  const GLXWindow named = glXCreateWindow(display, same, window, NULL);
  if (!glXMakeContextCurrent(display, named, named, context)) fprintf(stderr, "not current\n"), exit(1);
  glEnable(GL_DEPTH_TEST);
  for (int i = 0; i < 3; ++i) {
    clear(), surface(40.0f * (float)i), glXSwapBuffers(display, named), window_shows();
  }
  surface(10), glXSwapBuffers(display, named), window_shows();
  glXMakeCurrent(display, window, context), glXDestroyWindow(display, named);
  frame(50), window_shows();
}
static void errors_kept(void) {
  glEnable(0x1234), frame(21), window_shows();
  if (glGetError() != GL_INVALID_ENUM || glGetError() != GL_NO_ERROR)
    fprintf(stderr, "error lost\n"), exit(1);
}

static const struct ShowCase kCases[] = {
    CASE(moving),
    CASE(unchanged),
    CASE(swapped_again),
    CASE(read_afterwards),
    CASE(drawn_over),
    CASE(lines_over),
    CASE(depth_cleared),
    CASE(colour_cleared),
    CASE(part_cleared),
    CASE(masked_clear),
    CASE(smaller_viewport),
    CASE(far_plane),
    CASE(copied),
    CASE(blitted),
    CASE(other_context),
    CASE(other_window),
    CASE(resized),
    CASE(resized_each),
    CASE(resized_after_clear),
    CASE(resized_then_drawn),
    CASE(empty_first),
    CASE(empty_then_resized),
    CASE(on_and_on),
    CASE(queried),
    CASE(glx_window),
    CASE(errors_kept),
    {NULL, NULL},
};

int main(int argc, char** argv) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, GLX_STENCIL_SIZE, 8, None};
  display = XOpenDisplay(NULL);
  visual = display ? glXChooseVisual(display, DefaultScreen(display), wanted) : NULL;
  if (!visual) return fprintf(stderr, "no display, or no visual\n"), 1;
  XSetWindowAttributes attributes = {
      .override_redirect = True,
      .colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone)};
  window = XCreateWindow(display, DefaultRootWindow(display), 0, 0, (unsigned)width, (unsigned)height, 0,
                         visual->depth, InputOutput, visual->visual,
                         CWBorderPixel | CWColormap | CWOverrideRedirect, &attributes);
  XMapWindow(display, window), XSync(display, False);
  context = glXCreateContext(display, visual, NULL, True);
  if (!glXMakeCurrent(display, window, context)) return fprintf(stderr, "no context\n"), 1;
  glEnable(GL_DEPTH_TEST);
  const struct ShowCase* const all[] = {kCases, kClearCases};
  for (int i = 0; i < 2; ++i)
    for (const struct ShowCase* one = all[i]; one->name; ++one)
      if (argc > 1 && strcmp(argv[1], one->name) == 0) {
        frame(90);
        one->run();
        XDestroyWindow(display, window);
        XCloseDisplay(display); /* with the context current */
        return 0;
      }
  for (int i = 0; i < 2; ++i)
    for (const struct ShowCase* one = all[i]; one->name; ++one) fprintf(stderr, "%s\n", one->name);
  return 2;
}
