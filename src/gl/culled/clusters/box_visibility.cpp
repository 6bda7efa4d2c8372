#include "gl/culled/clusters/box_visibility.h"

#include <algorithm>
#include <cmath>

namespace gluray::gl {
namespace {

double spreadAlong(const glm::dvec4& row, const glm::dvec4& extent) {
  return glm::dot(glm::abs(row), extent);
}

}  // namespace

BoxVisibility::BoxVisibility(const ClipMatrix& matrix, const WindowMapping& window,
                             const DepthPyramid* pyramid)
    : pyramid_(pyramid), window_(window) {
  const glm::dmat4 rows = glm::transpose(matrix.clipFromObject),
                   magnitudes = glm::transpose(matrix.magnitudes);
  for (int i = 0; i < 4; ++i) row_[i] = rows[i], magnitude_[i] = glm::max(glm::abs(rows[i]), magnitudes[i]);
  // Samples may be covered up to this far outside the view volume.
  const auto pixels = [&](double size) { return 4 * window.sampleReach / std::max(size, 1.0); };
  margin_ = {pixels(window.viewport.z), pixels(window.viewport.w), 0};
  depthScale_ = 0.5 * (window.depthFar - window.depthNear);
  depthMiddle_ = 0.5 * (window.depthFar + window.depthNear);
}

bool BoxVisibility::mayShow(const glm::dvec4& center, const glm::dvec4& extent) const {
  // Covers some thirty single-precision operations of a shader.
  constexpr double kRounding = 32.0 / (1 << 24);
  const glm::dvec4 reach = glm::abs(center) + extent;
  glm::dvec4 clip, error;
  for (int i = 0; i < 4; ++i)
    clip[i] = glm::dot(row_[i], center), error[i] = kRounding * glm::dot(magnitude_[i], reach);
  const double w = clip.w, wReach = spreadAlong(row_[3], extent) + error.w;
  for (int i = 0; i < 3; ++i) {
    const double slack = error[i] + error.w + margin_[i] * (std::abs(w) + wReach);
    if (w + clip[i] + spreadAlong(row_[3] + row_[i], extent) + slack < 0) return false;
    if (w - clip[i] + spreadAlong(row_[3] - row_[i], extent) + slack < 0) return false;
  }
  const double nearest = w - wReach;
  // Boxes that reach behind the viewer project to no finite rectangle.
  if (!(nearest > 1e-6 * (std::abs(w) + wReach))) return true;
  if (!pyramid_) return true;
  glm::dvec3 at, reachAt;
  for (int i = 0; i < 3; ++i) {
    at[i] = clip[i] / w;
    const double spread = spreadAlong(row_[i] - at[i] * row_[3], extent);
    reachAt[i] = (spread + error[i] + std::abs(at[i]) * error.w) / nearest;
  }
  return isNearer(at, reachAt);
}

bool BoxVisibility::isNearer(const glm::dvec3& at, const glm::dvec3& reach) const {
  // Pixels are covered at their samples around the centres (1/2, 1/2); vertices snap to 1/256 pixel.
  const double slack = 1.0 / 64 + window_.sampleReach;
  const glm::dvec4& v = window_.viewport;
  const double x = v.x + (at.x + 1) * 0.5 * v.z - 0.5, xReach = reach.x * 0.5 * v.z + slack;
  const double y = v.y + (at.y + 1) * 0.5 * v.w - 0.5, yReach = reach.y * 0.5 * v.w + slack;
  const double x0 = std::ceil(x - xReach), x1 = std::floor(x + xReach);
  const double y0 = std::ceil(y - yReach), y1 = std::floor(y + yReach);
  if (!(x0 <= x1 && y0 <= y1)) return false;  // between the samples
  if (!(x1 >= 0 && y1 >= 0 && x0 < pyramid_->width() && y0 < pyramid_->height())) return false;
  // Depth planes are computed in single precision from snapped vertices.
  constexpr double kDepth = 1.0 / (1 << 16);
  const double depth = depthMiddle_ + depthScale_ * at.z - std::abs(depthScale_) * reach.z - kDepth;
  const auto clamped = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, double(most)));
  };
  const float farthest =
      pyramid_->farthest(clamped(x0, pyramid_->width() - 1), clamped(y0, pyramid_->height() - 1),
                         clamped(x1, pyramid_->width() - 1), clamped(y1, pyramid_->height() - 1));
  return depth <= double{farthest};
}

}  // namespace gluray::gl
