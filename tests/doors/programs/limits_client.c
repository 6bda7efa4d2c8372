/* Draws a few frames of a shaded scene where something is short, and writes the last one as a PPM image to
   standard output, VmHWM in kB to standard error. Arguments: glx or egl (surfaceless, without a display);
   small, grows, lowers, large or sizes; the stack of the drawing thread in kB, 0: the main thread draws.
   small, large: a lit ball of few or many triangles over a floor.
   grows: small; after the first frame, the program takes all but 200 MB of its limit of address space.
   lowers: small, and more frames; after the first, the program sets a limit that leaves 200 MB.
   sizes: the small scene, ten times into each of three framebuffers of very different shapes; the image is
   the middle of the last one. */
#define GL_GLEXT_PROTOTYPES
#include "egl_config.h"
#include "x_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <math.h>
#include <pthread.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

enum { kSide = 128, kDrawn = 3, kManyDrawn = 50, kTimes = 10 };

static const char *api, *scene;
static float* ball; /* position and normal of each vertex */
static int ballVertices;
static int failed;

static int makeBall(int slices) {
  const int stacks = slices / 2;
  ball = malloc(sizeof(float) * 6 * 6 * (size_t)slices * (size_t)stacks);
  if (!ball) return 0;
  float* to = ball;
  for (int i = 0; i < slices; ++i)
    for (int j = 0; j < stacks; ++j)
      for (int corner = 0; corner < 6; ++corner) {
        static const int across[] = {0, 1, 1, 0, 1, 0}, up[] = {0, 0, 1, 0, 1, 1};
        const double a = 2 * M_PI * (i + across[corner]) / slices, b = M_PI * (j + up[corner]) / stacks;
        const float at[] = {(float)(cos(a) * sin(b)), (float)(sin(a) * sin(b)), (float)cos(b)};
        for (int k = 0; k < 3; ++k) to[k] = 0.6f * at[k] + (k == 1 ? 0.2f : 0), to[3 + k] = at[k];
        to += 6;
      }
  ballVertices = 6 * slices * stacks;
  return 1;
}

static void drawScene(int width, int height, int step) {
  static const GLfloat light[] = {0.4f, 1, 0.6f, 0}, white[] = {0.9f, 0.8f, 0.7f, 1};
  glViewport(0, 0, width, height);
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(-1, 1, -1, 1, -3, 3);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glRotatef(20.0f + (float)step, 1, 0, 0);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, white);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glVertexPointer(3, GL_FLOAT, 6 * sizeof(float), ball);
  glNormalPointer(GL_FLOAT, 6 * sizeof(float), ball + 3);
  glDrawArrays(GL_TRIANGLES, 0, ballVertices);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
  glBegin(GL_QUADS);
  glNormal3f(0, 1, 0);
  for (int i = 0; i < 4; ++i) glVertex3f(i == 0 || i == 3 ? -0.9f : 0.9f, -0.5f, i < 2 ? 0.9f : -0.9f);
  glEnd();
}

static void writeImage(int x, int y) {
  static unsigned char pixels[kSide * kSide * 3];
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(x, y, kSide, kSide, GL_RGB, GL_UNSIGNED_BYTE, pixels);
  if (glGetError() != GL_NO_ERROR) failed = 1;
  printf("P6\n%d %d\n255\n", kSide, kSide);
  fwrite(pixels, 1, sizeof pixels, stdout);
  fflush(stdout);
}

static void takeAddressSpace(void) {
  const size_t kept = (size_t)200 << 20, piece = (size_t)16 << 20;
  void* room = mmap(NULL, kept, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) failed = 1;
  while (mmap(NULL, piece, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED)
    continue;
  munmap(room, kept);
}

static void lowerLimit(void) {
  FILE* file = fopen("/proc/self/statm", "r");
  unsigned long pages = 0;
  if (!file || fscanf(file, "%lu", &pages) != 1) failed = 1;
  if (file) fclose(file);
  struct rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * (rlim_t)sysconf(_SC_PAGESIZE) + ((rlim_t)200 << 20);
  if (setrlimit(RLIMIT_AS, &limit) != 0) failed = 1;
}

static void drawFrames(void (*show)(void)) {
  const int frames = strcmp(scene, "lowers") == 0 ? kManyDrawn : kDrawn;
  for (int i = 0; i < frames; ++i) {
    if (i == 1 && strcmp(scene, "grows") == 0) takeAddressSpace();
    if (i == 1 && strcmp(scene, "lowers") == 0) lowerLimit();
    drawScene(kSide, kSide, i);
    if (i + 1 < frames) show();
  }
  writeImage(0, 0);
  show();
}

static void drawSizes(void) {
  static const int sizes[][2] = {{16384, 16}, {16, 16384}, {8192, 1024}};
  for (int round = 0; round < 3; ++round) {
    const int width = sizes[round][0], height = sizes[round][1];
    GLuint framebuffer, planes[2];
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, planes);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (int i = 0; i < 2; ++i) {
      glBindRenderbuffer(GL_RENDERBUFFER, planes[i]);
      glRenderbufferStorage(GL_RENDERBUFFER, i ? GL_DEPTH_COMPONENT24 : GL_RGBA8, width, height);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                                GL_RENDERBUFFER, planes[i]);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) failed = 1;
    for (int i = 0; i < kTimes; ++i) {
      drawScene(width, height, i);
      if (i % 2 == 0) glFinish();
    }
    if (width >= kSide && height >= kSide) writeImage((width - kSide) / 2, (height - kSide) / 2);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, planes);
  }
}

static void draw(void (*show)(void)) {
  if (strcmp(scene, "sizes") == 0)
    drawSizes();
  else
    drawFrames(show);
}

static EGLDisplay eglDisplay;
static EGLSurface eglSurface;
static void showEgl(void) { eglSwapBuffers(eglDisplay, eglSurface); }

static int runEgl(void) {
  static const EGLint size[] = {EGL_WIDTH, kSide, EGL_HEIGHT, kSide, EGL_NONE};
  eglDisplay = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
  if (!eglInitialize(eglDisplay, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
  const EGLConfig config = chooseEglConfig(eglDisplay, 0);
  if (!config) return 0;
  eglSurface = eglCreatePbufferSurface(eglDisplay, config, size);
  const EGLContext context = eglCreateContext(eglDisplay, config, EGL_NO_CONTEXT, NULL);
  if (!context || !eglMakeCurrent(eglDisplay, eglSurface, eglSurface, context)) return 0;
  draw(showEgl);
  eglMakeCurrent(eglDisplay, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(eglDisplay, context);
  eglTerminate(eglDisplay);
  return 1;
}

static Display* xDisplay;
static Window xWindow;
static void showGlx(void) { glXSwapBuffers(xDisplay, xWindow); }

static int runGlx(void) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, None};
  xDisplay = openDisplay();
  XVisualInfo* visual = glXChooseVisual(xDisplay, DefaultScreen(xDisplay), wanted);
  if (!visual) return 0;
  xWindow = makeWindow(xDisplay, visual);
  XResizeWindow(xDisplay, xWindow, kSide, kSide);
  XSync(xDisplay, False);
  const GLXContext context = glXCreateContext(xDisplay, visual, NULL, True);
  if (!context || !glXMakeCurrent(xDisplay, xWindow, context)) return 0;
  draw(showGlx);
  glXMakeCurrent(xDisplay, None, NULL);
  glXDestroyContext(xDisplay, context);
  XDestroyWindow(xDisplay, xWindow);
  XFree(visual);
  XCloseDisplay(xDisplay);
  return 1;
}

static void* run(void* unused) {
  (void)unused;
  if (!(strcmp(api, "egl") == 0 ? runEgl() : runGlx())) failed = 1;
  return NULL;
}

static void sayPeak(void) {
  char line[128];
  FILE* status = fopen("/proc/self/status", "r");
  while (status && fgets(line, sizeof line, status))
    if (strncmp(line, "VmHWM", 5) == 0 || strncmp(line, "VmPeak", 6) == 0) fputs(line, stderr);
  if (status) fclose(status);
}

int main(int argc, char** argv) {
  if (argc != 4)
    return fprintf(stderr, "usage: limits_client glx|egl small|grows|lowers|large|sizes STACK_KB\n"), 2;
  api = argv[1], scene = argv[2];
  const size_t stack = (size_t)atoi(argv[3]) << 10;
  if (!makeBall(strcmp(scene, "large") == 0 ? 600 : 32)) return 1;
  if (stack == 0) {
    run(NULL);
  } else {
    pthread_attr_t attributes;
    pthread_t thread;
    pthread_attr_init(&attributes);
    if (pthread_attr_setstacksize(&attributes, stack) != 0 ||
        pthread_create(&thread, &attributes, run, NULL) != 0)
      return fprintf(stderr, "no thread\n"), 1;
    pthread_join(thread, NULL);
    pthread_attr_destroy(&attributes);
  }
  sayPeak();
  return failed;
}
