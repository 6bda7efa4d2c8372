// Kinds of rays; an instance may be hidden from each kind. Plain data.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::accel {

/// Primary rays, shadow rays to lights, ambient occlusion rays, and rays of bounced light.
enum class RayKind : uint8_t { camera, shadow, occlusion, reflection };

/// One for each instance of a snapshot and its secondary scene: bit k hides it from rays of kind k. Empty:
/// nothing is hidden.
using HiddenFrom = std::vector<uint8_t>;
constexpr uint8_t bitOf(RayKind kind) { return static_cast<uint8_t>(1u << static_cast<uint8_t>(kind)); }
inline bool isHidden(const HiddenFrom& hidden, size_t instance, RayKind kind) {
  return instance < hidden.size() && (hidden[instance] & bitOf(kind)) != 0;
}

}  // namespace gluray::accel
