// Maps the pixels of a visibility buffer to eye space. Made once a frame, read by all tracing threads.
#pragma once
#include "render/frame_data/frame_data.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// The pixel at position (x, y) shows the eye-space points base(x, y) + depth * ray(x, y), both linear
/// in the position; pixel (0, 0) has its centre at (0, 0). Depths of the scene are in (0, 2): proportional to
/// the distance from the eye, or in parallel projections at least 1.
struct PixelSpace {
  bool usable = false;  // whether the projection allows this
  glm::vec3 base{0}, baseX{0}, baseY{0};
  glm::vec3 ray{0}, rayX{0}, rayY{0};
  glm::vec4 depth{0};          // of eye-space point p: dot(depth, (p, 1))
  glm::dmat4 pixelFromEye{1};  // rows x, y and w count: position = (x, y) / w
  /// Width of a pixel, eye space: pixel + depth * perDepth.
  float pixel = 0, perDepth = 0;

  PixelSpace() = default;
  /// For the frame's camera and the bounds of its world.
  explicit PixelSpace(const FrameData&);
};

}  // namespace gluray::render
