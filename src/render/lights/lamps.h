// Lights that can be seen (`visible` in files of lights): what the viewer sees of them. Made once a frame,
// asked on all tracing threads.
#pragma once
#include "render/camera/depth_map.h"
#include "render/camera/eye_ray.h"
#include "render/lights/light_shape.h"
#include "render/local/group.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct Relit;

/// They show their colour times their strength, without light, fog or blending, in opaque pixels. They are
/// seen also before the near plane and beyond the far one; distant ones behind everything.
class Lamps {
 public:
  /// `eyeRays`: of the snapshot's camera. All but the lights must outlive this.
  Lamps(const scene::Snapshot&, const Relit&, const RaySetup& eyeRays, const DepthMap&);
  /// Which lanes see a light in front of `depth`; fills their colours, and replaces their depths. `x`, `y`:
  /// window positions. `rays`: in world space, of an open lens; null: rays go through the window positions.
  uint32_t show(const float* x, const float* y, const accel::RayPacket* rays, Row& depth,
                ColorRows& rows) const noexcept;

 private:
  EyeRay rayOf(const accel::RayPacket&, int i) const;
  float depthAt(const glm::dvec3& point) const;

  const scene::Snapshot& snapshot_;
  const RaySetup& eyeRays_;
  const DepthMap& depth_;
  std::vector<LightShape> shapes_;
  float factor_;  // of their colours
};

/// Null where none can be seen: the batch shows layers, or nothing that is lit, such as a picture to pick
/// from. Otherwise as the constructor.
std::unique_ptr<const Lamps> makeLamps(const scene::Snapshot&, const Relit&, const RaySetup& eyeRays,
                                       const DepthMap&);

}  // namespace gluray::render
