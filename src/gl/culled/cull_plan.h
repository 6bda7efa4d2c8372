// What is known of a large draw before anything of it is drawn, and what is remembered of earlier draws of
// the same data. Parts of LargeDraws, GL thread.
#pragma once
#include "base/hash.h"
#include "gl/basics/reasons.h"
#include "gl/culled/clusters/culled_mesh.h"
#include "gl/culled/culled_program.h"
#include "gl/culled/feedback/position_feedback.h"
#include "gl/culled/instances/instances.h"
#include "gl/culled/trials/culling_trials.h"
#include "gl/real/elements.h"
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gluray::gl {

/// History of draws with equal parts: clusters, or units of instances.
struct CullHistory {
  std::vector<uint64_t> visible;  // parts that were visible last; empty: unknown
  bool byClusters = false;        // as CullPlan has it
  CullingTrials trials;
  Hash128 arrays;          // the arrays that provide instance attributes
  uint64_t lastFrame = 0;  // last frame that drew these instances
};

/// A mesh that rasterised draws have in common, and their history.
struct CulledMeshHistory {
  std::shared_ptr<CulledMesh> mesh;
  CullHistory alone;                   // of draws without several instances
  std::vector<CullHistory> instanced;  // of draws with them
  uint64_t lastFrame = 0;              // last frame that drew it
  int frames = 0;                      // number of frames that drew it
  bool refused = false;                // its positions cannot be read
  bool different = false;              // a culled image differed (fixed function)
};

struct CullPlan {
  static constexpr uint32_t kFewUnits = 64, kLargeMesh = 256;  // in clusters

  GLenum mode = GL_TRIANGLES;
  Elements elements;
  CulledProgram* program = nullptr;  // null: fixed function
  std::shared_ptr<CulledMesh> mesh;
  CulledMeshHistory* known = nullptr;
  CullHistory* history = nullptr;
  ClipMatrix matrix;
  std::optional<InstanceUnits> units;     // none: parts are clusters of the mesh
  std::optional<Instances> instances;     // bounds of units; none: from `feedback`
  bool byClusters = false;                // parts are clusters of each unit, else units
  CullReason apart = CullReason::culled;  // reason why instances cannot be drawn separately
  scene::Region region;                   // pixels that may be drawn
  WindowMapping window;
  int samples = 1;         // of a pixel
  bool rehearsed = false;  // visibility is found in a copy of the framebuffer, which cannot be restored
  PositionFeedback* feedback = nullptr;  // source of positions, which are clip coordinates; null: arrays
  bool reversed = false;                 // larger depths are nearer: `window` maps to 1 - depth

  /// Whether a cluster that is visible in any instance is drawn in all instances.
  bool drawsAllInstances() const { return apart != CullReason::culled; }
  uint64_t primitivesIn(const std::vector<uint64_t>& parts) const;
  /// Finds the parts that may be visible in front of the depths of `pyramid`.
  void findVisible(const DepthPyramid& pyramid, std::vector<uint64_t>& visible) const;
  /// Calls each(unit, clusters) for all units of `parts`. For plans with units, by clusters.
  template <class Each>
  void forClustersOfInstances(const std::vector<uint64_t>& parts, const Each& each) const {
    const size_t words = mesh->clusters().words();
    for (uint32_t unit = 0; unit < units->units(); ++unit)
      each(unit, std::span(parts).subspan(words * unit, words));
  }

 private:
  void findClustersOfInstances(const DepthPyramid& pyramid, std::vector<uint64_t>& visible) const;
};

}  // namespace gluray::gl
