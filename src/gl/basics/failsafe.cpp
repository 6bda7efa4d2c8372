#include "gl/basics/failsafe.h"

#include "base/log.h"

#include <string>

namespace gluray::gl {

void Failsafe::fail(scene::Loss loss, const char* why) noexcept {
  if (loss == scene::Loss::draws) return;
  try {
    if (loss == scene::Loss::frames) {
      if (!gone_ && pause_ == 0) pause_ = pauses_.take(), since_ = 0;
      if (!gone_ && !std::exchange(told_, true))
        log::write(log::Level::warning,
                   std::string("out of memory or threads, so the real OpenGL draws some frames: ") + why);
    } else if (!std::exchange(gone_, true)) {
      log::write(log::Level::warning,
                 std::string("GLuRay is disabled, and the real OpenGL draws everything from now on: ") + why);
    }
    drawHeld_();
  } catch (...) {  // nothing more can be done; the real OpenGL continues without these vertices
  }
}

void Failsafe::depthCleared() noexcept {
  if (pause_ > 0) {
    --pause_;
  } else if (pauses_.next > 1 && ++since_ >= pauses_.next) {  // no failure for that long
    pauses_.restart();
  }
}

}  // namespace gluray::gl
