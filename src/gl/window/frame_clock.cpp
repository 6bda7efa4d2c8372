#include "gl/window/frame_clock.h"

#include <tbb/info.h>

namespace gluray::gl {
namespace {

/// Interception alone is priced with everything held back, and what the real OpenGL does not give is not to
/// come and go.
Engine engineOf(const ContextInfo& info) {
  const bool choice = !info.off && info.settings.renderer != Renderer::null && info.settings.spp == 1;
  return choice || info.settings.engine == Engine::never ? info.settings.engine : Engine::always;
}

int threadsOf(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  return settings.engine == Engine::automatic ? tbb::info::default_concurrency() : 1;
}

}  // namespace

FrameClock::FrameClock(const ContextInfo& info)
    : choice(engineOf(info), threadsOf(info.settings), info.clock),
      direct_(!info.off && choice.way() == EngineChoice::Way::direct) {}

}  // namespace gluray::gl
