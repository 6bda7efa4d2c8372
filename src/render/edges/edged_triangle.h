// Triangles with painted edges, as in VTK's geometry shader. If edges grow
// (scene::FragmentShading::edgesGrow), corners move outwards in the window by up to a quarter of the line
// width and keep their depths, so that lines on outlines are fully visible. Made for single
// pixels and, where triangles grow, for tiles.
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

/// Bounds of a triangle in the window; none if it lies behind the viewer, infinite if a part of it does.
std::optional<WindowBox> windowBoxOf(const Surface& surface, const scene::Camera& camera, uint32_t primitive);

class EdgedTriangle {
 public:
  /// A triangle of a surface whose shading has edges (scene::FragmentShading::edges). Corners behind the
  /// viewer have the window positions that the geometry shader computes for them.
  EdgedTriangle(const Surface& surface, const scene::Camera& camera, uint32_t primitive);

  /// Bounds of the grown triangle; infinite if a part of it lies behind the viewer.
  WindowBox bounds() const;
  /// Half planes whose intersection is what covers() accepts.
  std::array<HalfPlane, 6> grown() const;
  /// Half planes whose intersection is the triangle before it grew; empty if a part of it lies behind the
  /// viewer.
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
  /// The weights of the moved corners, each divided by its clip w.
  glm::dvec3 shares(const glm::dvec2& at) const { return glm::dvec3(at, 1) * shareOf_; }
  double distance(int edge, const glm::dvec2& at) const {
    return glm::dot(inward_[edge], at - corner_[edge]);
  }

  glm::dvec2 corner_[3], inward_[3];  // window; inward_: unit normals of the edges from corner k to the next
  glm::dvec3 moved_[3];               // homogeneous window positions: x*w, y*w, w
  glm::dmat3 shareOf_{0};             // column k: the linear form of corner k's share; 0 without area
  glm::dvec3 depth_;                  // clip z
  bool hidden_[3];
  bool crosses_ = false;  // some corner is behind the viewer
  float opacity_ = 1;
  double width_ = 1;
};

}  // namespace gluray::render
