// Reads environment variables. Any thread, while no other thread sets them.
#pragma once
#include <cstdlib>
#include <string>

namespace gluray {

/// The variable's value; also empty if it is not set.
inline std::string environmentVariable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

}  // namespace gluray
