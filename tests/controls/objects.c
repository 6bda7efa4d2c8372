/* A program that draws what it reads from standard input, a line a frame, and prints "drawn"; with EGL if the
 * variable CLIENT_EGL is set, otherwise with GLX:
 * items separated by ';', each "STEPS X Y HALF Z BUMP RRGGBB": a lit grid of 2 STEPS^2 triangles about (X,
 * Y), HALF of its width high and wide, its right side nearer by 0.06, and its middle by BUMP. Expose events
 * draw the last line again.
 */
#include "tests/doors/programs/x_window.h"

#include <EGL/egl.h>
#include <GL/glx.h>
#include <math.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { kWidth = 200, kHeight = 200, kMaxSteps = 32 };

struct Grid {
  int steps;
  float x, y, half, z, bump;
  unsigned color;
};

static float heightAt(const struct Grid* grid, float u, float v) {
  return grid->z + 0.03f * u + grid->bump * cosf(1.5707963f * u) * cosf(1.5707963f * v);
}

static float* putVertex(float* at, const struct Grid* grid, int i, int k) {
  const float u = -1 + 2 * (float)i / (float)grid->steps, v = -1 + 2 * (float)k / (float)grid->steps;
  *at++ = grid->x + grid->half * u, *at++ = grid->y + grid->half * v, *at++ = heightAt(grid, u, v);
  return at;
}

static void drawGrid(const struct Grid* grid) {
  static float vertices[kMaxSteps * kMaxSteps * 18];
  const float diffuse[] = {(float)(grid->color >> 16 & 255) / 255, (float)(grid->color >> 8 & 255) / 255,
                           (float)(grid->color & 255) / 255, 1};
  float* at = vertices;
  for (int i = 0; i < grid->steps; ++i)
    for (int k = 0; k < grid->steps; ++k) {
      at = putVertex(at, grid, i, k), at = putVertex(at, grid, i + 1, k),
      at = putVertex(at, grid, i + 1, k + 1);
      at = putVertex(at, grid, i, k), at = putVertex(at, grid, i + 1, k + 1),
      at = putVertex(at, grid, i, k + 1);
    }
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
  glNormal3f(-0.03f / grid->half, 0, 1);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, vertices);
  glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(at - vertices) / 3);
}

static void draw(const char* line) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const char* item = line; item && *item && *item != '\n';) {
    struct Grid grid;
    if (sscanf(item, "%d %f %f %f %f %f %x", &grid.steps, &grid.x, &grid.y, &grid.half, &grid.z, &grid.bump,
               &grid.color) == 7 &&
        grid.steps <= kMaxSteps)
      drawGrid(&grid);
    item = strchr(item, ';');
    if (item) ++item;
  }
}

static void prepare(void) {
  glViewport(0, 0, kWidth, kHeight);
  glMatrixMode(GL_PROJECTION), glOrtho(-1, 1, -1, 1, 1, 9);
  glMatrixMode(GL_MODELVIEW), glTranslatef(0, 0, -5);
  glEnable(GL_DEPTH_TEST), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0), glEnable(GL_NORMALIZE);
}

static EGLDisplay egl;
static EGLSurface surface;

static XVisualInfo* visualOf(Display* display, EGLConfig* config) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  static const EGLint alike[] = {
      EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_ALPHA_SIZE, 0, EGL_DEPTH_SIZE, 24, EGL_NONE};
  if (!getenv("CLIENT_EGL")) return glXChooseVisual(display, DefaultScreen(display), wanted);
  EGLConfig found[64];
  EGLint count = 0, id = 0, blue = 0;
  egl = eglGetDisplay((EGLNativeDisplayType)display);
  eglInitialize(egl, NULL, NULL), eglBindAPI(EGL_OPENGL_API);
  eglChooseConfig(egl, alike, found, 64, &count);
  for (EGLint i = 0; i < count; ++i) { /* deeper colours come first */
    XVisualInfo asked = {0};
    int visuals = 0;
    eglGetConfigAttrib(egl, found[i], EGL_NATIVE_VISUAL_ID, &id),
        eglGetConfigAttrib(egl, found[i], EGL_BLUE_SIZE, &blue);
    asked.visualid = (VisualID)id, *config = found[i];
    XVisualInfo* visual = XGetVisualInfo(display, VisualIDMask, &asked, &visuals);
    if (visual && blue == 8) return visual;
  }
  return NULL;
}

static void makeCurrent(Display* display, Window window, XVisualInfo* visual, EGLConfig config) {
  if (!egl) {
    glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
    return;
  }
  const EGLContext context = eglCreateContext(egl, config, EGL_NO_CONTEXT, NULL);
  surface = eglCreateWindowSurface(egl, config, window, NULL);
  eglMakeCurrent(egl, surface, surface, context);
}

static void swap(Display* display, Window window) {
  egl ? (void)eglSwapBuffers(egl, surface) : glXSwapBuffers(display, window);
}

int main(void) {
  static char line[4096], last[4096];
  EGLConfig config = NULL;
  Display* display = openDisplay();
  XVisualInfo* visual = visualOf(display, &config);
  if (!visual) return fprintf(stderr, "no visual\n"), 1;
  const Window window = makeWindow(display, visual);
  XResizeWindow(display, window, kWidth, kHeight);
  XSelectInput(display, window, ExposureMask);
  XSync(display, False);
  makeCurrent(display, window, visual, config);
  prepare();
  setvbuf(stdin, NULL, _IONBF, 0); /* poll() sees what is not read yet */
  struct pollfd inputs[] = {{STDIN_FILENO, POLLIN, 0}, {ConnectionNumber(display), POLLIN, 0}};
  for (;;) {
    int exposed = 0;
    for (XEvent event; XPending(display) > 0; exposed |= event.type == Expose) XNextEvent(display, &event);
    if (exposed && *last) draw(last), swap(display, window);
    if (XPending(display) > 0) continue;
    poll(inputs, 2, -1);
    if (!inputs[0].revents) continue;
    if (!fgets(line, sizeof line, stdin)) return 0;
    strcpy(last, line);
    draw(last), swap(display, window);
    printf("drawn\n"), fflush(stdout);
  }
}
