// Triangles with painted edges, as a geometry shader makes them of those that the program draws: corners
// moved outwards in the window by up to a quarter of the lines' width, at their old depths, so that lines on
// outlines are seen whole (scene::FragmentShading::edgesGrow), or left where they are. Made by the kernels
// for single pixels.
#pragma once
#include "render/local/surface.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::render {

class EdgedTriangle {
 public:
  /// A triangle of a surface whose shading has edges (scene::FragmentShading::edges); its corners must be
  /// before the viewer.
  EdgedTriangle(const Surface& surface, const scene::Camera& camera, uint32_t primitive);

  /// Whether it is drawn at a window position.
  bool covers(const glm::dvec2& at) const;
  /// NDC depth there.
  double ndcDepth(const glm::dvec2& at) const;
  /// Weights of corners 1 and 2 there, as attributes are interpolated.
  glm::vec2 weights(const glm::dvec2& at) const;
  /// How much of the edges' colour is seen there, 0 to 1.
  float edgeShare(const glm::dvec2& at) const;

 private:
  glm::dvec3 barycentric(const glm::dvec2& at) const;
  double distance(int edge, const glm::dvec2& at) const {
    return glm::dot(inward_[edge], at - corner_[edge]);
  }

  glm::dvec2 corner_[3], moved_[3];  // window
  glm::dvec2 inward_[3];             // unit normals of the edges from corner k to the next
  double depth_[3], w_[3];
  bool hidden_[3];
  float opacity_ = 1;
  double width_ = 1, area_ = 0;  // of the moved triangle, twice
};

}  // namespace gluray::render
