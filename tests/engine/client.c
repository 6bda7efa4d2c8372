/* A program whose scene changes: engine_client PATH TRIANGLES FRAMES [TRIANGLES FRAMES ...]. PATH: list,
   arrays, vbo, immediate. For each pair it draws so many frames of a wavy sheet of about so many triangles,
   in a window of 512 x 512 pixels, and prints the sum of the last frame's colours, and milliseconds a frame
   without the first ten. */
#define _POSIX_C_SOURCE 199309L
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { kSize = 512 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static float* corners; /* position and normal of each corner */
static int cornerCount;

static void corner(int x, int y, int squares) {
  const float u = 2.0f * (float)x / (float)squares - 1, v = 2.0f * (float)y / (float)squares - 1;
  float* c = corners + 6 * cornerCount++;
  c[0] = u, c[1] = v, c[2] = 0.2f * sinf(5 * u) * cosf(4 * v);
  c[3] = -cosf(5 * u) * cosf(4 * v), c[4] = 0.8f * sinf(5 * u) * sinf(4 * v), c[5] = 1;
}

static void makeSheet(int triangles) {
  const int squares = (int)sqrt(triangles / 2.0) + 1;
  free(corners);
  corners = malloc(sizeof(float) * 6 * 6 * (size_t)squares * (size_t)squares);
  cornerCount = 0;
  for (int y = 0; y < squares; ++y)
    for (int x = 0; x < squares; ++x) {
      corner(x, y, squares), corner(x + 1, y, squares), corner(x + 1, y + 1, squares);
      corner(x, y, squares), corner(x + 1, y + 1, squares), corner(x, y + 1, squares);
    }
}

static void immediate(void) {
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < cornerCount; ++i) glNormal3fv(corners + 6 * i + 3), glVertex3fv(corners + 6 * i);
  glEnd();
}

static void fromArrays(const char* base) {
  glEnableClientState(GL_VERTEX_ARRAY), glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 24, base);
  glNormalPointer(GL_FLOAT, 24, base + 12);
  glDrawArrays(GL_TRIANGLES, 0, cornerCount);
}

static void prepare(const char* path) {
  if (!strcmp(path, "list")) {
    glNewList(1, GL_COMPILE);
    immediate();
    glEndList();
  } else if (!strcmp(path, "vbo")) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(sizeof(float) * 6 * (size_t)cornerCount), corners,
                 GL_STATIC_DRAW);
  }
}

static void draw(const char* path, int frame) {
  const float light[4] = {0.5f, 0.5f, 1, 0};
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST), glEnable(GL_LIGHTING), glEnable(GL_LIGHT0), glEnable(GL_NORMALIZE);
  glMatrixMode(GL_PROJECTION), glLoadIdentity(), glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
  glMatrixMode(GL_MODELVIEW), glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glTranslatef(0, 0, -2.2f), glRotatef(-30 + 0.1f * (float)frame, 1, 0, 0);
  if (!strcmp(path, "list"))
    glCallList(1);
  else if (!strcmp(path, "immediate"))
    immediate();
  else
    fromArrays(strcmp(path, "vbo") ? (const char*)corners : NULL);
}

int main(int argc, char** argv) {
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  Display* display = XOpenDisplay(NULL);
  XVisualInfo* visual = display ? glXChooseVisual(display, DefaultScreen(display), wanted) : NULL;
  if (!visual || argc < 4) return 1;
  XSetWindowAttributes attributes = {0};
  attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
  const Window window =
      XCreateWindow(display, DefaultRootWindow(display), 0, 0, kSize, kSize, 0, visual->depth, InputOutput,
                    visual->visual, CWColormap | CWBorderPixel, &attributes);
  XMapWindow(display, window);
  glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
  glViewport(0, 0, kSize, kSize);
  static unsigned char pixels[kSize * kSize * 4];
  for (int a = 2; a + 1 < argc; a += 2) {
    const int frames = atoi(argv[a + 1]), warm = frames > 20 ? 10 : 0;
    makeSheet(atoi(argv[a]));
    prepare(argv[1]);
    double start = now();
    for (int frame = 0; frame < frames; ++frame) {
      if (frame == warm) glFinish(), start = now();
      draw(argv[1], frame);
      if (frame == frames - 1) glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
      glXSwapBuffers(display, window);
    }
    glFinish();
    const double ms = 1000 * (now() - start) / (frames - warm);
    unsigned long sum = 0;
    for (size_t i = 0; i < sizeof pixels; ++i) sum += pixels[i];
    printf("%d %lu %.3f\n", cornerCount / 3, sum, ms);
  }
  return glGetError() != GL_NO_ERROR;
}
