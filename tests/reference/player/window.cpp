#include "tests/reference/player/window.h"

#include <GL/glx.h>

#include <cstdio>
#include <cstdlib>

namespace gluray::player {
namespace {

[[noreturn]] void giveUp(const char* why) {
  std::fprintf(stderr, "gluray-scene-player: %s\n", why);
  std::exit(1);
}

}  // namespace

Window::Window(int width, int height) {
  Display* display = XOpenDisplay(nullptr);
  if (!display) giveUp("no display");
  int wish[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, GLX_STENCIL_SIZE, 8, None};
  XVisualInfo* visual = glXChooseVisual(display, DefaultScreen(display), wish);
  if (!visual) giveUp("no visual with 24 bits of depth and a stencil");
  XSetWindowAttributes attributes{};
  attributes.override_redirect = True;
  const ::Window root = DefaultRootWindow(display);
  attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  window_ = XCreateWindow(display, root, 0, 0, static_cast<unsigned>(width), static_cast<unsigned>(height), 0,
                          visual->depth, InputOutput, visual->visual,
                          CWBorderPixel | CWColormap | CWOverrideRedirect, &attributes);
  XMapRaised(display, window_);
  XSync(display, False);
  display_ = display, visual_ = visual;
  freshContext();
  gl::loadRealGl(
      gl_,
      [](void*, const char* name) {
        return reinterpret_cast<void*>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
      },
      nullptr);
}

void Window::freshContext() {
  auto* display = static_cast<Display*>(display_);
  GLXContext next = glXCreateContext(display, static_cast<XVisualInfo*>(visual_), nullptr, True);
  if (!next || !glXMakeCurrent(display, window_, next)) giveUp("no OpenGL context");
  if (context_) glXDestroyContext(display, static_cast<GLXContext>(context_));
  context_ = next;
}

void Window::swap() { glXSwapBuffers(static_cast<Display*>(display_), window_); }

}  // namespace gluray::player
