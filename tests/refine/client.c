/* A program whose window is refined: client HABIT.
 *
 * Draws a scene of rings on a floor, and lines over it, then does as its habit says. Images of the window,
 * as X shows it, go to standard output as PPM after a line that names them. */
#include "tests/refine/refined_window.h"

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

/* As programs save what their window shows. OpenGL does not say what the back buffer holds after a swap, but
 * Mesa keeps the frame there, and has none in the front buffer of software contexts. */
static void readsAfter(int overlay) {
  show(0, overlay);
  look("first");
  glEnable(GL_TEXTURE); /* an error, which the read must leave */
  readPixels("last");
  readPixels("again");
  readFloats("floats");
  if (glGetError() != GL_INVALID_ENUM || glGetError() != GL_NO_ERROR) exit(3);
  nap(1500);
  look("window");
}

static void readsShown(void) { readsAfter(1); }
static void readsPlain(void) { readsAfter(0); }

/* As programs find out what is under the pointer. */
static void picks(void) {
  unsigned char pixels[16 * 16 * 4];
  show(0, 1);
  for (int i = 0; i < 100; ++i) glReadPixels(i, i, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

static GLuint makeFramebufferOf(GLenum colors, int samples) {
  GLuint name, buffers[2];
  glGenFramebuffers(1, &name), glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, i ? GL_DEPTH_COMPONENT24 : colors, kWidth,
                                     kHeight);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              buffers[i]);
  }
  return name;
}

static GLuint makeFramebuffer(void) { return makeFramebufferOf(GL_RGBA8, 0); }

/* Reads framebuffers beside the shown window that cannot hold its finished image: of floats, of integers,
 * and multisampled, which OpenGL refuses to read. */
static void readsOthers(void) {
  static GLuint numbers[kWidth * kHeight * 4];
  const GLuint seven[4] = {7, 7, 7, 7};
  show(0, 1);
  look("first");
  const GLuint floats = makeFramebufferOf(GL_RGBA32F, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, floats);
  readPixels("last");
  makeFramebufferOf(GL_RGBA32UI, 0);
  glClearBufferuiv(GL_COLOR, 0, seven);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA_INTEGER, GL_UNSIGNED_INT, numbers);
  if (glGetError() != GL_NO_ERROR) exit(3);
  for (int i = 0; i < kWidth * kHeight * 4; ++i)
    if (numbers[i] != 7) exit(4);
  makeFramebufferOf(GL_RGBA8, 4);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, numbers);
  if (glGetError() != GL_INVALID_OPERATION || glGetError() != GL_NO_ERROR) exit(5);
}

/* Draws into a framebuffer object, shows a copy, and reads another one; before the swap, too. */
static void readsCopies(void) {
  const GLuint drawn = makeFramebuffer(), copied = makeFramebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, drawn);
  drawScene(0);
  drawOverlay();
  for (int i = 0; i < 2; ++i) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn), glBindFramebuffer(GL_DRAW_FRAMEBUFFER, i ? 0 : copied);
    glBlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, copied);
  readPixels("last");
  glXSwapBuffers(g_display, g_window);
  look("first");
  readPixels("again");
  readFloats("floats");
  GLint bound = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  if (glGetError() != GL_NO_ERROR || bound != (GLint)copied) exit(3);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  nap(1500);
  look("window");
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
  } habits[] = {{"plain", plain, 0},
                {"overlays", overlays, 0},
                {"redraws", redraws, 0},
                {"reads", reads, 0},
                {"hidden", reads, 1},
                {"goes-on", goesOn, 0},
                {"paints", paints, 0},
                {"leaves", leaves, 0},
                {"closes", closes, 0},
                {"destroys", destroys, 0},
                {"resizes", resizes, 0},
                {"reads-shown", readsShown, 0},
                {"reads-plain", readsPlain, 0},
                {"picks", picks, 0},
                {"reads-copies", readsCopies, 0},
                {"reads-others", readsOthers, 0}};
  for (size_t i = 0; argc > 1 && i < sizeof habits / sizeof *habits; ++i) {
    if (strcmp(argv[1], habits[i].name) != 0) continue;
    if (!openWindow(!habits[i].hidden)) return 1;
    habits[i].run();
    return 0;
  }
  fprintf(stderr, "client HABIT\n");
  return 2;
}
