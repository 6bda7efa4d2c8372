// Reads environment variables. Any thread, while no other one sets them.
#pragma once
#include <cstdlib>
#include <string>

namespace gluray {

/// The variable's value; empty where it is not set, too.
inline std::string environmentVariable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

}  // namespace gluray
