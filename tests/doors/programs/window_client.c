/* Habits of programs with windows: window_client HABIT writes the images it read back to standard output,
 * as PPM, to be compared with those of the same program without GLuRay. */
#include "ring.h"
#include "x_window.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/glx.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { kWidth = 200, kHeight = 150 };

static Display* g_display;
static XVisualInfo* g_visual;
static Window g_window;
static GLXContext g_context;

static Window sizedWindow(int width, int height) {
  const Window window = makeWindow(g_display, g_visual);
  XResizeWindow(g_display, window, (unsigned)width, (unsigned)height);
  XSync(g_display, False);
  return window;
}

static int openWindow(int* attributes) {
  g_display = openDisplay();
  g_visual = glXChooseVisual(g_display, DefaultScreen(g_display), attributes);
  if (!g_visual) fprintf(stderr, "the display has no such visual\n"), exit(77);
  g_context = glXCreateContext(g_display, g_visual, NULL, True);
  g_window = sizedWindow(kWidth, kHeight);
  return glXMakeCurrent(g_display, g_window, g_context);
}

static void drawRing(int width, int height, float angle) {
  setRingView(width, height, angle);
  sendRing();
}

static void clear(float red) {
  glClearColor(red, 0.1f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void writeImage(int width, int height) {
  const size_t bytes = (size_t)width * (size_t)height * 3;
  unsigned char* pixels = malloc(bytes);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  printf("P6\n%d %d\n255\n", width, height);
  fwrite(pixels, 1, bytes, stdout);
  free(pixels);
}

/* Habit 2: draws into the front buffer, selects the back buffer, then glFlush; no swap. */
static void front(void) {
  glDrawBuffer(GL_FRONT);
  clear(0.2f);
  drawRing(kWidth, kHeight, 10);
  glDrawBuffer(GL_BACK);
  glFlush();
  clear(0.8f);
  drawRing(kWidth, kHeight, 50);
  glReadBuffer(GL_FRONT);
  writeImage(kWidth, kHeight);
  glReadBuffer(GL_BACK);
  writeImage(kWidth, kHeight);
}

/* Habit 3: reads the back buffer after the swap. Its content is undefined; programs rely on what Mesa leaves
 * there. */
static void readAfterSwap(void) {
  clear(0.2f);
  drawRing(kWidth, kHeight, 10);
  glXSwapBuffers(g_display, g_window);
  glFinish();
  writeImage(kWidth, kHeight);
}

/* A window without a back buffer: glFlush shows the image. */
static void singleBuffered(void) {
  for (int frame = 0; frame < 3; ++frame) {
    clear(0.2f);
    drawRing(kWidth, kHeight, 20 * (float)frame);
    glFlush();
  }
  writeImage(kWidth, kHeight);
}

/* The window grows and shrinks while a frame is drawn. */
static void resized(void) {
  const int widths[] = {kWidth, kWidth + 120, kWidth - 60}, heights[] = {kHeight, kHeight + 70, kHeight - 50};
  for (int i = 0; i < 3; ++i) {
    clear(0.2f);
    drawRing(widths[i], heights[i], 10);
    XResizeWindow(g_display, g_window, (unsigned)widths[(i + 1) % 3], (unsigned)heights[(i + 1) % 3]);
    XSync(g_display, False);
    drawRing(widths[i], heights[i], 70);
    glXSwapBuffers(g_display, g_window);
  }
  for (int frame = 0; frame < 2; ++frame) { /* Mesa takes the size at the swap */
    clear(0.4f);
    drawRing(kWidth, kHeight, 30);
    if (frame == 0) glXSwapBuffers(g_display, g_window);
  }
  writeImage(kWidth, kHeight);
}

/* Windows destroyed and made again while one context exists. */
static void remade(void) {
  for (int i = 0; i < 4; ++i) {
    clear(0.1f * (float)i);
    drawRing(kWidth, kHeight, 15 * (float)i);
    glXSwapBuffers(g_display, g_window);
    glXMakeCurrent(g_display, None, NULL);
    XDestroyWindow(g_display, g_window);
    g_window = sizedWindow(kWidth, kHeight);
    glXMakeCurrent(g_display, g_window, g_context);
  }
  clear(0.5f);
  drawRing(kWidth, kHeight, 33);
  writeImage(kWidth, kHeight);
}

/* Many samples a pixel, read back resolved. */
static void multisampled(void) {
  clear(0.2f);
  drawRing(kWidth, kHeight, 10);
  writeImage(kWidth, kHeight);
}

int main(int argc, char** argv) {
  static int twoBuffers[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  static int oneBuffer[] = {GLX_RGBA, GLX_DEPTH_SIZE, 24, None};
  static int samples[] = {
      GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, GLX_SAMPLE_BUFFERS, 1, GLX_SAMPLES, 4, None};
  const struct {
    const char* name;
    int* attributes;
    void (*run)(void);
  } habits[] = {{"front", twoBuffers, front},          {"read-after-swap", twoBuffers, readAfterSwap},
                {"single", oneBuffer, singleBuffered}, {"resized", twoBuffers, resized},
                {"remade", twoBuffers, remade},        {"multisampled", samples, multisampled}};
  for (size_t i = 0; argc > 1 && i < sizeof habits / sizeof *habits; ++i) {
    if (strcmp(argv[1], habits[i].name) != 0) continue;
    if (!openWindow(habits[i].attributes)) return 1;
    habits[i].run();
    glXMakeCurrent(g_display, None, NULL);
    glXDestroyContext(g_display, g_context);
    return 0;
  }
  fprintf(stderr, "window_client HABIT\n");
  return 2;
}
