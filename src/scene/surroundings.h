// The surroundings of a batch: other surfaces of its view, which block and reflect the batch's light. Made by
// gl/views/view_scenes, shared, immutable.
#pragma once
#include "scene/effects.h"
#include "scene/framebuffer_picture.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::scene {

struct Surroundings {
  std::vector<Shading> shadings;
  /// In the eye space and the world of the snapshot; Instance::shading is an index into `shadings` above.
  /// Numbers of instances follow those of the snapshot.
  std::vector<Instance> instances;
  std::vector<uint8_t> blended;  // one per instance; not 0: blended, so that its alpha counts
  glm::dmat4 viewFromWorld{1};   // from the snapshot's world to the world of the view's first batch
  /// Surfaces whose colours come from a picture: one per instance; missing entries are not pictured.
  std::vector<Pictured> pictured;
  std::vector<std::shared_ptr<const FramebufferPicture>> pictures;
  /// For Snapshot::catches: the framebuffer's depths, without colours. Null: unknown.
  std::shared_ptr<const FramebufferPicture> framebuffer;
  bool operator==(const Surroundings&) const = default;
};

/// Whether two surroundings have equal pictures of their surfaces, and equal framebuffer depths.
inline bool isSamePictured(const Surroundings& a, const Surroundings& b) {
  if (!a.framebuffer != !b.framebuffer) return false;
  if (a.framebuffer && a.framebuffer != b.framebuffer && a.framebuffer->depths != b.framebuffer->depths)
    return false;
  const auto alike = [](const auto& one, const auto& other) { return one->content == other->content; };
  return a.pictured == b.pictured &&
         std::equal(a.pictures.begin(), a.pictures.end(), b.pictures.begin(), b.pictures.end(), alike);
}

/// Whether snapshots need surroundings: for light effects between surfaces, or for a ground.
inline bool needsSurroundings(const Settings& settings) {
  return wantsLight(settings) || wantsGround(settings);
}

/// Number of the snapshot's instances and those of its surroundings.
inline size_t countAll(const Snapshot& s) {
  return s.instances.size() + (s.surroundings ? s.surroundings->instances.size() : 0);
}
/// Instance `i` of both.
inline const Instance& instanceOf(const Snapshot& s, size_t i) {
  const size_t drawn = s.instances.size();
  return i < drawn ? s.instances[i] : s.surroundings->instances[i - drawn];
}
/// Shading of instance `i`.
inline const Shading& shadingOf(const Snapshot& s, size_t i) {
  const std::vector<Shading>& all = i < s.instances.size() ? s.shadings : s.surroundings->shadings;
  return all[instanceOf(s, i).shading];
}
/// Whether instance `i` is blended.
inline bool isBlended(const Snapshot& s, size_t i) {
  const size_t drawn = s.instances.size();
  return i < drawn ? s.layers != nullptr : s.surroundings->blended[i - drawn] != 0;
}

}  // namespace gluray::scene
