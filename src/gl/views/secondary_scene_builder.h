// Makes the secondary scene of a snapshot from other snapshots of its view. Called by ViewScenes, GL thread.
#pragma once
#include "base/hash.h"
#include "scene/secondary_scene.h"

#include <glm/glm.hpp>

#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gluray::gl {

/// A surface that is drawn several times, as by several passes, is in the secondary scene once;
/// what the snapshot draws itself is not in it.
class SecondarySceneBuilder {
 public:
  explicit SecondarySceneBuilder(const scene::Snapshot& of);
  /// Leaves out what equals a surface of `part`, of the same frame as later parts.
  void skip(const scene::Snapshot& part);
  /// Adds the surfaces of `part`, but for those that a clear has `erased` (empty: none). `eyeFromPart`: from
  /// its eye space to that of the snapshot. `moved`: how what it shows has moved in its eye space since.
  /// `capture`: of its surfaces, if they are captured.
  void add(const scene::Snapshot& part, const glm::dmat4& eyeFromPart,
           const std::shared_ptr<const scene::FramebufferCapture>& capture,
           const std::vector<uint8_t>& erased, const glm::dmat4& moved = glm::dmat4(1));
  /// Parts from here on were drawn in another frame than those before: equal places mean nothing.
  void nextFrame() { seen_.clear(), volumes_.clear(); }
  /// Null where nothing was added.
  std::shared_ptr<const scene::SecondaryScene> takeSecondaryScene(const glm::dmat4& viewFromWorld);

 private:
  bool isNew(const scene::Instance&);
  bool isNew(const scene::PlacedVolume&);

  const scene::Snapshot& of_;
  glm::dmat4 worldFromEye_;
  std::shared_ptr<scene::SecondaryScene> made_;
  std::unordered_multimap<Hash128, const scene::Instance*> seen_;  // by geometry and place
  std::vector<const scene::PlacedVolume*> volumes_;                // likewise seen
};

}  // namespace gluray::gl
