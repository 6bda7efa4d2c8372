#include "saved/shot/view_camera.h"

#include <cmath>

namespace gluray::saved {
namespace {

/// Of right angles: programs' matrices are floats.
constexpr double kRightAngle = 1e-3;

bool isDirection(const glm::dvec3& v) { return std::isfinite(glm::length(v)) && glm::length(v) > 0; }

}  // namespace

std::optional<glm::dmat4> cameraFromWorld(const ViewCamera& camera) {
  const glm::dvec3 backward = camera.position - camera.focalPoint;
  if (!isDirection(backward) || !isDirection(camera.up)) return std::nullopt;
  const glm::dvec3 back = glm::normalize(backward), right = glm::cross(glm::normalize(camera.up), back);
  if (!(glm::length(right) > 1e-9)) return std::nullopt;
  const glm::dvec3 x = glm::normalize(right), y = glm::cross(back, x);
  const glm::dmat3 rows(x, y, back);
  glm::dmat4 result(glm::transpose(rows));
  result[3] = glm::dvec4(-(glm::transpose(rows) * camera.position), 1);
  return result;
}

std::optional<SeenCamera> seenCamera(const glm::dmat4& clipFromSpace) {
  const glm::dmat4 rows = glm::transpose(clipFromSpace);
  const glm::dvec3 w(rows[3]);
  const double depth = glm::length(w);
  const double scale = glm::length(glm::dvec3(rows[1]));
  SeenCamera seen;
  // Programs factor their matrices in floats: w may keep a trace of the position.
  seen.parallel = depth <= 1e-9 * scale * std::abs(rows[3].w);
  if (seen.parallel)
    seen.back = -glm::cross(glm::dvec3(rows[0]), glm::dvec3(rows[1]));
  else
    seen.back = -w;
  if (seen.parallel && glm::dot(seen.back, glm::dvec3(rows[2])) > 0) seen.back = -seen.back;
  if (!isDirection(seen.back)) return std::nullopt;
  seen.back = glm::normalize(seen.back);
  const auto across = [&](const glm::dvec4& row) {
    const glm::dvec3 r(row);
    return seen.parallel ? r : r - glm::dot(r, seen.back) * seen.back;
  };
  const glm::dvec3 x = across(rows[0]), y = across(rows[1]);
  if (!isDirection(x) || !isDirection(y)) return std::nullopt;
  seen.right = glm::normalize(x), seen.up = glm::normalize(y);
  const glm::dmat3 middle =
      glm::transpose(seen.parallel ? glm::dmat3(glm::dvec3(rows[0]), glm::dvec3(rows[1]), seen.back)
                                   : glm::dmat3(glm::dvec3(rows[0]), glm::dvec3(rows[1]), w));
  const glm::dvec3 there(rows[0].w, rows[1].w, seen.parallel ? 0 : rows[3].w);
  seen.position = -(glm::inverse(middle) * there);
  seen.halfHeight = (seen.parallel ? rows[3].w : depth) / glm::length(y);
  const bool finite = std::isfinite(glm::length(seen.position)) && std::isfinite(seen.halfHeight);
  return finite && seen.halfHeight > 0 ? std::optional(seen) : std::nullopt;
}

bool isRectangular(const SeenCamera& seen) {
  return std::abs(glm::dot(seen.right, seen.up)) <= kRightAngle &&
         std::abs(glm::dot(seen.right, seen.back)) <= kRightAngle &&
         std::abs(glm::dot(seen.up, seen.back)) <= kRightAngle;
}

double halfHeightOf(const ViewCamera& camera) {
  return camera.isParallel() ? camera.parallelScale : std::tan(glm::radians(camera.viewAngle) / 2);
}

bool areEquallyHigh(const SeenCamera& seen, const ViewCamera& camera, double within) {
  return seen.parallel == camera.isParallel() &&
         std::abs(seen.halfHeight / halfHeightOf(camera) - 1) <= within;
}

bool areAlike(const SeenCamera& seen, const ViewCamera& camera, double within) {
  const auto matrix = cameraFromWorld(camera);
  if (!matrix || !isRectangular(seen) || !areEquallyHigh(seen, camera, within)) return false;
  const glm::dmat3 axes = glm::transpose(glm::dmat3(*matrix));
  const auto areNear = [&](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) <= within; };
  if (!areNear(seen.right, axes[0]) || !areNear(seen.up, axes[1]) || !areNear(seen.back, axes[2]))
    return false;
  glm::dvec3 apart = seen.position - camera.position;
  // A parallel projection looks the same from all points of a line.
  if (seen.parallel) apart -= glm::dot(apart, seen.back) * seen.back;
  return glm::length(apart) <= within * glm::length(camera.position - camera.focalPoint);
}

}  // namespace gluray::saved
