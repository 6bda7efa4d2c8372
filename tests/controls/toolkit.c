/* A program whose toolkit draws as Qt does: it draws its view into a texture in a context of its own, and
 * shows that in the window with a second context. When the window is exposed it shows the texture again; it
 * draws the view anew when the window's size changes, and for each line that it reads from standard input.
 * Prints the number of views that it has drawn for each line, and the window's width as it knows it.
 */
#define GL_GLEXT_PROTOTYPES
#include "tests/doors/programs/two_rings.h"
#include "tests/doors/programs/x_window.h"

#include <GL/glx.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { kWidth = 320, kHeight = 240, kLeft = 40, kBelow = 30 };

static int width = kWidth, height = kHeight, views;
static GLuint texture, framebuffer, program;
static GLXContext ofView, ofWindow;

static int viewWidth(void) { return width - 2 * kLeft; }
static int viewHeight(void) { return height - 2 * kBelow; }

/* Draws the view into the texture, which is made anew for its size. */
static void drawView(Display* display, Window window) {
  GLuint depth = 0;
  glXMakeCurrent(display, window, ofView);
  if (texture) glDeleteTextures(1, &texture), glDeleteFramebuffers(1, &framebuffer);
  glGenTextures(1, &texture), glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, viewWidth(), viewHeight(), 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenRenderbuffers(1, &depth), glBindRenderbuffer(GL_RENDERBUFFER, depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, viewWidth(), viewHeight());
  glGenFramebuffers(1, &framebuffer), glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  drawTwoRings(viewWidth(), viewHeight(), 20);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteRenderbuffers(1, &depth);
  glFlush();
  ++views;
}

static GLuint shaderOf(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, NULL), glCompileShader(shader);
  return shader;
}

static void makeProgram(void) {
  program = glCreateProgram();
  glAttachShader(
      program,
      shaderOf(GL_VERTEX_SHADER,
               "attribute vec3 corner; attribute vec2 coordinate; uniform mat4 place; varying vec2 at;"
               "void main() { at = coordinate; gl_Position = place * vec4(corner, 1.0); }"));
  glAttachShader(program, shaderOf(GL_FRAGMENT_SHADER,
                                   "uniform sampler2D image; varying vec2 at;"
                                   "void main() { gl_FragColor = texture2D(image, at); }"));
  glBindAttribLocation(program, 0, "corner"), glBindAttribLocation(program, 1, "coordinate");
  glLinkProgram(program);
}

/* Shows the texture in the window. */
static void show(Display* display, Window window) {
  static const float corners[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0},
                     coordinates[] = {0, 0, 1, 0, 0, 1, 1, 1};
  const float x = (float)viewWidth() / (float)width, y = (float)viewHeight() / (float)height;
  const float place[] = {x, 0, 0, 0, 0, y, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  glXMakeCurrent(display, window, ofWindow);
  if (!program) makeProgram();
  glViewport(0, 0, width, height);
  glClearColor(0.5f, 0.5f, 0.5f, 1), glClear(GL_COLOR_BUFFER_BIT);
  glUseProgram(program), glUniformMatrix4fv(glGetUniformLocation(program, "place"), 1, GL_FALSE, place);
  glBindTexture(GL_TEXTURE_2D, texture);
  glEnableVertexAttribArray(0), glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, corners);
  glEnableVertexAttribArray(1), glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 0, coordinates);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glUseProgram(0);
  glXSwapBuffers(display, window);
}

static void takeEvents(Display* display, Window window) {
  int exposed = 0, resized = 0;
  for (XEvent event; XPending(display) > 0;) {
    XNextEvent(display, &event);
    exposed |= event.type == Expose;
    if (event.type == ConfigureNotify && event.xconfigure.width != width)
      width = event.xconfigure.width, resized = 1;
  }
  if (resized) drawView(display, window);
  if (exposed || resized) show(display, window);
}

int main(void) {
  static int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 24, None};
  char line[64];
  Display* display = openDisplay();
  XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!visual) return fprintf(stderr, "no visual\n"), 1;
  const Window window = makeWindow(display, visual);
  XResizeWindow(display, window, kWidth, kHeight);
  XSync(display, False);
  XSelectInput(display, window, ExposureMask | StructureNotifyMask);
  ofWindow = glXCreateContext(display, visual, NULL, True);
  ofView = glXCreateContext(display, visual, ofWindow, True);
  setvbuf(stdin, NULL, _IONBF, 0); /* poll() sees what is not read yet */
  struct pollfd inputs[] = {{STDIN_FILENO, POLLIN, 0}, {ConnectionNumber(display), POLLIN, 0}};
  drawView(display, window), show(display, window);
  for (;;) {
    takeEvents(display, window);
    poll(inputs, 2, -1);
    if (!inputs[0].revents) continue;
    if (!fgets(line, sizeof line, stdin)) return 0;
    if (strcmp(line, "count\n") != 0) drawView(display, window), show(display, window);
    printf("%d %d\n", views, width), fflush(stdout);
  }
}
