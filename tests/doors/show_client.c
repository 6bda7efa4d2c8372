/* show_client: writes to standard output, as PPMs, what a window shows frame after frame, and its buffers.
 * Draws frames of only a clear and surfaces, and everything that can follow such a frame. Needs an X
 * server. */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kMost = 320 };
static Display* display;
static Window window;
static XVisualInfo* visual;
static GLXContext context;
static int width = 200, height = 150;

static void writePicture(const unsigned char* rgb, int w, int h) {
  printf("P6\n%d %d\n255\n", w, h);
  fwrite(rgb, 3, (size_t)(w * h), stdout);
}

/* The window's content, as the user sees it. */
static void window_shows(void) {
  static unsigned char rgb[kMost * kMost * 3];
  XSync(display, False);
  XImage* image = XGetImage(display, window, 0, 0, (unsigned)width, (unsigned)height, AllPlanes, ZPixmap);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      unsigned char* to = rgb + 3 * (y * width + x);
      to[0] = (unsigned char)(pixel >> 16), to[1] = (unsigned char)(pixel >> 8), to[2] = (unsigned char)pixel;
    }
  XDestroyImage(image);
  writePicture(rgb, width, height);
}

/* The buffers, as the program reads them: colours, and the higher bytes of depths. */
static void buffer_holds(void) {
  static unsigned char rgb[kMost * kMost * 3];
  static unsigned depth[kMost * kMost];
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
  writePicture(rgb, width, height);
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < 3; ++c) rgb[3 * i + c] = (unsigned char)(depth[i] >> (24 - 8 * c));
  writePicture(rgb, width, height);
}

static void swap(void) { glXSwapBuffers(display, window); }

static void clear(void) {
  glClearColor(0.2f, 0.35f, 0.5f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/* Two intersecting triangles. */
static void surface(float turn) {
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glRotatef(turn, 0.2f, 1, 0.1f);
  glBegin(GL_TRIANGLES);
  for (int k = 0; k < 2; ++k) {
    const float side = k ? 1 : -1;
    glColor3f(0.9f, 0.3f + 0.2f * side, 0.2f), glVertex3f(-0.7f, -0.6f, 0.4f * side);
    glColor3f(0.2f, 0.8f, 0.3f), glVertex3f(0.6f, -0.7f, 0.1f);
    glColor3f(0.3f, 0.3f, 0.9f), glVertex3f(0.1f * side, 0.7f, -0.3f * side);
  }
  glEnd();
}

static void frame(float turn) { clear(), surface(turn), swap(); }

/* Lines in space: their pixels depend on the depth buffer. */
static void lines(void) {
  glColor3f(1, 1, 1);
  glBegin(GL_LINES);
  for (int i = -5; i < 6; ++i) {
    glVertex3f(0.15f * (float)i, -0.9f, -0.6f), glVertex3f(-0.15f * (float)i, 0.9f, 0.6f);
    glVertex3f(-0.9f, 0.15f * (float)i, 0.6f), glVertex3f(0.9f, -0.15f * (float)i, -0.6f);
  }
  glEnd();
}

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
  GLuint objects[2], framebuffer = 0;
  glGenRenderbuffers(2, objects), glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (int k = 0; k < 2; ++k) {
    glBindRenderbuffer(GL_RENDERBUFFER, objects[k]);
    glRenderbufferStorage(GL_RENDERBUFFER, k ? GL_DEPTH24_STENCIL8 : GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, k ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              objects[k]);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0), frame(80);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer), clear();
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer), buffer_holds();
  surface(5);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, 100, 100, 50, 40, 150, 140, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0), swap(), window_shows();
  glDeleteFramebuffers(1, &framebuffer), glDeleteRenderbuffers(2, objects);
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
static void resized(void) {
  frame(33);
  for (int i = 0; i < 3; ++i) {
    width = 200 + 60 * (i % 2), height = 150 + 40 * i;
    XResizeWindow(display, window, (unsigned)width, (unsigned)height), XSync(display, False);
    glViewport(0, 0, width, height);
    frame(33), frame(34), window_shows(), buffer_holds();
    frame(35), lines(), swap(), window_shows();
  }
}
/* A new context whose first frame is empty; the window may change its size before its first picture. */
static void after_empty(int wider) {
  GLXContext other = glXCreateContext(display, visual, NULL, True);
  glXMakeCurrent(display, window, other), glEnable(GL_DEPTH_TEST);
  clear(), swap();
  width += wider;
  if (wider) XResizeWindow(display, window, (unsigned)width, (unsigned)height), XSync(display, False);
  glViewport(0, 0, width, height);
  frame(65), window_shows(), buffer_holds();
  lines(), swap(), window_shows();
  frame(40), window_shows(), buffer_holds();
  glXMakeCurrent(display, window, context), glXDestroyContext(display, other);
}
static void empty_first(void) { after_empty(0); }
static void empty_then_resized(void) { after_empty(70); }
/* Frames whose clear is followed by anything but traced surfaces alone. */
static void clear_alone(void) { frame(10), clear(), swap(), window_shows(), frame(20), window_shows(); }
static void clear_read(void) { frame(20), clear(), buffer_holds(), surface(30), swap(), window_shows(); }
static void clear_and_lines(void) {
  frame(40), clear(), lines(), surface(50), swap(), window_shows();
  frame(60), window_shows(), buffer_holds();
}
static void clear_then_part(void) {
  frame(65), clear();
  glEnable(GL_SCISSOR_TEST), glScissor(40, 30, 90, 60), glClearColor(0.9f, 0.1f, 0.1f, 1);
  glClear(GL_COLOR_BUFFER_BIT), glDisable(GL_SCISSOR_TEST);
  surface(70), swap(), window_shows(), buffer_holds();
}
static void clear_stencil(void) {
  frame(80), glClearStencil(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glClearStencil(0), glEnable(GL_STENCIL_TEST), glStencilFunc(GL_EQUAL, 1, 255);
  lines(), glDisable(GL_STENCIL_TEST), surface(85), swap(), window_shows();
}
static void clear_refused(void) {
  frame(80), glClearColor(1, 0, 0, 1), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | 0x10);
  if (glGetError() != GL_INVALID_VALUE) fprintf(stderr, "no error\n"), exit(1);
  lines(), swap(), window_shows();
}
static void clear_values(void) { /* a clear has the values and masks of its time */
  frame(80), clear();
  glClearColor(0.1f, 0.9f, 0.1f, 1), glClearDepth(0.3);
  glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE), glDepthMask(GL_FALSE);
  surface(85), lines();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), glDepthMask(GL_TRUE), glClearDepth(1);
  swap(), window_shows();
  frame(90), glClearDepth(0.5), clear(), glClearDepth(1), surface(95), swap(), window_shows(), buffer_holds();
}
static void clear_then_front(void) {
  frame(15), clear();
  glDrawBuffer(GL_FRONT), lines(), glFlush(), glDrawBuffer(GL_BACK);
  window_shows(), surface(25), swap(), window_shows();
}
static void clear_then_attributes(void) {
  glPushAttrib(GL_ALL_ATTRIB_BITS), glDrawBuffer(GL_FRONT);
  glPushAttrib(GL_ALL_ATTRIB_BITS), glDrawBuffer(GL_BACK);
  frame(35), clear(), glPopAttrib(), lines(), glFlush(), window_shows();
  glPopAttrib(), surface(45), swap(), window_shows();
}
static GLuint framebuffer_of(int samples) {
  GLuint objects[2], framebuffer = 0;
  glGenRenderbuffers(2, objects), glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (int k = 0; k < 2; ++k) {
    glBindRenderbuffer(GL_RENDERBUFFER, objects[k]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, k ? GL_DEPTH24_STENCIL8 : GL_RGBA8, width,
                                     height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, k ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              objects[k]);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}
static void clear_then_object(void) {
  const GLuint object = framebuffer_of(0);
  frame(55), clear();
  glBindFramebuffer(GL_FRAMEBUFFER, object), clear(), surface(5), lines(), buffer_holds();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0), buffer_holds();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0), surface(65), swap(), window_shows();
  glDeleteFramebuffers(1, &object);
}
static void resolved_over(void) {
  const GLuint object = framebuffer_of(4);
  for (int cleared = 0; cleared < 2; ++cleared) {
    frame(75);
    if (cleared) clear();
    glBindFramebuffer(GL_FRAMEBUFFER, object), clear(), surface(15);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 100, 80, 0, 0, 100, 80, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0), swap(), window_shows();
  }
  glDeleteFramebuffers(1, &object);
}
static void evaluated_over(void) {
  static const GLfloat corners[] = {-0.9f, -0.5f, -0.5f, 0.9f, -0.5f, 0.5f,
                                    -0.9f, 0.5f,  -0.3f, 0.9f, 0.5f,  0.3f};
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, corners);
  for (int cleared = 0; cleared < 2; ++cleared) {
    frame(100);
    if (cleared) clear();
    glEnable(GL_MAP2_VERTEX_3), glColor3f(1, 1, 0), glBegin(GL_QUADS);
    glEvalCoord2f(0, 0), glEvalCoord2f(1, 0), glEvalCoord2f(1, 1), glEvalCoord2f(0, 1);
    glEnd(), glDisable(GL_MAP2_VERTEX_3), swap(), window_shows();
  }
}
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

static const struct {
  const char* name;
  void (*run)(void);
} kCases[] = {
#define CASE(name) \
  { #name, name }
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
    CASE(empty_first),
    CASE(empty_then_resized),
    CASE(clear_alone),
    CASE(clear_read),
    CASE(clear_and_lines),
    CASE(clear_then_part),
    CASE(clear_stencil),
    CASE(clear_refused),
    CASE(clear_values),
    CASE(clear_then_front),
    CASE(clear_then_attributes),
    CASE(clear_then_object),
    CASE(resolved_over),
    CASE(evaluated_over),
    CASE(on_and_on),
    CASE(queried),
    CASE(glx_window),
    CASE(errors_kept),
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
  for (size_t i = 0; i < sizeof kCases / sizeof kCases[0]; ++i)
    if (argc > 1 && strcmp(argv[1], kCases[i].name) == 0) {
      frame(90);
      kCases[i].run();
      XDestroyWindow(display, window);
      XCloseDisplay(display); /* with the context current */
      return 0;
    }
  for (size_t i = 0; i < sizeof kCases / sizeof kCases[0]; ++i) fprintf(stderr, "%s\n", kCases[i].name);
  return 2;
}
