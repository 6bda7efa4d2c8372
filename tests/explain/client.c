/* A program whose frames are known to the pixel: client MODE [SIGNAL].
   plain      1000 frames
   different  with a square of 10 x 10 pixels, over the traced surface, only in runs with GLuRay
   restless   with a different background in every run
   short      ends by itself after 5 frames, with exit code 3
   single     1000 frames without a back buffer, shown by glFlush
   still      2 frames, then nothing until it is asked to end
   front      1000 frames in the front buffer of a double-buffered window, shown by glFlush
   unseen     1000 frames that are not shown: the program reads them
   killed     5 frames, then it ends by the signal whose number is the next argument
   unshown    a frame that is not shown, two seconds, then the same frame
   signals    5 frames, and then it prints whether each signal has a handler
   front and unseen have no handler for SIGTERM.
   The colour of the traced surface follows the clock. */
#include "../doors/programs/x_window.h"

#include <GL/glx.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/time.h>
#include <unistd.h>

enum { kWindow = 256, kGrid = 10 };

static volatile sig_atomic_t asked;
static void onTerminate(int signal) {
  (void)signal;
  asked = 1;
}

static float clockColor(void) {
  struct timeval now;
  gettimeofday(&now, NULL);
  return 0.25f + 0.5f * (float)(now.tv_usec / 1000) / 1000.0f;
}

/* A quad in pixels with sloping depth: flat ones are left to the real OpenGL. */
static void quad(int x, int y, int width, int height, float depth) {
  glVertex3f((float)x, (float)y, -depth);
  glVertex3f((float)(x + width), (float)y, -depth - 0.1f);
  glVertex3f((float)(x + width), (float)(y + height), -depth - 0.1f);
  glVertex3f((float)x, (float)(y + height), -depth);
}

/* 200 triangles by glDrawElements, 64 x 64 pixels at (160, 160). */
static void grid(void) {
  static GLfloat vertices[(kGrid + 1) * (kGrid + 1)][3];
  static GLuint indices[kGrid * kGrid * 6];
  int n = 0;
  for (int j = 0; j <= kGrid; ++j)
    for (int i = 0; i <= kGrid; ++i) {
      GLfloat* v = vertices[j * (kGrid + 1) + i];
      v[0] = 160 + 6.4f * (float)i, v[1] = 160 + 6.4f * (float)j, v[2] = -0.5f - 0.01f * (float)i;
    }
  for (int j = 0; j < kGrid; ++j)
    for (int i = 0; i < kGrid; ++i) {
      const GLuint a = (GLuint)(j * (kGrid + 1) + i), b = a + 1, c = a + kGrid + 1, d = c + 1;
      const GLuint corners[6] = {a, b, d, a, d, c};
      memcpy(indices + n, corners, sizeof corners);
      n += 6;
    }
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, vertices);
  glDrawElements(GL_TRIANGLES, n, GL_UNSIGNED_INT, indices);
  glDisableClientState(GL_VERTEX_ARRAY);
}

/* 3 quads by glDrawArrays, blended and with a stipple of ones, 32 x 32 pixels over the traced quad. */
static void glass(void) {
  static const GLfloat corners[4][3] = {{16, 16, -0.1f}, {48, 16, -0.1f}, {48, 48, -0.2f}, {16, 48, -0.2f}};
  static GLfloat quads[12][3];
  for (int i = 0; i < 12; ++i) memcpy(quads[i], corners[i % 4], sizeof quads[i]);
  glEnable(GL_BLEND);
  glEnable(GL_POLYGON_STIPPLE);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColor4f(1, 1, 1, 0.5f);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, quads);
  glDrawArrays(GL_QUADS, 0, 12);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisable(GL_POLYGON_STIPPLE);
  glDisable(GL_BLEND);
}

static void frame(GLuint list, const char* mode) {
  unsigned char noise = 0;
  if (!strcmp(mode, "restless") && getrandom(&noise, 1, 0) != 1) exit(1);
  glClearColor(0, 0, (float)noise / 255.0f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const float color = clockColor();
  glColor3f(color, 0, 0);
  glBegin(GL_QUADS); /* 2 triangles, 128 x 128 pixels */
  quad(0, 0, 128, 128, 0.3f);
  glEnd();
  glColor3f(0, color, 0);
  glCallList(list);
  grid();
  glass();
  glColor3f(1, 1, 1);
  glBegin(GL_LINES); /* 4 lines, away from all traced surfaces */
  for (int i = 0; i < 4; ++i)
    glVertex3f(140.5f, 8.5f + 8 * (float)i, -0.2f), glVertex3f(240.5f, 8.5f + 8 * (float)i, -0.2f);
  glEnd();
  if (!strcmp(mode, "different") && !getenv("GLURAY_OFF")) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(60, 60, 10, 10);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
  }
}

/* Ends the program as the kernel or another process would; SIGSEGV by a real access violation. */
static void endBy(int number) {
  if (number == SIGSEGV) *(volatile int*)NULL = 1;
  raise(number);
}

static void printHandlers(void) {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action;
    if (sigaction(number, NULL, &action)) continue;
    printf("signal %d: %s\n", number,
           action.sa_handler == SIG_DFL   ? "default"
           : action.sa_handler == SIG_IGN ? "ignored"
                                          : "handled");
  }
}

int main(int count, char** words) {
  const char* mode = count > 1 ? words[1] : "plain";
  const int killed = !strcmp(mode, "killed"), unshown = !strcmp(mode, "unshown"),
            signals = !strcmp(mode, "signals"), front = !strcmp(mode, "front"),
            unseen = !strcmp(mode, "unseen");
  const int frames = !strcmp(mode, "short") || killed || signals ? 5
                     : unshown                                   ? 1
                     : !strcmp(mode, "still")                    ? 2
                                                                 : 1000;
  if (!front && !unseen && !killed && !unshown && !signals) signal(SIGTERM, onTerminate);
  Display* display = openDisplay();
  const int single = !strcmp(mode, "single");
  int wanted[] = {GLX_RGBA, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, single ? None : GLX_DOUBLEBUFFER, None};
  XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!visual) return 1;
  const Window window = makeWindow(display, visual);
  XResizeWindow(display, window, kWindow, kWindow);
  XSync(display, False);
  const GLXContext context = glXCreateContext(display, visual, NULL, True);
  if (!context || !glXMakeCurrent(display, window, context)) return 1;
  /* Mesa has the first, but no registry; nobody has the second, but Mesa makes functions for all names. */
  const char* const names[] = {"glInternalSetError", "glNobodyKnowsThis"};
  for (int i = 0; i < 2; ++i)
    if (glXGetProcAddressARB((const GLubyte*)names[i])) printf("has %s\n", names[i]);
  fflush(stdout);

  glViewport(0, 0, kWindow, kWindow);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(0, kWindow, 0, kWindow, 0, 1);
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_QUADS); /* 6 triangles, 3 x 20 x 20 pixels */
  for (int i = 0; i < 3; ++i) quad(140 + 30 * i, 100, 20, 20, 0.4f);
  glEnd();
  glEndList();

  if (front) glDrawBuffer(GL_FRONT);
  for (int i = 0; i < frames && !asked; ++i) {
    unsigned char pixel[4];
    frame(list, mode);
    if (single || front)
      glFlush();
    else if (unseen || unshown)
      glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    else
      glXSwapBuffers(display, window);
    usleep(1000);
  }
  if (unshown) sleep(2);
  if (killed || unshown) endBy(count > 2 ? atoi(words[2]) : SIGKILL);
  if (signals) printHandlers();
  while (!strcmp(mode, "still") && !asked) usleep(10000);
  if (asked) {
    printf("asked to end\n");
    fflush(stdout);
    return 0;
  }
  return !strcmp(mode, "short") ? 3 : 0;
}
