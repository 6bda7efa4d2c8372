#include "accel/impostors/pixel_impostor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace gluray::accel {
namespace {

constexpr double kSteps = 256;  // per pixel: rasterisers snap corners to these

/// Rounds to the nearest integer; large numbers have no fraction and stay.
double rounded(double v) {
  constexpr double kWhole = 0x1.8p52;
  return std::abs(v) < 0x1p50 ? (v + kWhole) - kWhole : v;
}
glm::dvec2 rounded(const glm::dvec2& v) { return {rounded(v.x), rounded(v.y)}; }

glm::dvec2 windowOf(const WindowVertex& v) { return {v.x, v.y}; }

}  // namespace

std::vector<WindowVertex> windowVertices(const PlacedImpostors& placed) {
  const scene::Mesh& mesh = *placed.mesh;
  std::vector<WindowVertex> result(mesh.vertexCount);
  tbb::parallel_for(tbb::blocked_range<uint32_t>(0, mesh.vertexCount, 4096), [&](const auto& range) {
    for (uint32_t i = range.begin(); i < range.end(); ++i) {
      const glm::dvec4 clip = placed.clipFromObject * glm::dvec4(mesh.position(i), 1);
      if (!(clip.w > 0)) continue;
      const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
      const glm::vec2 at(placed.windowCenter + placed.windowHalf * glm::dvec2(ndc));
      if (std::isfinite(at.x + at.y))
        result[i] = {at.x, at.y, static_cast<float>(ndc.z), static_cast<float>(clip.w)};
    }
  });
  return result;
}

PixelImpostor::PixelImpostor(const PlacedImpostors& placed, uint32_t primitive) : placed_(placed) {
  for (uint32_t k = 0; k < 2; ++k) {
    vertex_[k] = placed.mesh->corner(primitive, k);
    end_[k] = placed.window[vertex_[k]];
  }
  wholly_ = end_[0].w > 0 && end_[1].w > 0;
  if (placed.mesh->shape == scene::Shape::beads)
    makeBead(vertex_[0]);
  else if (placed.mesh->shape == scene::Shape::splats)
    makeSplat(vertex_[0]);
  else if (wholly_)
    makeTube();
  else
    makeBehindViewer();
}

void PixelImpostor::makeBead(uint32_t vertex) {
  // OpenGL clips points by their centre: all or nothing.
  const glm::dvec4 clip = placed_.clipFromObject * glm::dvec4(placed_.mesh->position(vertex), 1);
  exists_ = wholly_ && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w &&
            std::abs(clip.z) <= clip.w && !isCutAway(0);
  pixels_ = std::max(1.0, double{placed_.look.size.x} * placed_.windowHalf.x);
}

void PixelImpostor::makeTube() {
  const glm::dvec2 half = placed_.windowHalf, size(placed_.look.size);
  const glm::dvec2 ends[] = {windowOf(end_[0]), windowOf(end_[1])};
  if (placed_.look.inPixels) return makeTubeInPixels(ends[0], ends[1]);
  glm::dvec2 along = (ends[1] - ends[0]) / half;
  const double length = glm::length(along);
  if (!(length > 0)) return;
  along /= length;
  across_ = {-along.y, along.x};
  const double longer = placed_.look.grows ? 0.25 * std::max(0.0, glm::length(size) - length) : 0.0;
  aside_ = half * size * across_ * -1.0;
  corner_ = ends[0] - half * along * (longer * (double{end_[1].w} / end_[0].w)) - 0.5 * aside_;
  along_ = ends[1] + half * along * longer - 0.5 * aside_ - corner_;
  exists_ = turn(along_, aside_) != 0;
}

glm::dvec2 PixelImpostor::turnAcross(const glm::dvec2& pixels) {
  constexpr double kPoint = 1e-6;
  const double length = glm::length(pixels);
  const glm::dvec2 along = length > kPoint ? pixels / length : glm::dvec2(1, 0);
  across_ = {along.y, -along.x};  // the two triangles of the billboard meet along its other diagonal
  return along;
}

void PixelImpostor::makeTubeInPixels(const glm::dvec2& first, const glm::dvec2& second) {
  const glm::dvec2 along = turnAcross(second - first);
  aside_ = placed_.windowHalf * glm::dvec2(placed_.look.size) * across_ * -1.0;
  corner_ = first - 0.5 * aside_;
  along_ = second + along * double{placed_.look.longer} - first;
  exists_ = turn(along_, aside_) != 0;
}

void PixelImpostor::makeSides() {
  const glm::dvec2 around[] = {corner_, corner_ + aside_, corner_ + aside_ + along_, corner_ + along_};
  glm::dvec2 at[4];
  for (int k = 0; k < 4; ++k) at[k] = rounded(around[k] * kSteps);
  const double area = turn(at[1] - at[0], at[2] - at[0]) + turn(at[2] - at[0], at[3] - at[0]);
  if (area == 0) exists_ = false;
  for (int k = 0; k < 4; ++k) {
    const glm::dvec2 from = at[k], way = (at[(k + 1) % 4] - from) * (area < 0 ? -1.0 : 1.0);
    side_[k] = {from.x, from.y, way.x, way.y, way.y < 0 || (way.y == 0 && way.x > 0)};
  }
}

void PixelImpostor::makeBehindViewer() {
  glm::dvec4 clip[2];
  for (int k = 0; k < 2; ++k)
    clip[k] = placed_.clipFromObject * glm::dvec4(placed_.mesh->position(vertex_[k]), 1);
  const glm::dvec2 size(placed_.look.size);
  glm::dvec2 along = glm::dvec2(clip[1]) / clip[1].w - glm::dvec2(clip[0]) / clip[0].w;
  const double length = glm::length(along);
  if ((!(length > 0) && !placed_.look.inPixels) || !std::isfinite(length)) return;
  glm::dvec2 longer(0), before(0);  // what the ends move by
  if (placed_.look.inPixels) {
    along = turnAcross(along * placed_.windowHalf);
    longer = along / placed_.windowHalf * (double{placed_.look.longer} * clip[1].w);
  } else {
    along /= length;
    across_ = {-along.y, along.x};
    const double missing = placed_.look.grows ? std::max(0.0, glm::length(size) - length) : 0.0;
    longer = along * (0.25 * missing * clip[1].w), before = -longer;
  }
  glm::dvec3 corners[4];
  for (int j = 0; j < 4; ++j) {
    const int end = j / 2;
    const glm::dvec2 aside = size * across_ * ((j % 2 == 0 ? 0.5 : -0.5) * clip[end].w);
    corners[j] = glm::dvec3(glm::dvec2(clip[end]) + (end == 0 ? before : longer) + aside, clip[end].w);
    z_[j] = clip[end].z;
  }
  const glm::dvec2 scale = 1.0 / placed_.windowHalf, offset = -placed_.windowCenter * scale;
  const glm::dmat3 ndcFromWindow(glm::dvec3(scale.x, 0, 0), glm::dvec3(0, scale.y, 0), glm::dvec3(offset, 1));
  for (int h = 0; h < 2; ++h) {
    half_[h] = glm::inverse(glm::dmat3(corners[h], corners[h + 1], corners[h + 2])) * ndcFromWindow;
    hasHalf_[h] = std::isfinite(glm::determinant(half_[h]));
    exists_ = exists_ || hasHalf_[h];
  }
}

bool PixelImpostor::coversBead(const glm::dvec2& at) const {
  const double width = rounded(pixels_ * kSteps);
  const glm::dvec2 inside = at * kSteps - rounded(windowOf(end_[0]) * kSteps) + 0.5 * width;
  return inside.x >= 0 && inside.x < width && inside.y >= 0 && inside.y < width;
}

bool PixelImpostor::covers(const glm::dvec2& at) const {
  if (!exists_) return false;
  if (placed_.mesh->shape == scene::Shape::beads) return coversBead(at);
  const bool splat = placed_.mesh->shape == scene::Shape::splats;
  if (splat && !placed_.look.fillsBillboard()) return true;  // show() decides
  if (wholly_) {
    for (const Side& s : side_) {
      const double inside = s.dx * (at.y * kSteps - s.y) - s.dy * (at.x * kSteps - s.x);
      if (!(inside > 0 || (inside == 0 && s.owned))) return false;
    }
  }
  if (splat) return true;
  const OnBillboard on = onBillboard(at);
  return on.inside && on.ndc >= -1 && on.ndc <= 1;
}

PixelImpostor::OnBillboard PixelImpostor::onBillboard(const glm::dvec2& at) const {
  if (!wholly_) return onHalf(at);
  const double area = turn(along_, aside_);
  const glm::dvec2 from = at - corner_;
  const double along = turn(from, aside_) / area, aside = turn(along_, from) / area;
  const double w0 = end_[0].w, w1 = end_[1].w, sum = (1 - along) / w0 + along / w1;
  // The billboard is drawn as two triangles, each with its own perspective interpolation.
  const double side = along + aside <= 1 ? 1 - 2 * aside / (w0 * sum) : 2 * (1 - aside) / (w1 * sum) - 1;
  const double first = end_[0].ndc, second = end_[1].ndc;
  return {along / (w1 * sum), side, first + along * (second - first), true};
}

PixelImpostor::OnBillboard PixelImpostor::onHalf(const glm::dvec2& at) const {
  const glm::dvec3 p(at, 1);
  const auto least = [](const glm::dvec3& v) { return std::min({v.x, v.y, v.z}); };
  const glm::dvec3 first = half_[0] * p, second = half_[1] * p;
  const int h = !hasHalf_[1] || (hasHalf_[0] && least(first) >= least(second)) ? 0 : 1;
  const glm::dvec3 w = h == 0 ? first : second;
  constexpr double kEnd[] = {0, 0, 1, 1}, kSide[] = {1, -1, 1, -1};
  const auto mixed = [&](const double* of) { return w.x * of[h] + w.y * of[h + 1] + w.z * of[h + 2]; };
  const double sum = w.x + w.y + w.z;
  return {mixed(kEnd) / sum, mixed(kSide) / sum, mixed(z_), least(w) >= 0};
}

double PixelImpostor::depthOf(double ndc, double round) const {
  const scene::Impostors& f = placed_.look;
  const double z = ndc * placed_.depthScale + placed_.depthOffset, b = round * f.bulge;
  const double depth = f.parallelView ? z + b * f.bulgeDepth : f.bulgeDepth + (z - f.bulgeDepth) / (1 - b);
  return std::clamp(depth + f.depthBias, 0.0, 1.0);
}

bool PixelImpostor::isCutAway(double along) const {
  const scene::Mesh& mesh = *placed_.mesh;
  if (placed_.look.centerPlanes.empty()) return false;
  const glm::dvec3 first(mesh.position(vertex_[0])), second(mesh.position(vertex_[1]));
  const glm::dvec4 p(glm::mix(first, second, along), 1);
  for (const glm::vec4& plane : placed_.look.centerPlanes)
    if (glm::dot(glm::dvec4(plane), p) < 0) return true;
  return false;
}

glm::vec3 PixelImpostor::outwards() const {
  if (hasOutwards_) return outwards_;
  const auto center = [&](int k) {
    return scene::impostorCenter(placed_.lightingFromObject, placed_.mesh->position(vertex_[k]));
  };
  glm::vec3 line = center(1) - center(0);
  constexpr float kPoint = 1e-6f;
  if (placed_.look.inPixels && !(glm::length(line) > kPoint)) line = {0, 0, 1};
  outwards_ = glm::normalize(glm::cross(glm::normalize(line), glm::vec3(across_, 0)));
  outwards_ *= placed_.look.inPixels && outwards_.z == 0 ? 1.0f : glm::sign(outwards_.z);
  hasOutwards_ = true;
  return outwards_;
}

bool PixelImpostor::show(const glm::dvec2& at, Shown& shown) const {
  if (placed_.mesh->shape == scene::Shape::splats) return showSplat(at, shown);
  if (placed_.mesh->shape == scene::Shape::beads) {
    const glm::dvec2 shift(placed_.look.coordinateShift);
    const glm::dvec2 from = (at + shift - windowOf(end_[0])) * (2 / pixels_);
    const double length2 = glm::dot(from, from);
    if (!(length2 <= 1)) return false;
    shown.normal = glm::vec3(glm::dvec3(from, std::sqrt(1 - length2)));
    shown.along = 0;
    shown.depth = depthOf(end_[0].ndc, shown.normal.z);
    return true;
  }
  const OnBillboard on = onBillboard(at);
  if (isCutAway(on.along)) return false;
  const double round = std::sqrt(std::max(0.0, 1 - on.side * on.side));
  const glm::vec3 out = outwards();
  shown.along = on.along;
  shown.normal = glm::normalize(glm::vec3(across_ * on.side, 0) + out * static_cast<float>(round));
  // The bulge of tubes that run away from the viewer is limited to its value at sixty degrees.
  shown.depth = depthOf(on.ndc, round / std::clamp(double{out.z}, 0.5, 1.0));
  return std::isfinite(out.z);
}

}  // namespace gluray::accel
