// The real OpenGL below us. Filled once per API and context family by intercept/ (or a test), read by
// everybody.
#pragma once
#include "gl/real_gl.gen.h"

namespace gluray::gl {

/// Looks a function up by name; null where the real OpenGL does not have it.
using Lookup = void* (*)(void* user, const char* name);

/// Fills `table`. A missing command takes its alias's function, and failing that a function that does nothing
/// and returns 0.
void loadRealGl(RealGl& table, Lookup lookup, void* user);

/// The function that stands for commands which the real OpenGL lacks.
void* missingCommand();

/// Whether the command behind this pointer exists, for instance isPresent(real.CreateProgram).
template <class Function>
bool isPresent(Function function) {
  return reinterpret_cast<void*>(function) != missingCommand();
}

}  // namespace gluray::gl
