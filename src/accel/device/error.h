// The exception that accel/ throws. Any thread.
#pragma once
#include "scene/failure.h"

#include <string>

namespace gluray::accel {

/// An acceleration structure could not be built; what() is one line for the user. The caller may retry later.
struct Error : scene::Failure {
  explicit Error(const std::string& why, scene::Loss of = scene::Loss::tracing) : Failure(why, of) {}
};

}  // namespace gluray::accel
