/* Cases of show_client: frames whose clear is followed by anything but traced surfaces alone. */
#include "show_stage.h"

#include <stdio.h>
#include <stdlib.h>

static void clear_alone(void) { frame(10), clear(), swap(), window_shows(), frame(20), window_shows(); }
static void clear_read(void) { frame(20), clear(), buffer_holds(), surface(30), swap(), window_shows(); }
static void clear_and_lines(void) {
  frame(40), clear(), lines(), surface(50), swap(), window_shows();
  frame(60), window_shows(), buffer_holds();
}
static void clear_then_part(void) {
  frame(65), clear();
  glEnable(GL_SCISSOR_TEST), glScissor(40, 30, 90, 60), glClearColor(0.9f, 0.1f, 0.1f, 1);
  glClear(GL_COLOR_BUFFER_BIT), glDisable(GL_SCISSOR_TEST);
  surface(70), swap(), window_shows(), buffer_holds();
}
static void clear_stencil(void) {
  frame(80), glClearStencil(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glClearStencil(0), glEnable(GL_STENCIL_TEST), glStencilFunc(GL_EQUAL, 1, 255);
  lines(), glDisable(GL_STENCIL_TEST), surface(85), swap(), window_shows();
}
static void clear_refused(void) {
  frame(80), glClearColor(1, 0, 0, 1), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | 0x10);
  if (glGetError() != GL_INVALID_VALUE) fprintf(stderr, "no error\n"), exit(1);
  lines(), swap(), window_shows();
}
enum { kColorAndDepth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT };
static void clear_colors(void) { /* each in a colour of its own */
  frame(10);
  for (int i = 0; i < 4; ++i) {
    glClearColor(0.25f * (float)i, 0.8f, 1 - 0.25f * (float)i, 1), glClear(kColorAndDepth);
    surface(20.0f * (float)i), swap(), window_shows();
    if (i % 2) buffer_holds();
  }
  frame(30), window_shows(), buffer_holds();
}
static void stencilled_lines(void) {
  glEnable(GL_STENCIL_TEST), glStencilFunc(GL_EQUAL, 1, 255);
  lines(), glDisable(GL_STENCIL_TEST);
}
static void clear_stencil_kept(void) { /* clears of colour and depth do not clear the stencil */
  glClearStencil(0), glClear(kColorAndDepth | GL_STENCIL_BUFFER_BIT), lines(), swap(), frame(60);
  glClearStencil(1), glClear(kColorAndDepth | GL_STENCIL_BUFFER_BIT), glClearStencil(0), clear();
  stencilled_lines(), swap(), window_shows(), buffer_holds();
  glClear(GL_STENCIL_BUFFER_BIT), frame(70);
  glClearStencil(1), glClear(kColorAndDepth | GL_STENCIL_BUFFER_BIT), surface(75), swap();
  glClearStencil(0), clear(), stencilled_lines(), surface(78), swap(), window_shows();
  frame(80), glClearStencil(1), glClear(kColorAndDepth | GL_STENCIL_BUFFER_BIT), glClearStencil(0);
  surface(0), clear(), stencilled_lines(), swap(), window_shows();
}
static void clear_values(void) { /* a clear has the values and masks of its time */
  frame(80), clear();
  glClearColor(0.1f, 0.9f, 0.1f, 1), glClearDepth(0.3);
  glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE), glDepthMask(GL_FALSE);
  surface(85), lines();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), glDepthMask(GL_TRUE), glClearDepth(1);
  swap(), window_shows();
  frame(90), glClearDepth(0.5), clear(), glClearDepth(1), surface(95), swap(), window_shows(), buffer_holds();
}
static void clear_then_front(void) {
  frame(15), clear();
  glDrawBuffer(GL_FRONT), lines(), glFlush(), glDrawBuffer(GL_BACK);
  window_shows(), surface(25), swap(), window_shows();
}
static void clear_then_attributes(void) {
  glPushAttrib(GL_ALL_ATTRIB_BITS), glDrawBuffer(GL_FRONT);
  glPushAttrib(GL_ALL_ATTRIB_BITS), glDrawBuffer(GL_BACK);
  frame(35), clear(), glPopAttrib(), lines(), glFlush(), window_shows();
  glPopAttrib(), surface(45), swap(), window_shows();
}
static void clear_then_object(void) {
  const GLuint object = framebuffer_of(0);
  frame(55), clear();
  glBindFramebuffer(GL_FRAMEBUFFER, object), clear(), surface(5), lines(), buffer_holds();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0), buffer_holds();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0), surface(65), swap(), window_shows();
  glDeleteFramebuffers(1, &object);
}
static void clear_then_floats(void) { /* whose clear colours may be negative */
  GLuint texture = 0, object = 0;
  GLfloat color[4] = {0};
  glGenTextures(1, &texture), glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 8, 8, 0, GL_RGBA, GL_FLOAT, NULL);
  glBindTexture(GL_TEXTURE_2D, 0), glGenFramebuffers(1, &object);
  glBindFramebuffer(GL_FRAMEBUFFER, object);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0), frame(55), clear();
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, object), glClearColor(-2, 3, 0.5f, -1), buffer_holds(),
      glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, object), glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, color);
  if (color[0] != -2 || color[1] != 3 || color[2] != 0.5f || color[3] != -1)
    fprintf(stderr, "cleared to %g %g %g %g\n", color[0], color[1], color[2], color[3]), exit(1);
  glBindFramebuffer(GL_FRAMEBUFFER, 0), surface(65), swap(), window_shows();
  glDeleteFramebuffers(1, &object), glDeleteTextures(1, &texture);
}
static void resolved_over(void) {
  const GLuint object = framebuffer_of(4);
  for (int cleared = 0; cleared < 2; ++cleared) {
    frame(75);
    if (cleared) clear();
    glBindFramebuffer(GL_FRAMEBUFFER, object), clear(), surface(15);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 100, 80, 0, 0, 100, 80, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0), swap(), window_shows();
  }
  glDeleteFramebuffers(1, &object);
}
static void evaluated_over(void) {
  static const GLfloat corners[] = {-0.9f, -0.5f, -0.5f, 0.9f, -0.5f, 0.5f,
                                    -0.9f, 0.5f,  -0.3f, 0.9f, 0.5f,  0.3f};
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, corners);
  for (int cleared = 0; cleared < 2; ++cleared) {
    frame(100);
    if (cleared) clear();
    glEnable(GL_MAP2_VERTEX_3), glColor3f(1, 1, 0), glBegin(GL_QUADS);
    glEvalCoord2f(0, 0), glEvalCoord2f(1, 0), glEvalCoord2f(1, 1), glEvalCoord2f(0, 1);
    glEnd(), glDisable(GL_MAP2_VERTEX_3), swap(), window_shows();
  }
}
const struct ShowCase kClearCases[] = {
    CASE(clear_alone),       CASE(clear_read),       CASE(clear_and_lines),       CASE(clear_then_part),
    CASE(clear_stencil),     CASE(clear_refused),    CASE(clear_colors),          CASE(clear_stencil_kept),
    CASE(clear_values),      CASE(clear_then_front), CASE(clear_then_attributes), CASE(clear_then_object),
    CASE(clear_then_floats), CASE(resolved_over),    CASE(evaluated_over),        {NULL, NULL},
};
