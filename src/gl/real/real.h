// The table of the real OpenGL's functions. intercept/ or a test fills it once per API and context family;
// any thread reads it.
#pragma once
#include "gl/real_gl.gen.h"

namespace gluray::gl {

/// Looks a function up by name; null if the real OpenGL lacks it.
using Lookup = void* (*)(void* user, const char* name);

/// Fills `table`. A missing command gets its alias's function, or else a function that does nothing and
/// returns 0.
void loadRealGl(RealGl& table, Lookup lookup, void* user);

/// The function that stands in for commands that the real OpenGL lacks.
void* missingCommand();

/// Whether the command behind this pointer exists, for instance isPresent(real.CreateProgram).
template <class Function>
bool isPresent(Function function) {
  return reinterpret_cast<void*>(function) != missingCommand();
}

}  // namespace gluray::gl
