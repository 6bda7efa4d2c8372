/* A program that draws a frame for each line that it reads from standard input, and prints a checksum of the
 * picture that it reads back: client. */
#include "tests/doors/ring.h"
#include "tests/doors/x_window.h"

#include <GL/glx.h>
#include <stdint.h>
#include <stdlib.h>

enum { kWidth = 160, kHeight = 120 };

static uint64_t checksum(void) {
  static unsigned char pixels[kWidth * kHeight * 4];
  uint64_t hash = 14695981039346656037u; /* FNV-1a */
  glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  for (size_t i = 0; i < sizeof pixels; ++i) hash = (hash ^ pixels[i]) * 1099511628211u;
  return hash;
}

static void drawRings(void) {
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setRingView(kWidth, kHeight, 20);
  sendRing();
  glPushMatrix(), glScalef(0.5f, 1.2f, 0.5f);
  sendRing();
  glPopMatrix();
}

int main(void) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  Display* display = openDisplay();
  XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!visual) return fprintf(stderr, "no visual\n"), 1;
  const Window window = makeWindow(display, visual);
  XResizeWindow(display, window, kWidth, kHeight);
  XSync(display, False);
  glXMakeCurrent(display, window, glXCreateContext(display, visual, NULL, True));
  for (char line[64]; fgets(line, sizeof line, stdin);) {
    drawRings();
    printf("%016llx\n", (unsigned long long)checksum());
    fflush(stdout);
    glXSwapBuffers(display, window);
  }
  return 0;
}
