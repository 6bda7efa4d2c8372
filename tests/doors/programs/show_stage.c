/* show_stage.h: what the cases of show_client draw with. */
#include "show_stage.h"

#include <X11/Xutil.h>
#include <stdio.h>

enum { kMax = 320 };
Display* display;
Window window;
XVisualInfo* visual;
GLXContext context;
int width = 200, height = 150;

static void writeImage(const unsigned char* rgb, int w, int h) {
  printf("P6\n%d %d\n255\n", w, h);
  fwrite(rgb, 3, (size_t)(w * h), stdout);
}

/* The window's content, as the user sees it. */
void window_shows(void) {
  static unsigned char rgb[kMax * kMax * 3];
  XSync(display, False);
  XImage* image = XGetImage(display, window, 0, 0, (unsigned)width, (unsigned)height, AllPlanes, ZPixmap);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      unsigned char* to = rgb + 3 * (y * width + x);
      to[0] = (unsigned char)(pixel >> 16), to[1] = (unsigned char)(pixel >> 8), to[2] = (unsigned char)pixel;
    }
  XDestroyImage(image);
  writeImage(rgb, width, height);
}

/* The buffers, as the program reads them: colours, and the higher bytes of depths. */
void buffer_holds(void) {
  static unsigned char rgb[kMax * kMax * 3];
  static unsigned depth[kMax * kMax];
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
  writeImage(rgb, width, height);
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
  for (int i = 0; i < width * height; ++i)
    for (int c = 0; c < 3; ++c) rgb[3 * i + c] = (unsigned char)(depth[i] >> (24 - 8 * c));
  writeImage(rgb, width, height);
}

void swap(void) { glXSwapBuffers(display, window); }

void clear(void) {
  glClearColor(0.2f, 0.35f, 0.5f, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/* Two intersecting triangles. */
void surface(float turn) {
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

void frame(float turn) { clear(), surface(turn), swap(); }

/* Lines in space: their pixels depend on the depth buffer. */
void lines(void) {
  glColor3f(1, 1, 1);
  glBegin(GL_LINES);
  for (int i = -5; i < 6; ++i) {
    glVertex3f(0.15f * (float)i, -0.9f, -0.6f), glVertex3f(-0.15f * (float)i, 0.9f, 0.6f);
    glVertex3f(-0.9f, 0.15f * (float)i, 0.6f), glVertex3f(0.9f, -0.15f * (float)i, -0.6f);
  }
  glEnd();
}

GLuint framebuffer_of(int samples) {
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
