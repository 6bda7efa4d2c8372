// PixelImpostor: splats.
#include "accel/impostors/pixel_impostor.h"

#include <algorithm>
#include <cmath>

namespace gluray::accel {

void PixelImpostor::makeSplat(uint32_t vertex) {
  constexpr double kFarthest = 1.3, kAcross = 1e-6;
  const scene::Mesh& mesh = *placed_.mesh;
  const scene::Impostors& f = placed_.look;
  const glm::dvec4 clip = placed_.clipFromObject * glm::dvec4(mesh.position(vertex), 1);
  exists_ = wholly_ && std::abs(clip.x) <= kFarthest * clip.w && std::abs(clip.y) <= kFarthest * clip.w &&
            std::abs(clip.z) <= clip.w && !isCutAway(0);
  const float ownRadius = mesh.radii ? scene::fetch(mesh.radii, vertex).x : mesh.radius;
  const double radius = double{ownRadius} / f.radiusDivisor;
  const glm::dvec3 p(scene::impostorCenter(placed_.lightingFromObject, mesh.position(vertex)));
  const glm::dmat3 w = glm::transpose(glm::dmat3(glm::mat3(placed_.lightingFromObject)));
  // Rows of J W.
  glm::dvec3 x = double{f.size.x} * w[0], y = double{f.size.y} * w[1];
  if (!f.parallelView)
    x = (x - f.size.x * p.x / p.z * w[2]) / p.z, y = (y - f.size.y * p.y / p.z * w[2]) / p.z;
  const double r2 = radius * radius, across = r2 * glm::dot(x, y);
  const glm::dvec3 lowpass(f.lowpass);
  const double off = (std::abs(across + lowpass.y) > kAcross ? across + lowpass.y : 0.0);
  const glm::dvec2 half = placed_.windowHalf;
  const glm::dmat2 c((r2 * glm::dot(x, x) + lowpass.x) * half.x * half.x, off * half.x * half.y,
                     off * half.x * half.y, (r2 * glm::dot(y, y) + lowpass.z) * half.y * half.y);
  const double determinant = glm::determinant(c);
  exists_ = exists_ && determinant > 0 && std::isfinite(determinant);
  if (exists_) inverse_ = glm::inverse(c);
  if (exists_ && f.fillsBillboard()) makeSquare(glm::vec3(p), (1 / f.radiusDivisor) * ownRadius);
}

/// The square turns to the eigenvectors of C, which nearly round splats hardly have: as shaders do, in their
/// order and precision.
void PixelImpostor::makeSquare(const glm::vec3& center, float radius) {
  constexpr float kAcross = 1e-6f;
  const scene::Impostors& f = placed_.look;
  const float x = f.parallelView ? f.size.x : f.size.x / center.z,
              y = f.parallelView ? f.size.y : f.size.y / center.z, z2 = center.z * center.z;
  const glm::mat3 j(x, 0, 0, 0, y, 0, f.parallelView ? 0 : -(f.size.x * center.x) / z2,
                    f.parallelView ? 0 : -(f.size.y * center.y) / z2, 0);
  const glm::mat3 t = j * glm::mat3(placed_.lightingFromObject);
  const glm::mat2 c = glm::mat2((radius * radius) * t * glm::transpose(t)) +
                      glm::mat2(f.lowpass.x, f.lowpass.y, f.lowpass.y, f.lowpass.z);
  glm::mat2 turned(std::sqrt(c[0][0]), 0, 0, std::sqrt(c[1][1]));
  if (std::abs(c[0][1]) > kAcross) {
    const float mean = 0.5f * (c[0][0] + c[1][1]), half = std::sqrt(mean * mean - glm::determinant(c));
    const glm::vec2 first = glm::normalize(glm::vec2(mean + half - c[1][1], c[0][1]));
    turned = glm::mat2(std::sqrt(mean + half) * first, std::sqrt(mean - half) * glm::vec2(first.y, -first.x));
  }
  const glm::dvec2 scale = placed_.windowHalf * double{f.billboardScale};
  const glm::dvec2 across = scale * glm::dvec2(turned[0]), up = scale * glm::dvec2(turned[1]);
  corner_ = glm::dvec2(end_[0].x, end_[0].y) - across - up;
  aside_ = 2.0 * across, along_ = 2.0 * up;
  const double area = turn(along_, aside_);
  exists_ = area != 0 && std::isfinite(area);
}

bool PixelImpostor::showSplat(const glm::dvec2& at, Shown& shown) const {
  const scene::Impostors& f = placed_.look;
  const auto squared = [&](double x, double y) {
    const glm::dvec2 from(x - end_[0].x, y - end_[0].y);
    return glm::dot(from, inverse_ * from);
  };
  const double share = squared(at.x, at.y);
  if (!(share <= 1) && !f.fillsBillboard()) return false;
  shown.normal = {0, 0, 1};
  shown.along = 0;
  shown.fade = f.fades ? static_cast<float>(1 - share) : 1.0f;
  shown.alpha = f.gaussian ? static_cast<float>(std::exp(-0.5 * share)) : 1.0f;
  if (f.antialiased) {
    const double outside = std::sqrt(share) - 1, half = 0.5 * double{f.outline};
    if (f.outline == 0) shown.fade = static_cast<float>(std::max(0.0, -outside));
    if (outside > 0 || f.outline != 0) {
      const double x = 2 * std::floor(0.5 * at.x) + 0.5,
                   y = 2 * std::floor(0.5 * at.y) + 0.5;  // of the block
      const double width = std::abs(std::sqrt(squared(x + 1, at.y)) - std::sqrt(squared(x, at.y))) +
                           std::abs(std::sqrt(squared(at.x, y + 1)) - std::sqrt(squared(at.x, y)));
      const double along = f.outline == 0 ? outside / width : 0.5 * (std::abs(outside) / width - half + 1);
      const double t = std::clamp(along, 0.0, 1.0);
      shown.alpha = static_cast<float>(1 - t * t * (3 - 2 * t));
      if (!(shown.alpha > 0)) return false;
    }
  }
  const double depth = end_[0].ndc * placed_.depthScale + placed_.depthOffset;
  shown.depth = std::clamp(depth + f.depthBias, 0.0, 1.0);
  return true;
}

}  // namespace gluray::accel
