/* A window for door tests. */
#pragma once
#include "workload.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <stdlib.h>

static inline Display* openDisplay(void) {
  Display* display = XOpenDisplay(NULL);
  if (!display) {
    fprintf(stderr, "no display\n");
    exit(1);
  }
  return display;
}

static inline Window makeWindow(Display* display, const XVisualInfo* visual) {
  XSetWindowAttributes attributes;
  attributes.border_pixel = 0;
  attributes.override_redirect = True;
  attributes.colormap = XCreateColormap(display, DefaultRootWindow(display), visual->visual, AllocNone);
  const Window window = XCreateWindow(display, DefaultRootWindow(display), 0, 0, kWindowSize, kWindowSize, 0,
                                      visual->depth, InputOutput, visual->visual,
                                      CWBorderPixel | CWColormap | CWOverrideRedirect, &attributes);
  XMapWindow(display, window);
  XSync(display, False);
  return window;
}
