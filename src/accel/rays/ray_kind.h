// Kinds of rays, from each of which an instance may be hidden. Plain data.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::accel {

/// What a ray asks: what the viewer sees, what blocks a light, what blocks the light from all around, what
/// light bounces off.
enum class RayKind : uint8_t { camera, shadow, occlusion, reflection };

/// One for each instance of a snapshot and its surroundings: bit k, it does not exist for rays of kind k.
/// Empty: all exist for all rays.
using HiddenFrom = std::vector<uint8_t>;
constexpr uint8_t bitOf(RayKind kind) { return static_cast<uint8_t>(1u << static_cast<uint8_t>(kind)); }
inline bool isHidden(const HiddenFrom& hidden, size_t instance, RayKind kind) {
  return instance < hidden.size() && (hidden[instance] & bitOf(kind)) != 0;
}

}  // namespace gluray::accel
