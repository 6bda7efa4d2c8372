#include "gl/window/frame_settings.h"

#include "gl/context.h"
#include "settings/settings_source.h"
#include "settings/values.h"

#include <tbb/info.h>

#include <utility>

namespace gluray::gl {

Engine engineOf(const ContextInfo& info, const Settings& settings) {
  const bool choice = !info.off && settings.renderer != Renderer::null && !settings.changesPicture();
  return choice || settings.engine == Engine::never ? settings.engine : Engine::always;
}

int threadsOf(const Settings& settings) {
  if (settings.threads > 0) return settings.threads;
  return settings.engine == Engine::automatic ? tbb::info::default_concurrency() : 1;
}

void Context::takeSettings() {
  if (!info_.source || compiling() || insideBegin()) return;
  const uint64_t version = info_.source->version();
  if (version == settingsVersion_) return;
  Settings next = *info_.source->current();
  keepBetweenFrames(next, settings_);
  settingsVersion_ = version;
  const Engine before = engineOf(info_, settings_), now = engineOf(info_, next);
  settings_ = std::move(next);
  if (before == now) return;
  flush();
  choice_ = EngineChoice(now, threadsOf(settings_), info_.clock);
  setDirect(!passthrough_ && choice_.way() == EngineChoice::Way::direct);
}

void Context::beforeClearTakeSettings() noexcept {
  if (std::exchange(begun_, true) || draws() != drawsBefore_) return;
  protect([&] { takeSettings(); });
}

}  // namespace gluray::gl
