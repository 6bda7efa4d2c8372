// What surrounds a batch: the other surfaces of its view, which the batch does not draw but which block and
// reflect its light. Made by gl/views/view_scenes, shared, immutable.
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
  /// In the eye space and the world of the snapshot that they surround; Instance::shading is an index into
  /// `shadings` above. Where instances are numbered, they come after those of the snapshot.
  std::vector<Instance> instances;
  std::vector<uint8_t> blended;  // one an instance; not 0: the program blends it, so that its alpha counts
  glm::dmat4 viewFromWorld{1};   // to the world of the view's first batch, from that of the snapshot
  /// One an instance, or fewer where the rest is not pictured: surfaces whose colours are those of a picture.
  std::vector<Pictured> pictured;
  std::vector<std::shared_ptr<const FramebufferPicture>> pictures;
  /// Of catchers (Snapshot::catches): the depths that the framebuffer has where they are traced, without
  /// colours. Null: not known.
  std::shared_ptr<const FramebufferPicture> framebuffer;
  bool operator==(const Surroundings&) const = default;
};

/// Whether two surroundings picture their surfaces alike, in framebuffers of the same depths.
inline bool isSamePictured(const Surroundings& a, const Surroundings& b) {
  if (!a.framebuffer != !b.framebuffer) return false;
  if (a.framebuffer && a.framebuffer != b.framebuffer && a.framebuffer->depths != b.framebuffer->depths)
    return false;
  const auto alike = [](const auto& one, const auto& other) { return one->content == other->content; };
  return a.pictured == b.pictured &&
         std::equal(a.pictures.begin(), a.pictures.end(), b.pictures.begin(), b.pictures.end(), alike);
}

/// Whether the settings ask for light that other surfaces block or reflect, or for a ground below them all.
/// Snapshots have surroundings only then.
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
/// Its shading.
inline const Shading& shadingOf(const Snapshot& s, size_t i) {
  const std::vector<Shading>& all = i < s.instances.size() ? s.shadings : s.surroundings->shadings;
  return all[instanceOf(s, i).shading];
}
/// Whether the program blends it.
inline bool isBlended(const Snapshot& s, size_t i) {
  const size_t drawn = s.instances.size();
  return i < drawn ? s.layers != nullptr : s.surroundings->blended[i - drawn] != 0;
}

}  // namespace gluray::scene
