// The secondary scene of a batch: other surfaces of its view, which block and reflect the batch's light. Made
// by gl/views/view_scenes, shared, immutable.
#pragma once
#include "scene/effects.h"
#include "scene/framebuffer_capture.h"
#include "scene/snapshot.h"
#include "scene/volumes/placed_volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

struct SecondaryScene {
  std::vector<Shading> shadings;
  /// In the eye space and the world of the snapshot; Instance::shading is an index into `shadings` above.
  /// Numbers of instances follow those of the snapshot.
  std::vector<Instance> instances;
  std::vector<uint8_t> blended;  // one per instance; not 0: blended, so that its alpha counts
  glm::dmat4 viewFromWorld{1};   // from the snapshot's world to the world of the view's first batch
  /// Surfaces whose colours come from an image: one per instance; missing entries are not captured.
  std::vector<CapturedSurface> captured;
  std::vector<std::shared_ptr<const FramebufferCapture>> captures;
  std::vector<PlacedVolume> volumes;  // they block light; the snapshot's surfaces are behind or in them
  /// For Snapshot::catches: the framebuffer's depths, without colours. Null: unknown.
  std::shared_ptr<const FramebufferCapture> framebuffer;
  bool operator==(const SecondaryScene&) const = default;
};

/// Whether two secondary scenes have equal images of their surfaces, and equal framebuffer depths.
inline bool haveSameCaptures(const SecondaryScene& a, const SecondaryScene& b) {
  if (!a.framebuffer != !b.framebuffer) return false;
  if (a.framebuffer && a.framebuffer != b.framebuffer && a.framebuffer->depths != b.framebuffer->depths)
    return false;
  const auto alike = [](const auto& one, const auto& other) { return one->content == other->content; };
  return a.captured == b.captured &&
         std::equal(a.captures.begin(), a.captures.end(), b.captures.begin(), b.captures.end(), alike);
}

/// Whether snapshots need a secondary scene: for light effects between surfaces, or for a ground.
inline bool needsSecondaryScene(const Settings& settings) {
  return wantsLight(settings) || wantsGround(settings);
}

/// Number of the snapshot's instances and those of its secondary scene.
inline size_t countAll(const Snapshot& s) {
  return s.instances.size() + (s.secondaryScene ? s.secondaryScene->instances.size() : 0);
}
/// Instance `i` of both.
inline const Instance& instanceOf(const Snapshot& s, size_t i) {
  const size_t drawn = s.instances.size();
  return i < drawn ? s.instances[i] : s.secondaryScene->instances[i - drawn];
}
/// Shading of instance `i`.
inline const Shading& shadingOf(const Snapshot& s, size_t i) {
  const std::vector<Shading>& all = i < s.instances.size() ? s.shadings : s.secondaryScene->shadings;
  return all[instanceOf(s, i).shading];
}
/// Whether instance `i` is blended.
inline bool isBlended(const Snapshot& s, size_t i) {
  const size_t drawn = s.instances.size();
  return i < drawn ? s.layers != nullptr : s.secondaryScene->blended[i - drawn] != 0;
}

}  // namespace gluray::scene
