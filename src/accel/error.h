// What accel/ throws. Any thread.
#pragma once
#include <stdexcept>

namespace gluray::accel {

/// An acceleration structure could not be made; what() is one line for the user. The caller may try again
/// later.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gluray::accel
