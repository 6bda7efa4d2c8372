// The exception that accel/ throws. Any thread.
#pragma once
#include <stdexcept>

namespace gluray::accel {

/// An acceleration structure could not be built; what() is one line for the user. The caller may retry later.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gluray::accel
