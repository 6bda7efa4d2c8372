#include "bench/client/window.h"

#include <GL/gl.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <stdexcept>

namespace gluray::bench {

struct Window::Handles {
  Display* display = nullptr;
  ::Window window = 0;
  GLXContext context = nullptr;
  ~Handles() {
    if (!display) return;
    glXMakeCurrent(display, None, nullptr);
    if (context) glXDestroyContext(display, context);
    if (window) XDestroyWindow(display, window);
    XCloseDisplay(display);
  }
};

Window::Window(int size) : handles_(std::make_unique<Handles>()) {
  Handles& h = *handles_;
  h.display = XOpenDisplay(nullptr);
  if (!h.display) throw std::runtime_error("no X display: set DISPLAY or run under xvfb-run");
  int attributes[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8,   GLX_GREEN_SIZE, 8, GLX_BLUE_SIZE,
                      8,        GLX_DEPTH_SIZE,   24,           None};
  XVisualInfo* visual = glXChooseVisual(h.display, DefaultScreen(h.display), attributes);
  if (!visual) throw std::runtime_error("the display has no double-buffered visual with 24 bits of depth");
  const ::Window root = RootWindow(h.display, visual->screen);
  XSetWindowAttributes set{};
  set.colormap = XCreateColormap(h.display, root, visual->visual, AllocNone);
  set.event_mask = StructureNotifyMask;
  h.window = XCreateWindow(h.display, root, 0, 0, unsigned(size), unsigned(size), 0, visual->depth,
                           InputOutput, visual->visual, CWColormap | CWEventMask | CWBorderPixel, &set);
  XStoreName(h.display, h.window, "gluray-bench-client");
  XMapWindow(h.display, h.window);
  for (XEvent event; XNextEvent(h.display, &event), event.type != MapNotify;) {}
  h.context = glXCreateContext(h.display, visual, nullptr, True);
  XFree(visual);
  if (!h.context || !glXMakeCurrent(h.display, h.window, h.context))
    throw std::runtime_error("no OpenGL context could be made");
}

Window::~Window() = default;

void Window::swap() { glXSwapBuffers(handles_->display, handles_->window); }

void Window::swapAndFinish() {
  swap();
  glFinish();
}

}  // namespace gluray::bench
