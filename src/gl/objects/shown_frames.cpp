#include "gl/objects/shown_frames.h"

#include <cstddef>
#include <exception>
#include <new>
#include <utility>

namespace gluray::gl {

void ShownFrames::wantUntil(double when) noexcept {
  until_ = when;
  if (when > 0) return;
  std::vector<Entry> forgotten;  // freed without the lock
  const std::lock_guard lock(mutex_);
  forgotten.swap(entries_);
}

void ShownFrames::show(const void* context, ShownFramePtr frame) noexcept {
  forget(context);
  const std::lock_guard lock(mutex_);
  if (until_ <= 0) return;
  try {
    entries_.push_back({context, std::move(frame)});
  } catch (const std::exception&) {}  // it is asked for again
}

void ShownFrames::forget(const void* context) noexcept {
  ShownFramePtr old;  // freed without the lock
  const std::lock_guard lock(mutex_);
  for (auto it = entries_.begin(); it != entries_.end(); ++it)
    if (it->context == context) {
      old = std::move(it->frame);
      entries_.erase(it);
      return;
    }
}

ShownFramePtr ShownFrames::last() const {
  const std::lock_guard lock(mutex_);
  for (auto it = entries_.rbegin(); it != entries_.rend(); ++it)
    if (!it->frame->batches.empty()) return it->frame;
  return entries_.empty() ? nullptr : entries_.back().frame;
}

std::vector<glm::ivec4> ShownFrames::places() const {
  const std::lock_guard lock(mutex_);
  for (auto it = entries_.rbegin(); it != entries_.rend(); ++it)
    if (!it->frame->places.empty()) return it->frame->places;
  return {};
}

ShownFrames& shownFrames() {
  alignas(ShownFrames) static std::byte room[sizeof(ShownFrames)];
  static auto* frames = new (room) ShownFrames;  // allocates nothing: callers may not throw
  return *frames;
}

}  // namespace gluray::gl
