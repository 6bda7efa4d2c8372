// Tests whether bounding boxes, transformed by a matrix, may be visible in front of a depth image. Any
// thread.
#pragma once
#include "gl/culled/clusters/depth_pyramid.h"

#include <glm/glm.hpp>

namespace gluray::gl {

/// Maps clip space to the pixels of a pyramid and to window depth.
struct WindowMapping {
  glm::dvec4 viewport{0};              // x, y, width, height in pixels, relative to the pyramid's corner
  double depthNear = 0, depthFar = 1;  // glDepthRange
  double sampleReach = 0;              // maximum distance of samples from the pixel centre along each axis
};

/// Matrix from vertex positions to clip space, with bounds for rounding errors, which grow with the
/// magnitudes.
struct ClipMatrix {
  glm::dmat4 clipFromObject{1};
  glm::dmat4 magnitudes{0};  // upper bounds of the sums of absolute values in clipFromObject
};

class BoxVisibility {
 public:
  /// Null pyramid: everything in the view counts as visible. The pyramid must outlive this.
  BoxVisibility(const ClipMatrix& matrix, const WindowMapping& window, const DepthPyramid* pyramid);

  /// Whether the box around `center` may have a pixel at or in front of the pyramid's depth. Conservative,
  /// including the rounding of shaders, and of rasterisers that snap vertices to 1/256 pixel.
  bool mayShow(const glm::dvec4& center, const glm::dvec4& extent) const;

 private:
  /// Depth test for a box around `at` in normalised device coordinates.
  bool isNearer(const glm::dvec3& at, const glm::dvec3& reach) const;

  glm::dvec4 row_[4], magnitude_[4];
  const DepthPyramid* pyramid_;
  const WindowMapping window_;
  glm::dvec3 margin_{0};  // of clip space, relative to w
  double depthScale_ = 0.5, depthMiddle_ = 0.5;
};

}  // namespace gluray::gl
