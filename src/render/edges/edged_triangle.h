// Triangles with painted edges, as in VTK's geometry shader. If edges grow
// (scene::FragmentShading::edgesGrow), corners move outwards in the window by up to a quarter of the line
// width and keep their depths, so that lines on outlines are fully visible. Made by the kernels for single
// pixels.
#pragma once
#include "render/local/surface.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace gluray::render {

/// Window positions p with dot(normal, p) >= least.
struct HalfPlane {
  glm::dvec2 normal;
  double least;
};

/// Window coordinates.
struct WindowBox {
  glm::dvec2 lower, upper;
};

/// Bounds of a triangle in the window; none if a corner is not in front of the viewer.
std::optional<WindowBox> windowBoxOf(const Surface& surface, const scene::Camera& camera, uint32_t primitive);

class EdgedTriangle {
 public:
  /// A triangle of a surface whose shading has edges (scene::FragmentShading::edges). Its corners must be in
  /// front of the viewer.
  EdgedTriangle(const Surface& surface, const scene::Camera& camera, uint32_t primitive);

  /// Bounds of the grown triangle.
  glm::dvec2 lower() const { return glm::min(glm::min(moved_[0], moved_[1]), moved_[2]); }
  glm::dvec2 upper() const { return glm::max(glm::max(moved_[0], moved_[1]), moved_[2]); }
  /// Half planes whose intersection is what covers() accepts. Without area they may hold anything.
  std::array<HalfPlane, 6> grown() const;
  /// Half planes whose intersection is the triangle before it grew.
  std::array<HalfPlane, 3> own() const;
  /// Whether the triangle covers a window position.
  bool covers(const glm::dvec2& at) const;
  /// NDC depth at a window position.
  double ndcDepth(const glm::dvec2& at) const;
  /// Perspective-correct weights of corners 1 and 2 at a window position, for attributes.
  glm::vec2 weights(const glm::dvec2& at) const;
  /// Weight of the edge colour at a window position, 0 to 1.
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
  double width_ = 1, area_ = 0;  // area_: twice that of the moved triangle
};

}  // namespace gluray::render
