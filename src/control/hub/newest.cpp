#include "control/hub/newest.h"

#include <algorithm>
#include <vector>

namespace gluray::control {
namespace {

HubTime later(HubTime now, double seconds) {
  return now + std::chrono::duration_cast<HubTime::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

void Newest::offer(const Key& key, PeerLink::Line line, double every, HubTime now, bool slow,
                   const Send& send) {
  Slot& slot = slots_[key];
  slot.due = std::min(slot.due, later(now, every));  // `every` may be shorter than before
  slot.every = every;
  if (!slow && slot.due <= now) {
    slot.kept = nullptr;
    slot.due = later(now, every);
    return send(key.first, line);
  }
  if (!slot.kept) slot.order = ++last_;
  slot.kept = std::move(line);
}

void Newest::flush(HubTime now, const std::function<bool()>& slow, const Send& send) {
  std::vector<std::pair<uint64_t, Slot*>> ready;
  for (auto& [key, slot] : slots_)
    if (slot.kept && slot.due <= now) ready.emplace_back(key.first, &slot);
  std::sort(ready.begin(), ready.end(),
            [](const auto& a, const auto& b) { return a.second->order < b.second->order; });
  for (const auto& [program, slot] : ready) {
    if (slow()) return;
    send(program, std::exchange(slot->kept, nullptr));
    slot->due = later(now, slot->every);
  }
}

void Newest::forget(uint64_t program) {
  std::erase_if(slots_, [&](const auto& slot) { return slot.first.first == program; });
}

void Newest::forget(const Key& key) { slots_.erase(key); }

HubTime Newest::nextDue() const {
  HubTime next = HubTime::max();
  for (const auto& [key, slot] : slots_)
    if (slot.kept) next = std::min(next, slot.due);
  return next;
}

}  // namespace gluray::control
