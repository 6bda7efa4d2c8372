#include "accel/impostors/pixel_impostor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace gluray::accel {
namespace {

/// Upper bound of an impostor's extent about its point or line, pixels.
float pixelReach(const PlacedImpostors& placed) {
  const glm::vec2 size = placed.look.size * glm::vec2(placed.windowHalf);
  if (placed.look.inPixels) return 0.5f * size.x + placed.look.longer;
  return placed.look.grows ? 0.5f * glm::length(size) : 0.5f * std::max({size.x, size.y, 1.0f});
}

/// Whether the impostor may cover any position in the rectangle; most with a hit bounding box do not.
bool mayMeet(const PlacedImpostors& placed, uint32_t primitive, const WindowRectangle& r) {
  const scene::Mesh& mesh = *placed.mesh;
  if (mesh.shape == scene::Shape::splats) return placed.window[mesh.corner(primitive, 0)].w > 0;
  const WindowVertex &a = placed.window[mesh.corner(primitive, 0)],
                     &b = placed.window[mesh.corner(primitive, 1)];
  if (!(a.w > 0 && b.w > 0)) return mesh.shape == scene::Shape::tubes;
  // An end's growth is scaled by the ratio of the ends' distances.
  const float grown = placed.look.grows ? 1 + std::max(b.w / a.w, 1.0f) : 1;
  const float reach = pixelReach(placed) * grown + 0.01f;
  if (std::min(a.x, b.x) - reach > r.right || std::max(a.x, b.x) + reach < r.left ||
      std::min(a.y, b.y) - reach > r.upper || std::max(a.y, b.y) + reach < r.lower)
    return false;
  const float x = b.x - a.x, y = b.y - a.y;
  const float off = std::abs(x * (0.5f * (r.lower + r.upper) - a.y) - y * (0.5f * (r.left + r.right) - a.x));
  // Half the rectangle's extent perpendicular to the line, times the line's length.
  const float across = 0.5f * (std::abs(x) * (r.upper - r.lower) + std::abs(y) * (r.right - r.left));
  return off <= (across + reach * std::sqrt(x * x + y * y)) * 1.001f + 0.01f ||
         mesh.shape == scene::Shape::beads;
}

}  // namespace

WindowRectangle::WindowRectangle(const PixelRays& rays)
    : left(rays.windowX[0]), right(left), lower(rays.windowY[0]), upper(lower) {
  for (int i = 1; i < kLanes; ++i) {
    left = std::min(left, rays.windowX[i]), right = std::max(right, rays.windowX[i]);
    lower = std::min(lower, rays.windowY[i]), upper = std::max(upper, rays.windowY[i]);
  }
}

uint32_t PixelImpostor::nearby(const PixelRays& rays, uint32_t lanes) const {
  if (!exists_) return 0;
  if (!wholly_ || placed_.mesh->shape != scene::Shape::tubes) return lanes;
  // Billboard coordinates relative to the first position: small enough for floats.
  constexpr double kPixels = 0.02;  // snapping and rounding move sides by less
  const glm::dvec2 start(rays.windowX[0], rays.windowY[0]);
  const double area = turn(along_, aside_);
  const auto alongX = static_cast<float>(aside_.y / area), alongY = static_cast<float>(-aside_.x / area),
             asideX = static_cast<float>(-along_.y / area), asideY = static_cast<float>(along_.x / area),
             along = static_cast<float>(turn(start - corner_, aside_) / area) - 0.5f,
             aside = static_cast<float>(turn(along_, start - corner_) / area) - 0.5f,
             mostAlong = static_cast<float>(0.5 + kPixels * glm::length(aside_ / area)),
             mostAside = static_cast<float>(0.5 + kPixels * glm::length(along_ / area));
  float outside[kLanes];
  for (int i = 0; i < kLanes; ++i) {
    const float x = rays.windowX[i] - rays.windowX[0], y = rays.windowY[i] - rays.windowY[0];
    outside[i] = std::max(std::abs(along + x * alongX + y * alongY) - mostAlong,
                          std::abs(aside + x * asideX + y * asideY) - mostAside);
  }
  uint32_t near = 0;
  for (int i = 0; i < kLanes; ++i) near |= (outside[i] <= 0 ? 1u : 0u) << i;
  return near & lanes;
}

uint32_t meet(const PlacedImpostors& placed, uint32_t primitive, const ImpostorQuery& rays,
              const WindowRectangle& around, uint32_t lanes, float (&t)[kLanes]) {
  if (!mayMeet(placed, primitive, around)) return 0;
  const PixelRays &centers = *rays.centers, &samples = *rays.samples;
  PixelImpostor impostor(placed, primitive);
  lanes = impostor.nearby(samples, lanes);
  if (!lanes) return 0;
  impostor.prepare();
  uint32_t met = 0;
  PixelImpostor::Shown shown;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (!impostor.covers({samples.windowX[i], samples.windowY[i]}) ||
        !impostor.show({centers.windowX[i], centers.windowY[i]}, shown))
      continue;
    // t of the ray's point at this depth.
    const glm::dvec4 org(centers.orgX[i], centers.orgY[i], centers.orgZ[i], 1),
        dir(centers.dirX[i], centers.dirY[i], centers.dirZ[i], 0);
    const double ndc = (shown.depth - placed.depthOffset) / placed.depthScale;
    const double at = (ndc * glm::dot(placed.clipW, org) - glm::dot(placed.clipZ, org)) /
                      (glm::dot(placed.clipZ, dir) - ndc * glm::dot(placed.clipW, dir));
    const double end = std::min<double>(centers.tFar[i], 1e30) * (1 - 0x1p-20);
    t[i] = static_cast<float>(std::isnan(at) ? end : std::clamp(at, 0.0, end));
    met |= 1u << i;
  }
  return met;
}

}  // namespace gluray::accel
