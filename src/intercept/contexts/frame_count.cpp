#include "intercept/contexts/frame_count.h"

#include "intercept/session/session.h"

#include <dlfcn.h>

#include <atomic>

namespace gluray::intercept {
namespace {

std::atomic<uint64_t> g_frames{0};

}  // namespace

void countFrame() noexcept {
  using Tell = void (*)();
  static const auto tell =
      reinterpret_cast<Tell>(session().explainFrames ? dlsym(RTLD_DEFAULT, "glurayFrameEnded") : nullptr);
  ++g_frames;
  if (tell) tell();
}

uint64_t framesEnded() noexcept { return g_frames; }

}  // namespace gluray::intercept
