/* A program that draws a frame for each line that it reads from standard input, and prints a checksum of the
 * image that it reads back: client [exposed | always [MILLISECONDS [egl]]]. exposed: Expose events of
 * its window make it draw, too; their lines begin with "exposed". always: it draws all the time, turning, a
 * frame in so many milliseconds (0: as fast as it can). egl: it shows its window by EGL. The line "fork"
 * makes a child process that ends a second later, and prints its number; "reuse" closes all descriptors above
 * 2 but the display's, and opens the file "data" as often, to which it writes "mine" each time; "check"
 * prints how many of these are open; "count" prints the number of frames since the start and the seconds of
 * the monotonic clock. The line "show" draws a frame that is not read back, and prints "shown"; from then on
 * so do Expose events.
 */
#include "tests/doors/programs/two_rings.h"
#include "tests/doors/programs/x_window.h"

#include <EGL/egl.h>
#include <GL/glx.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { kWidth = 160, kHeight = 120 };

static uint64_t checksum(void) {
  static unsigned char pixels[kWidth * kHeight * 4];
  uint64_t hash = 14695981039346656037u; /* FNV-1a */
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  for (size_t i = 0; i < sizeof pixels; ++i) hash = (hash ^ pixels[i]) * 1099511628211u;
  return hash;
}

static int isRead = 1; /* frames are read back */
static long frames;
static EGLDisplay egl;
static EGLSurface surface;

static void showRings(Display* display, Window window, int turns, int prints) {
  ++frames;
  drawTwoRings(kWidth, kHeight, 20 + (turns ? (float)(frames % 360) : 0));
  if (prints) printf("%016llx\n", (unsigned long long)checksum());
  fflush(stdout);
  if (!egl)
    glXSwapBuffers(display, window);
  else
    eglSwapBuffers(egl, surface);
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void showUnread(Display* display, Window window) {
  isRead = 0;
  showRings(display, window, 0, 0);
  printf("shown\n"), fflush(stdout);
}

enum { kFiles = 60 };
static int files[kFiles];

static void reuseDescriptors(Display* display) {
  for (int number = 3; number < 1000; ++number)
    if (number != ConnectionNumber(display)) close(number);
  for (int i = 0; i < kFiles; ++i) {
    files[i] = open("data", O_WRONLY | O_APPEND | O_CREAT, 0600);
    if (write(files[i], "mine\n", 5) != 5) exit(5);
  }
  printf("reused\n"), fflush(stdout);
}

static void checkDescriptors(void) {
  int count = 0;
  for (int i = 0; i < kFiles; ++i) count += fcntl(files[i], F_GETFD) >= 0;
  printf("%d\n", count), fflush(stdout);
}

static void makeChild(void) {
  const pid_t child = fork();
  if (child == 0) sleep(1), exit(0);
  printf("%d\n", (int)child);
  fflush(stdout);
}

/* Whether the server has exposed the window. */
static int takeExposures(Display* display) {
  int exposed = 0;
  for (XEvent event; XPending(display) > 0; exposed = exposed || event.type == Expose)
    XNextEvent(display, &event);
  return exposed;
}

/* Shows a window by EGL, whose surface is made before the first context: GLuRay does not know the window. */
static void showByEgl(Display* display, Window shown) {
  static const EGLint wanted[] = {
      EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
  EGLConfig config;
  EGLint count = 0;
  egl = eglGetDisplay((EGLNativeDisplayType)display);
  eglInitialize(egl, NULL, NULL), eglBindAPI(EGL_OPENGL_API);
  if (!eglChooseConfig(egl, wanted, &config, 1, &count) || count == 0) fprintf(stderr, "no EGL\n"), exit(1);
  surface = eglCreateWindowSurface(egl, config, shown, NULL);
  eglMakeCurrent(egl, surface, surface, eglCreateContext(egl, config, EGL_NO_CONTEXT, NULL));
}

int main(int argc, char** argv) {
  const int exposed = argc > 1 && strcmp(argv[1], "exposed") == 0;
  const int always = argc > 1 && strcmp(argv[1], "always") == 0;
  const double period = argc > 2 ? atof(argv[2]) / 1000 : 0;
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  Display* display = openDisplay();
  XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!visual) return fprintf(stderr, "no visual\n"), 1;
  const Window window = makeWindow(display, visual);
  XResizeWindow(display, window, kWidth, kHeight);
  XSync(display, False);
  if (exposed) XSelectInput(display, window, ExposureMask);
  if (argc > 3 && strcmp(argv[3], "egl") == 0)
    showByEgl(display, window);
  else
    glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
  setvbuf(stdin, NULL, _IONBF, 0); /* poll() sees what is not read yet */
  struct pollfd inputs[] = {{STDIN_FILENO, POLLIN, 0}, {ConnectionNumber(display), POLLIN, 0}};
  double due = now();
  for (char line[64];;) {
    if (takeExposures(display) && exposed) {
      if (isRead) printf("exposed ");
      showRings(display, window, 0, isRead);
    }
    if (XPending(display) > 0) continue;
    const double rest = due - now();
    if (always && rest <= 0) {
      due = rest < -period ? now() + period : due + period;
      showRings(display, window, 1, 0);
    }
    poll(inputs, 2, !always ? -1 : due > now() ? (int)((due - now()) * 1000) + 1 : 0);
    if (!inputs[0].revents) continue;
    if (!fgets(line, sizeof line, stdin)) return 0;
    if (strcmp(line, "fork\n") == 0)
      makeChild();
    else if (strcmp(line, "reuse\n") == 0)
      reuseDescriptors(display);
    else if (strcmp(line, "check\n") == 0)
      checkDescriptors();
    else if (strcmp(line, "count\n") == 0)
      printf("%ld %.9f\n", frames, now()), fflush(stdout);
    else if (strcmp(line, "show\n") == 0)
      showUnread(display, window);
    else
      isRead = 1, showRings(display, window, always, 1);
  }
}
