// GLuRay's replacements for functions of the window system APIs, by name. Doors find them through the
// engine's entry point. Any thread.
#pragma once
#include "intercept/window_systems/real_functions.h"

namespace gluray::intercept {

/// GLuRay's function for a glX*, egl* or OSMesa* name, for calls through `door`; null: use the real one.
void* glxHook(Door door, const char* name);
void* eglHook(Door door, const char* name);
void* osmesaHook(const char* name);

}  // namespace gluray::intercept
