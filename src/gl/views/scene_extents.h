// Remembers the surfaces of scenes while they are out of view. Programs do not draw what lies outside of the
// view volume; without this memory the bounds of a scene, and the default radius of ambient occlusion with
// them, would depend on the camera. Used by ViewScenes, GL thread.
#pragma once
#include "gl/views/view_epoch.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::gl {

class SceneExtents {
 public:
  /// The diagonal, in eye space, of the bounds of all that the snapshot and its secondary scene show, and of
  /// the remembered surfaces of the same scene that lie out of its view. 0: there are none of these.
  float extentOf(const scene::Snapshot&) const;
  /// The epoch is complete. What the camera would see of remembered surfaces and was not drawn is forgotten:
  /// it is hidden or gone. Throws std::bad_alloc.
  void remember(const ViewEpoch&);
  void clear() { scenes_.clear(); }

 private:
  struct Surface {
    Hash128 geometry;
    glm::dmat4 eyeFromObject{1};
    glm::dvec3 lower{0}, upper{0};  // bounds, object space
  };
  using Surfaces = std::vector<Surface>;
  /// Surfaces of one eye space.
  struct Scene {
    glm::dmat4 eyeFromWorld{1};
    Surfaces surfaces;
  };
  static void add(const scene::Instance&, const glm::dmat4& eyeFromPart, Surfaces&);
  static bool isOutside(const Surface&, const glm::dmat4& clipFromEye);
  static double diagonalOf(const Scene&);
  /// The index of the remembered scene that shares most surfaces with these, the newest of equals.
  std::optional<size_t> sceneOf(const Surfaces&) const;
  /// The remembered scene in the eye space of `now`, with only those surfaces that the program leaves out
  /// because they are out of view.
  static Scene outOfView(const Scene& known, const Surfaces& now, const glm::dmat4& clipFromEye);

  std::vector<Scene> scenes_;  // the last remembered one is the last one
};

}  // namespace gluray::gl
