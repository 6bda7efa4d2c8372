// Functions of the window system APIs that we stand in for, by name. Doors ask through the engine's entry
// point.
#pragma once
#include "intercept/window_systems/real_functions.h"

namespace gluray::intercept {

/// Our function for a glX*, egl* or OSMesa* name as seen through `door`; null: the real one will do.
void* glxHook(Door door, const char* name);
void* eglHook(Door door, const char* name);
void* osmesaHook(const char* name);

}  // namespace gluray::intercept
