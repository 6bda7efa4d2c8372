#include "cluster/peers/tile_record.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace gluray::cluster {

size_t TileRecord::add(uint32_t blocked) {
  calls_.push_back({static_cast<uint16_t>(blocked)});
  return calls_.size() - 1;
}

void TileRecord::ask(size_t number, int peer, const QueryPacket& packet) {
  Asked& asked = asked_[static_cast<size_t>(peer)];
  asked.queries.add(packet);
  asked.packets.emplace_back(static_cast<uint32_t>(number), static_cast<uint16_t>(packet.lanes));
}

bool TileRecord::asks() const {
  return std::ranges::any_of(asked_, [](const Asked& asked) { return !asked.packets.empty(); });
}

void TileRecord::answer(int peer, std::span<const std::byte> bytes) {
  AnswerReader in(bytes);
  for (const auto& [number, lanes] : std::exchange(asked_[static_cast<size_t>(peer)].packets, {})) {
    const AnswerPacket packet = in.nextPacket(lanes);
    Call& call = calls_[number];
    call.blocked = static_cast<uint16_t>(call.blocked | packet.blocked);
    call.partly = static_cast<uint16_t>(call.partly | packet.partly);
    for (uint32_t left = packet.partly; left; left &= left - 1) {
      const int lane = std::countr_zero(left);
      parts_.push_back({number, lane, packet.through[static_cast<size_t>(lane)]});
    }
  }
  if (!in.atEnd()) throw Malformed("answers are too long");
}

void TileRecord::replay() {
  replays_ = true, next_ = 0;
  // Peers answer in any order, and products must not depend on it.
  std::ranges::sort(parts_, {}, [](const Part& p) {
    return std::tuple(p.call, p.lane, p.through.x, p.through.y, p.through.z);
  });
}

bool TileRecord::recall(uint32_t& blocked) {
  if (!replays_ || next_ >= calls_.size() || calls_[next_].partly) return false;
  blocked = calls_[next_++].blocked;
  return true;
}

uint32_t TileRecord::combine(uint32_t blocked, render::Passing passing) {
  if (next_ >= calls_.size()) return blocked;
  const auto number = static_cast<uint32_t>(next_++);
  const Call& call = calls_[number];
  blocked |= call.blocked;
  if (!call.partly) return blocked;
  constexpr float kNothing = 0.5f / 255;  // less is not seen
  auto at = std::ranges::lower_bound(parts_, number, {}, &Part::call);
  for (; at != parts_.end() && at->call == number; ++at) {
    const Part& part = *at;
    glm::vec3 left = part.through;
    if (passing.colored) left = passing.colored[part.lane] *= part.through;
    if (passing.grey) left = glm::vec3(passing.grey[part.lane] *= part.through.x);
    if (std::max(left.x, std::max(left.y, left.z)) < kNothing) blocked |= 1u << part.lane;
  }
  return blocked;
}

}  // namespace gluray::cluster
