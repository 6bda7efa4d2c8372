// Draws parts of planned draws, and finds the parts that may be visible in front of the framebuffer's depths.
// A part of LargeDraws, GL thread, context current.
#pragma once
#include "gl/culled/clusters/depth_pyramid.h"
#include "gl/culled/cull_plan.h"
#include "gl/pending/pending_batch.h"
#include "gl/shadow/shadow_state.h"

#include <GL/gl.h>

#include <cstdint>
#include <span>
#include <vector>

namespace gluray::gl {

class PartDraws {
 public:
  PartDraws(ShadowState& shadow, PendingBatch& pending) : shadow_(shadow), pending_(pending) {}

  /// Call for each draw: positions of the last one are not known any more.
  void begin() { placed_ = false; }
  /// Updates the clusters for this draw's positions. Returns false if these are unknown.
  bool placeClusters(const CullPlan& plan);
  /// Reads the depth of the region and finds the parts that may be visible. Returns false if depth cannot be
  /// read.
  bool findVisible(const CullPlan& plan, std::vector<uint64_t>& visible);
  /// Whether a pixel of these parts has exactly the framebuffer's depth, so that the drawing order decides.
  bool meetsEqual(const CullPlan& plan, const std::vector<uint64_t>& parts);

  void drawWhole(const CullPlan& plan) { drawReal(shadow_.real, plan.mode, plan.elements); }
  void drawParts(const CullPlan& plan, const std::vector<uint64_t>& parts);

 private:
  /// The farthest depth of each pixel's samples.
  bool readFarthest(const CullPlan& plan);
  /// Draws the clusters. `as`: the instances of the draw.
  void drawClusters(const CulledMesh& mesh, std::span<const uint64_t> clusters, const Elements& as);

  ShadowState& shadow_;
  PendingBatch& pending_;
  bool placed_ = false;  // for the current draw
  std::vector<float> depths_;
  DepthPyramid pyramid_;
  std::vector<uint32_t> indices_;
  GLuint indexBuffer_ = 0, query_ = 0;
};

}  // namespace gluray::gl
