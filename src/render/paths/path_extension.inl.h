// The next surfaces that paths meet. Compiled once for each instruction set.
#if defined(GLURAY_RENDER_PATHS_PATH_EXTENSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PATHS_PATH_EXTENSION_INL_H_
#undef GLURAY_RENDER_PATHS_PATH_EXTENSION_INL_H_
#else
#define GLURAY_RENDER_PATHS_PATH_EXTENSION_INL_H_
#endif

#include "accel/rays/traceable.h"
#include "render/paths/path_wave.inl.h"
#include "scene/secondary_scene.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Those of the lanes' rays that go on behind their hits: where clip planes or the alpha test cut the surface
/// away, and by the share that translucent surfaces let through. `u`: random numbers, used up.
inline uint32_t Wave::passing(uint32_t lanes, Row& u, accel::RayPacket& packet) const {
  constexpr float kBehind = 1 + 0x1p-20f;
  uint32_t passed = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const PathVertex& v = vertices_.lane[i];
    const scene::Snapshot& snapshot = *path_.frame.snapshot;
    const auto& planes = scene::instanceOf(snapshot, v.instance).clipPlanes;
    const auto cuts = [&](const glm::dvec4& plane) { return glm::dot(plane, glm::dvec4(v.point, 1)) < 0; };
    const bool cut =
        std::any_of(planes.begin(), planes.end(), cuts) || !path_.occluders.keeps(v.instance, v.opacity);
    const float opacity = scene::isBlended(snapshot, v.instance) ? std::clamp(v.opacity, 0.0f, 1.0f) : 1;
    if (!cut && u[i] < opacity) continue;
    if (!cut) u[i] = std::min((u[i] - opacity) / (1 - opacity), 0x1.fffffep-1f);
    packet.tNear[i] = packet.tFar[i] * kBehind;
    passed |= 1u << i;
  }
  return passed;
}

HWY_ATTR inline void Wave::extend() {
  constexpr int kMaxLayers = 64;  // translucent or clipped surfaces on one ray
  accel::RayPacket packet;
  alignas(64) Row back[3];
  alignas(64) int32_t valid[kLanes];
  eachLane([&](int i) {
    aim(packet, i, way_[i], std::numeric_limits<float>::infinity());
    if (!accel::isTraceable(packet, i)) alive_ &= ~(1u << i);
  });
  for (int i = 0; i < kLanes; ++i) {
    packet.time[i] = 0, packet.mask[i] = ~0u, packet.id[i] = static_cast<uint32_t>(i), packet.flags[i] = 0;
    for (int c = 0; c < 3; ++c) back[c][i] = -way_[i][c];
    back_[i] = -way_[i];
  }
  uint32_t under = alive_;
  alignas(64) Row u, unused;
  if (!path_.occluders.areSolid()) draw(PathUse::lobe, unused, u);
  for (int layer = 0; under && layer < kMaxLayers; ++layer) {
    for (int i = 0; i < kLanes; ++i) {
      valid[i] = under >> i & 1 ? -1 : 0;
      packet.geometry[i] = packet.instance[i] = accel::kNoHit;
      if (valid[i]) packet.tFar[i] = std::numeric_limits<float>::infinity();
    }
    if (!alone_) path_.frame.world->intersectBounced(valid, packet);
    uint32_t hits = 0;
    for (uint32_t lanes = under; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      if (!path_.added.empty() && meetLights(i, packet.tNear[i], packet.tFar[i])) continue;
      if (packet.geometry[i] != accel::kNoHit)
        hits |= 1u << i;
      else
        escape(i);
    }
    alive_ &= ~(under & ~hits);
    absorb(hits, packet);
    if (hits) bouncedVertices(path_, packet, hits, back, hits_.x, hits_.y, cone_, vertices_);
    under = path_.occluders.areSolid() ? 0 : passing(hits, u, packet);
  }
  alive_ &= ~under;
  if (path_.filters) eachLane([&](int i) { cone_[i].width = cone_[i].widthAt(packet.tFar[i]); });
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
