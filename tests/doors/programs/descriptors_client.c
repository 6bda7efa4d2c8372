/* Draws through EGL without a display, while it reuses the numbers of descriptors for files of its own.

   descriptors_client second FILE   closes 2 and opens FILE before its first context
   descriptors_client all FOLDER    closes all above 2 after some frames and opens files in FOLDER
   descriptors_client devices       prints how many devices eglQueryDevicesEXT lists
   descriptors_client plain         only draws

   Ends with 0 if the image is right and its files hold what it wrote. */
#define _GNU_SOURCE
#include "egl_config.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { kSize = 64, kFiles = 64, kWrongImage = 3, kWrongFile = 4, kNoContext = 5 };

static EGLDisplay display;
static EGLSurface surface;

static int start(void) {
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
  const EGLConfig config = chooseEglConfig(display, 0);
  if (!config) return 0;
  surface = eglCreatePbufferSurface(display, config, size);
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, NULL);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, surface, surface, context);
}

/* Draws some frames; whether the middle of the last one is red. */
static int draw(void) {
  unsigned char middle[4] = {0};
  for (int frame = 0; frame < 5; ++frame) {
    glViewport(0, 0, kSize, kSize), glEnable(GL_DEPTH_TEST);
    glClearColor(0, 0, 1, 1), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 0), glVertex3f(-0.9f, -0.9f, 0), glVertex3f(0.9f, -0.9f, 0.1f), glVertex3f(0, 0.9f, 0.2f);
    glEnd();
    glReadPixels(kSize / 2, kSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, middle);
    eglSwapBuffers(display, surface);
  }
  return middle[0] > 200 && middle[2] < 50;
}

/* Opens a file and writes a line; returns its descriptor. */
static int openFile(const char* path) {
  const int file = open(path, O_RDWR | O_CREAT | O_TRUNC, 0600);
  return file >= 0 && write(file, "data\n", 5) == 5 ? file : -1;
}

/* Whether the descriptor still is a file that holds the line and nothing else. */
static int holdsTheLine(int file) {
  char text[16];
  struct stat status;
  return fstat(file, &status) == 0 && status.st_size == 5 && pread(file, text, 5, 0) == 5 &&
         !memcmp(text, "data\n", 5);
}

static int second(const char* path) {
  close(STDERR_FILENO);
  const int file = openFile(path);
  if (file < 0) return kWrongFile;
  if (!start()) return kNoContext;
  if (!draw()) return kWrongImage;
  return holdsTheLine(file) ? 0 : kWrongFile;
}

static int all(const char* folder) {
  int files[kFiles];
  if (!start()) return kNoContext;
  if (!draw()) return kWrongImage;
  for (int number = 3; number < 256; ++number) close(number);
  for (int i = 0; i < kFiles; ++i) {
    char path[4096];
    snprintf(path, sizeof path, "%s/%d", folder, i);
    files[i] = openFile(path);
  }
  if (!draw()) return kWrongImage;
  usleep(700 * 1000); /* longer than the timeline waits between two writes */
  if (!draw()) return kWrongImage;
  for (int i = 0; i < kFiles; ++i)
    if (!holdsTheLine(files[i])) return kWrongFile;
  return 0;
}

static int devices(void) {
  PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
  EGLDeviceEXT found[32];
  EGLint count = -1;
  if (query) query(32, found, &count);
  printf("%d devices\n", (int)count);
  return start() && draw() ? 0 : kWrongImage;
}

int main(int argc, char** argv) {
  if (argc == 3 && !strcmp(argv[1], "second")) return second(argv[2]);
  if (argc == 3 && !strcmp(argv[1], "all")) return all(argv[2]);
  if (argc == 2 && !strcmp(argv[1], "devices")) return devices();
  if (!start()) return kNoContext;
  return draw() ? 0 : kWrongImage;
}
