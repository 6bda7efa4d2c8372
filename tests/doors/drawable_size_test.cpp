// Sizes of windows, pixmaps and pbuffers as the X server reports them, and of destroyed ones.
// X11's macros take names away from whom they precede.
// clang-format off
#include <gtest/gtest.h>
#include "intercept/window_systems/drawable_size.h"
#include <X11/Xlib.h>
#include <X11/Xutil.h>
// clang-format on

namespace gluray::intercept {
namespace {

int g_errors = 0;

int countError(Display*, XErrorEvent*) { return ++g_errors; }

class DrawableSize : public testing::Test {
 protected:
  DrawableSize() {
    g_errors = 0;
    XSetErrorHandler(countError);
    const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_WINDOW_BIT | GLX_PBUFFER_BIT, GLX_X_RENDERABLE, True, None};
    int count = 0;
    GLXFBConfig* configs = glXChooseFBConfig(display_, DefaultScreen(display_), wanted, &count);
    EXPECT_GT(count, 0);
    config_ = configs[0];
    XFree(configs);
  }
  ~DrawableSize() override {
    XSync(display_, False);
    EXPECT_EQ(g_errors, 0) << "the program's error handler heard of it";
    XCloseDisplay(display_);
  }
  Window makeWindow(unsigned width, unsigned height) {
    XVisualInfo* visual = glXGetVisualFromFBConfig(display_, config_);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display_, DefaultRootWindow(display_), visual->visual, AllocNone);
    const Window window =
        XCreateWindow(display_, DefaultRootWindow(display_), 0, 0, width, height, 3, visual->depth,
                      InputOutput, visual->visual, CWBorderPixel | CWColormap, &attributes);
    XFree(visual);
    return window;
  }
  Display* display_ = XOpenDisplay(nullptr);
  GLXFBConfig config_ = nullptr;
};

TEST_F(DrawableSize, WindowsAndPixmaps) {
  const Window window = makeWindow(200, 150);
  EXPECT_EQ(drawableSize(display_, window), glm::ivec2(200, 150));
  XResizeWindow(display_, window, 300, 100);  // the test does not flush it
  EXPECT_EQ(drawableSize(display_, window), glm::ivec2(300, 100));
  EXPECT_EQ(drawableSize(display_, XCreatePixmap(display_, window, 7, 9, 24)), glm::ivec2(7, 9));
}

TEST_F(DrawableSize, WhatOnlyGlxKnows) {
  const Window window = makeWindow(200, 150);
  const GLXWindow drawable = glXCreateWindow(display_, config_, window, nullptr);
  EXPECT_EQ(drawableSize(display_, drawable), glm::ivec2(200, 150));
  XResizeWindow(display_, window, 220, 160);
  EXPECT_EQ(drawableSize(display_, drawable), glm::ivec2(220, 160));
  const int size[] = {GLX_PBUFFER_WIDTH, 120, GLX_PBUFFER_HEIGHT, 90, None};
  EXPECT_EQ(drawableSize(display_, glXCreatePbuffer(display_, config_, size)), glm::ivec2(120, 90));
}

TEST_F(DrawableSize, DestroyedDrawablesHaveNone) {
  const Window window = makeWindow(200, 150);
  XDestroyWindow(display_, window);
  EXPECT_EQ(drawableSize(display_, window), glm::ivec2(0));
  EXPECT_EQ(drawableSize(display_, 0), glm::ivec2(0));
  EXPECT_EQ(drawableSize(nullptr, window), glm::ivec2(0));
}

}  // namespace
}  // namespace gluray::intercept
