#include "gl/failsafe.h"

#include "base/log.h"

#include <string>

namespace gluray::gl {

void Failsafe::stepAside(const char* why) noexcept {
  try {
    if (!aside_)
      log::write(log::Level::warning,
                 std::string("stepping aside, the program draws as without GLuRay from here on: ") + why);
    aside_ = true;
    drawHeld_();
  } catch (...) {  // nothing more can be done; the real OpenGL goes on without these vertices
  }
}

}  // namespace gluray::gl
