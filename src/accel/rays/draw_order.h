// The order in which a snapshot's instances were drawn. World fills it between frames; its queries read it on
// tracing threads.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray::accel {

/// Decides which of several coincident surfaces is visible.
struct DrawOrder {
  std::vector<uint32_t> ranks;  // drawing order, one per Snapshot::instances
  // Mesh::triangleNumbers, one per Snapshot::instances. Empty if no mesh is a page.
  std::vector<const uint32_t*> numbers;
  bool laterWins = false;
  uint64_t rankOf(uint32_t instance, uint32_t primitive) const {
    const uint32_t* const of = numbers.empty() ? nullptr : numbers[instance];
    return uint64_t{ranks[instance]} << 32 | (of ? of[primitive] : primitive);
  }
};

}  // namespace gluray::accel
