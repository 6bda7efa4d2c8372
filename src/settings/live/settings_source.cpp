#include "settings/live/settings_source.h"

#include "base/clock.h"
#include "base/never_destroyed.h"

#include <algorithm>
#include <utility>

namespace gluray {

SettingsSource& settingsSource() {
  static NeverDestroyed<SettingsSource> source;
  return *source;
}

/// Makes `next` current. `next` receives the previous settings, to be destroyed outside the lock.
void SettingsSource::publish(Shared& next) noexcept {
  now_.swap(next);
  version_.fetch_add(1, std::memory_order_release);
}

void SettingsSource::publishLater() noexcept {
  publish(later_);
  countingTicket_ = laterTicket_, countsIn_ = version_;
  laterFrame_.store(kNever, std::memory_order_release);
}

void SettingsSource::store(const Settings& settings) {
  auto next = std::make_shared<const Settings>(settings);
  Shared dropped;
  const std::lock_guard lock(mutex_);
  publish(next);
  dropped = std::exchange(later_, nullptr);
  if (dropped) countingTicket_ = laterTicket_, countsIn_ = version_;
  laterFrame_.store(kNever, std::memory_order_release);
}

uint64_t SettingsSource::storeAt(uint64_t frame, const Settings& settings) {
  auto next = std::make_shared<const Settings>(settings);
  const std::lock_guard lock(mutex_);
  later_.swap(next);
  laterFrame_.store(frame, std::memory_order_release);
  return ++laterTicket_;
}

void SettingsSource::storeBoth(const Settings& now, const Settings& later) {
  auto next = std::make_shared<const Settings>(now), then = std::make_shared<const Settings>(later);
  const std::lock_guard lock(mutex_);
  const bool waits = laterFrame_.load(std::memory_order_relaxed) != kNever;
  if (waits) later_.swap(then);
  publish(waits ? next : then);
}

void SettingsSource::endFrame() noexcept {
  constexpr auto relaxed = std::memory_order_relaxed;
  if (const uint64_t frame = this->frame(); begun_.load(relaxed) < frame)
    noteBegun(frame, ended_.load(relaxed));
  ended_.store(nowSeconds(), relaxed);
  frame_.fetch_add(1, relaxed);
}

void SettingsSource::beginFrame() noexcept {
  if (const uint64_t frame = this->frame(); begun_.load(std::memory_order_relaxed) < frame)
    noteBegun(frame, nowSeconds());
}

void SettingsSource::noteBegun(uint64_t frame, double when) noexcept {
  before_.store(began_.load(std::memory_order_relaxed), std::memory_order_relaxed);
  began_.store(when, std::memory_order_relaxed);
  begun_.store(frame, std::memory_order_release);
}

SettingsSource::Begun SettingsSource::begun() const noexcept {
  constexpr auto relaxed = std::memory_order_relaxed;
  Begun now{begun_.load(std::memory_order_acquire), began_.load(relaxed), before_.load(relaxed), 0};
  now.active = std::max(now.began, ended_.load(relaxed));
  return now;
}

SettingsSource::Shared SettingsSource::takeNewer(uint64_t& version) noexcept {
  if (auto* const look = look_.load(std::memory_order_acquire)) look();
  const bool due = frame() >= laterFrame_.load(std::memory_order_acquire);
  if (!due && this->version() == version) return nullptr;
  Shared dropped;
  const std::lock_guard lock(mutex_);
  if (frame() >= laterFrame_.load(std::memory_order_relaxed)) publishLater(), later_.swap(dropped);
  version = version_;
  note(version);
  return now_;
}

void SettingsSource::note(uint64_t version) noexcept {
  if (taken_.back().version >= version) return;
  std::rotate(taken_.begin(), taken_.begin() + 1, taken_.end());
  taken_.back() = {version, frame()};
}

std::optional<uint64_t> SettingsSource::firstFrame(uint64_t version) const {
  const auto found = std::find_if(taken_.begin(), taken_.end(),
                                  [&](const Taken& taken) { return taken.version >= version; });
  if (found == taken_.end() || found->frame > begun_.load(std::memory_order_acquire)) return std::nullopt;
  return found->frame;
}

std::optional<uint64_t> SettingsSource::firstFrameWith(uint64_t version) const {
  const std::lock_guard lock(mutex_);
  return firstFrame(version);
}

std::optional<uint64_t> SettingsSource::firstFrameOfTicket(uint64_t ticket) const {
  const std::lock_guard lock(mutex_);
  return countingTicket_ >= ticket ? firstFrame(countsIn_) : std::nullopt;
}

bool SettingsSource::counts(uint64_t ticket) const {
  const std::lock_guard lock(mutex_);
  return countingTicket_ >= ticket;
}

}  // namespace gluray
