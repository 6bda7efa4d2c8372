// Functions of the engine's library, for commands that draw nothing themselves.
#pragma once

namespace gluray::launcher {

/// Loads the engine. Throws std::runtime_error with one line if it has no such function.
void* engineSymbol(const char* name);

template <class Function>
Function engineFunction(const char* name) {
  return reinterpret_cast<Function>(engineSymbol(name));
}

}  // namespace gluray::launcher
