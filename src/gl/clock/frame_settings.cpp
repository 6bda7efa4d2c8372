#include "gl/clock/frame_settings.h"

#include "base/processes/usable_cores.h"
#include "settings/values.h"

#include <utility>

namespace gluray::gl {

Engine engineOf(const ContextInfo& info, const Settings& settings, bool asked) {
  const bool choice = !info.off && settings.renderer != Renderer::null && !settings.changesImage() && !asked;
  return choice || settings.engine == Engine::never ? settings.engine : Engine::always;
}

int threadsOf(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  return settings.engine == Engine::automatic ? chosenThreadsHere() : 1;
}

bool FrameSettings::takeCurrent() {
  if (!source_) return false;
  uint64_t version = version_;
  const SettingsSource::Shared newer = source_->takeNewer(version);
  if (!newer) return false;
  Settings next = *newer;  // may throw
  keepBetweenFrames(next, now_);
  version_ = version;
  now_ = std::move(next);
  return true;
}

}  // namespace gluray::gl
