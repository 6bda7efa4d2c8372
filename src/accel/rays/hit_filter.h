// Filter callback for hits. render/ implements filters and passes them to World's queries; tracing threads.
#pragma once
#include <cstdint>

namespace gluray::accel {

/// Accepts or rejects hits. Called on tracing threads.
class HitFilter {
 public:
  virtual ~HitFilter() = default;
  /// Returns false if the ray ignores this hit and continues. Barycentric u, v as in RayPacket.
  virtual bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int lane) const noexcept = 0;
};

}  // namespace gluray::accel
