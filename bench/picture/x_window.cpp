#include "bench/picture/x_window.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <stdexcept>

namespace gluray::bench {
namespace {

/// Windows may be closed while we look at them: X errors are expected and mean "not there".
int ignoreError(Display*, XErrorEvent*) { return 0; }

bool isNamed(Display* display, ::Window window, const std::string& name) {
  XClassHint hint{};
  if (!XGetClassHint(display, window, &hint)) return false;
  const bool same = (hint.res_class && name == hint.res_class) || (hint.res_name && name == hint.res_name);
  XFree(hint.res_class);
  XFree(hint.res_name);
  return same;
}

bool isShown(Display* display, ::Window window) {
  XWindowAttributes attributes{};
  return XGetWindowAttributes(display, window, &attributes) && attributes.map_state == IsViewable;
}

::Window find(Display* display, ::Window from, const std::string& name) {
  if (isNamed(display, from, name) && isShown(display, from)) return from;
  ::Window root, parent, *children = nullptr, found = 0;
  unsigned count = 0;
  if (!XQueryTree(display, from, &root, &parent, &children, &count)) return 0;
  for (unsigned i = 0; i < count && !found; ++i) found = find(display, children[i], name);
  XFree(children);
  return found;
}

uint8_t channel(unsigned long pixel, unsigned long mask) {
  if (!mask) return 0;
  while (!(mask & 1)) mask >>= 1, pixel >>= 1;
  return uint8_t((pixel & mask) * 255 / mask);
}

}  // namespace

struct XWindow::Handles {
  std::string name;
  Display* display = nullptr;
  ::Window window() const { return find(display, DefaultRootWindow(display), name); }
  ~Handles() {
    if (display) XCloseDisplay(display);
  }
};

XWindow::XWindow(std::string name) : handles_(std::make_unique<Handles>()) {
  handles_->name = std::move(name);
  handles_->display = XOpenDisplay(nullptr);
  if (!handles_->display) throw std::runtime_error("no X display");
  XSetErrorHandler(ignoreError);
}

XWindow::~XWindow() = default;

std::optional<RgbImage> XWindow::grab() {
  Display* display = handles_->display;
  const ::Window window = handles_->window();
  XWindowAttributes attributes{};
  if (!window || !XGetWindowAttributes(display, window, &attributes)) return std::nullopt;
  XImage* image = XGetImage(display, window, 0, 0, unsigned(attributes.width), unsigned(attributes.height),
                            AllPlanes, ZPixmap);
  if (!image) return std::nullopt;
  RgbImage out{image->width, image->height, {}};
  out.rgb.reserve(size_t(image->width) * size_t(image->height) * 3);
  for (int y = 0; y < image->height; ++y)
    for (int x = 0; x < image->width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      for (const unsigned long mask : {image->red_mask, image->green_mask, image->blue_mask})
        out.rgb.push_back(channel(pixel, mask));
    }
  XDestroyImage(image);
  return out;
}

bool XWindow::close() {
  Display* display = handles_->display;
  const ::Window window = handles_->window();
  if (!window) return false;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = long(XInternAtom(display, "WM_DELETE_WINDOW", False));
  XSendEvent(display, window, False, NoEventMask, &event);
  XSync(display, False);
  return true;
}

}  // namespace gluray::bench
