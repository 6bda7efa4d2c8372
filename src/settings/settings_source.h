// The current settings. Contexts read them once per frame, at its start, so that a change at run time is one
// store. Any thread.
#pragma once
#include "settings/settings.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

namespace gluray {

class SettingsSource {
 public:
  explicit SettingsSource(const Settings& first = {}) : now_(std::make_shared<const Settings>(first)) {}

  std::shared_ptr<const Settings> current() const {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  void store(const Settings& settings) {
    auto next = std::make_shared<const Settings>(settings);
    const std::lock_guard lock(mutex_);
    now_.swap(next);
    version_.fetch_add(1, std::memory_order_release);
  }
  /// `look` is called when frames begin, before they take the settings: it may store others.
  void watch(void (*look)() noexcept) noexcept { look_.store(look, std::memory_order_release); }
  void look() const noexcept {
    if (auto* const watcher = look_.load(std::memory_order_acquire)) watcher();
  }
  /// Increases with every store; frames check it first, without a lock.
  uint64_t version() const noexcept { return version_.load(std::memory_order_acquire); }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Settings> now_;
  std::atomic<uint64_t> version_{1};
  std::atomic<void (*)() noexcept> look_{nullptr};
};

/// The process's source; holds the built-in settings until the session is read. Never destroyed.
SettingsSource& settingsSource();

}  // namespace gluray
