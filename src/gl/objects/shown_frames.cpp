#include "gl/objects/shown_frames.h"

#include "base/never_destroyed.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>

namespace gluray::gl {

void ShownFrames::wantUntil(double when) noexcept {
  until_ = when;
  if (when > 0 || always_) return;
  std::vector<Entry> forgotten;  // freed without the lock
  const std::lock_guard lock(mutex_);
  forgotten.swap(entries_);
}

void ShownFrames::show(const void* context, ShownFramePtr frame) noexcept {
  const std::lock_guard lock(mutex_);
  if (until_ <= 0 && !always_) return;
  const auto of = [&](const Entry& entry) { return entry.context == context; };
  const auto known = std::find_if(entries_.begin(), entries_.end(), of);
  try {
    if (known == entries_.end())
      entries_.push_back({context, nullptr, nullptr});
    else
      std::rotate(known, known + 1, entries_.end());
  } catch (const std::exception&) { return; }  // out of memory: this frame is not stored
  entries_.back().frame.swap(frame);
  // A swap shows what other contexts have drawn.
  if (entries_.back().frame->frame == 0) return;
  for (Entry& entry : entries_)
    if (entry.frame->frame == 0) entry.whole = entry.frame;
}

void ShownFrames::whole(const void* context) noexcept {
  ShownFramePtr old;  // freed without the lock
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_)
    if (entry.context == context) old = std::exchange(entry.whole, entry.frame);
}

void ShownFrames::forget(const void* context) noexcept {
  ShownFramePtr old, whole;  // freed without the lock
  const std::lock_guard lock(mutex_);
  for (auto it = entries_.begin(); it != entries_.end(); ++it)
    if (it->context == context) {
      old = std::move(it->frame), whole = std::move(it->whole);
      entries_.erase(it);
      return;
    }
}

ShownFramePtr ShownFrames::last() const {
  const std::lock_guard lock(mutex_);
  const double now = nowSeconds();
  for (auto it = entries_.rbegin(); it != entries_.rend(); ++it)
    if (!it->frame->batches.empty()) return it->settled(now);
  return entries_.empty() ? nullptr : entries_.back().frame;
}

std::vector<ShownFramePtr> ShownFrames::all() const {
  const std::lock_guard lock(mutex_);
  const double now = nowSeconds();
  std::vector<ShownFramePtr> frames;
  for (const Entry& entry : entries_)
    if (!entry.frame->batches.empty()) frames.push_back(entry.settled(now));
  return frames;
}

std::vector<glm::ivec4> ShownFrames::places() const {
  const std::lock_guard lock(mutex_);
  for (auto it = entries_.rbegin(); it != entries_.rend(); ++it)
    if (!it->frame->places.empty()) return it->frame->places;
  return {};
}

ShownFrames& shownFrames() {
  static NeverDestroyed<ShownFrames> frames;
  return *frames;
}

}  // namespace gluray::gl
