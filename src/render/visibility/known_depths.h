// Rays of the viewer that look for surfaces where the framebuffer already has them
// (scene::Surroundings::framebuffer, docs/adr/0075). Any thread.
#pragma once
#include "accel/ray_packet.h"
#include "render/frame_data.h"
#include "scene/surroundings.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gluray::render {

/// From window depths to stretches of rays. A ray reaches NDC depth z at t = k / (s (1 + k r)), where
/// k = z + 1 is the way from the near plane, s RaySetup::directionScale and r the growth of w along the ray.
class KnownDepths {
 public:
  /// Not usable where the depths are not known, where rays do not start at the near plane, or where the
  /// program's own polygon offset moves depths away from the surfaces.
  explicit KnownDepths(const FrameData& frame) : frame_(frame) {
    const auto& around = frame.snapshot->surroundings;
    const scene::FramebufferPicture* picture = around ? around->framebuffer.get() : nullptr;
    const RaySetup& rays = frame.rays;
    if (!picture || !rays.linear.usable || !rays.clipPlanes.empty() || frame.lens || frame.averages) return;
    if (!(picture->depthNear < picture->depthFar) || !(picture->offset == scene::PolygonOffset{})) return;
    picture_ = picture;
    perDepth_ = 2 / (double{picture->depthFar} - double{picture->depthNear});
    growth_ = rays.step.w / rays.start.w;
    const glm::dvec3 diagonal(frame.world->upper() - frame.world->lower());
    reach_ = kReach * glm::length(diagonal);
  }
  bool usable() const { return picture_ != nullptr; }

  /// Shortens the ray of a lane, whose pixel is (x, y) of the image. False: the framebuffer shows nothing
  /// there, at the depth of its clear.
  bool shorten(int x, int y, int lane, accel::RayPacket& packet) const {
    const scene::Region& r = picture_->region;
    if (x < 0 || y < 0 || x >= r.width || y >= r.height) return true;
    const float depth =
        picture_->depths[static_cast<size_t>(y) * static_cast<size_t>(r.width) + static_cast<size_t>(x)];
    if (depth >= std::max(picture_->depthNear, picture_->depthFar)) return false;
    const double k = (double{depth} - double{picture_->depthNear}) * perDepth_, w = 1 + k * growth_;
    if (!(w > 0)) return true;
    const double scale = frame_.rays.directionScale, t = k / (scale * w);
    const double reach = reach_ + kSteps * resolution() * perDepth_ / (scale * w * w) + kRounding * t;
    packet.tNear[lane] = std::max(packet.tNear[lane], static_cast<float>(t - reach));
    packet.tFar[lane] = std::min(packet.tFar[lane], static_cast<float>(t + reach));
    return packet.tNear[lane] <= packet.tFar[lane];
  }

 private:
  // Much more than depths are off.
  static constexpr double kReach = 0.01;  // of the diagonal of the scene's bounds
  static constexpr double kSteps = 64;    // of depth
  static constexpr double kRounding = 1e-5;
  double resolution() const { return std::max(double{frame_.snapshot->polygonOffset.resolution}, 0x1p-24); }

  const FrameData& frame_;
  const scene::FramebufferPicture* picture_ = nullptr;  // null: not usable
  double perDepth_ = 0;                                 // NDC
  double growth_ = 0, reach_ = 0;
};

}  // namespace gluray::render
