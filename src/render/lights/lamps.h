// Draws visible lights (`visible` in files of lights). Made once a frame, called on all tracing threads.
#pragma once
#include "render/camera/depth_map.h"
#include "render/camera/eye_ray.h"
#include "render/lights/light_shape.h"
#include "render/local/group.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct Relit;

/// Lights have the colour times the strength of the light, opaque, without lighting, fog or blending. They
/// are visible also in front of the near plane and beyond the far plane. Distant lights lie behind
/// everything.
class Lamps {
 public:
  /// `eyeRays`: of the snapshot's camera. All but the lights must outlive this.
  Lamps(const scene::Snapshot&, const Relit&, const RaySetup& eyeRays, const DepthMap&);
  /// Returns the lanes that see a light in front of `depth`; sets their colours and depths. `x`, `y`: window
  /// positions. `rays`: in world space, of an open lens; null: rays through the window positions.
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

/// Null if no light is visible, or if the batch has layers or no lit surface, as in images for picking.
/// Arguments as for the constructor.
std::unique_ptr<const Lamps> makeLamps(const scene::Snapshot&, const Relit&, const RaySetup& eyeRays,
                                       const DepthMap&);

}  // namespace gluray::render
