#include "gl/basics/failsafe.h"

#include "base/log.h"

#include <algorithm>
#include <string>

namespace gluray::gl {
namespace {

constexpr int kMaxPause = 1024;  // clears of depth

}  // namespace

void Failsafe::fail(scene::Loss loss, const char* why) noexcept {
  if (loss == scene::Loss::draws) return;
  try {
    if (loss == scene::Loss::frames) {
      if (!gone_ && pause_ == 0)
        pause_ = nextPause_, since_ = 0, nextPause_ = std::min(2 * nextPause_, kMaxPause);
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
  } else if (nextPause_ > 1 && ++since_ >= nextPause_) {  // no failure for that long
    nextPause_ = 1;
  }
}

}  // namespace gluray::gl
