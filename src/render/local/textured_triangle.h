// Fixed-function texturing of fragments. Used by the kernels on tracing threads.
#pragma once
#include "render/local/group.h"
#include "render/local/mipmap.h"
#include "render/local/surface.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::render {

/// Textures fragments of one surface. Caches the values that fragments of the same triangle share.
class TexturedTriangle {
 public:
  TexturedTriangle(const Surface&, const scene::Camera&);
  /// `textures`: those to sample in place of the surface's; at most kTextureUnits. Must outlive it.
  TexturedTriangle(const Surface&, const scene::Camera&, const std::vector<scene::Texture>& textures);

  /// The colour after all texture units, every channel in 0 .. 1, of the fragment at (u, v) of a triangle and
  /// at a window position. `primary`: its colour before texturing. `steps`: the pixel's extent on the
  /// triangle; null: from the window position.
  glm::vec4 color(uint32_t primitive, float u, float v, glm::dvec2 window, const glm::vec4& primary,
                  const WeightSteps* steps = nullptr);
  /// The textures' texels there, before any environment, in their order.
  void texels(uint32_t primitive, float u, float v, glm::dvec2 window, const WeightSteps* steps,
              glm::vec4 (&out)[scene::kTextureUnits]);

 private:
  /// Homogeneous coordinates (s, t, r, q) of a unit: at the corners, and as a linear function of the window
  /// position, up to a factor.
  struct Coordinates {
    glm::dvec4 corner[3];
    glm::dvec4 start, stepX, stepY;
  };
  void enter(uint32_t primitive);
  void cornersOf(const scene::Texture&, Coordinates&) const;
  Footprint footprintOf(const scene::Texture&, const Coordinates&, glm::dvec2 window) const;
  static Footprint footprintOf(const scene::Texture&, const Coordinates&, const glm::dvec3& weights,
                               const WeightSteps&);
  glm::vec4 sample(const scene::Texture&, const Coordinates&, const glm::dvec3& weights, glm::dvec2 window,
                   const WeightSteps* steps) const;

  const Surface& surface_;
  const WindowMap map_;
  const int rowsFromTop_;
  const std::vector<scene::Texture>& textures_;
  bool planes_ = false;  // some texture needs its footprint
  uint32_t primitive_ = 0xFFFFFFFFu;
  uint32_t vertex_[3] = {};
  Coordinates coordinates_[scene::kTextureUnits];  // one per texture, in order
};

/// Textures a single fragment.
glm::vec4 textureFragment(const Surface&, const scene::Camera&, uint32_t primitive, float u, float v,
                          glm::dvec2 window, const glm::vec4& primary);

}  // namespace gluray::render
