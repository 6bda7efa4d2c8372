#include "saved/export/gather/scene_views.h"

#include "scene/same_camera.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gluray::saved {
namespace {

using scene::Snapshot;

/// Whether two projections show a point at the same place, whatever the depths: a program may split the
/// depths of one view.
bool haveSameLines(const glm::dmat4& a, const glm::dmat4& b) {
  constexpr double kRounding = 1e-6;
  for (const int row : {0, 1, 3})
    for (int c = 0; c < 4; ++c)
      if (!(std::abs(a[c][row] - b[c][row]) <= kRounding * std::abs(a[c][row]))) return false;
  return true;
}

/// The matrix from the batch's eye space to that of the view's first batch; none if it is of another view.
std::optional<glm::dmat4> viewFromEye(const Snapshot& first, const Snapshot& batch) {
  const glm::ivec4 &a = first.camera.viewport, &b = batch.camera.viewport;
  const bool layered = batch.layers && a.z == b.z && a.w == b.w;
  if (!(first.view == batch.view && a == b) && !layered) return {};
  if (haveSameLines(first.camera.clipFromEye, batch.camera.clipFromEye)) return glm::dmat4(1);
  return scene::eyeFromEye(first, batch);
}

/// The orthogonal polar factor, by Newton's iteration (Higham, "Computing the Polar Decomposition", 1986).
glm::dmat3 orthogonalPart(glm::dmat3 m) {
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i) m = 0.5 * (m + glm::inverse(glm::transpose(m)));
  return m;
}

bool keepsAngles(const glm::dmat3& m) {
  constexpr double kRounding = 1e-5;
  const glm::dmat3 squared = glm::transpose(m) * m;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(squared[c][r] - (c == r ? squared[0][0] : 0)) <= kRounding * squared[0][0]))
        return false;
  return true;
}

int64_t pixelsOf(const ViewBatches& view) {
  const glm::ivec4& viewport = view.front().snapshot->camera.viewport;
  return int64_t{viewport.z} * viewport.w;
}

}  // namespace

NearPlane::NearPlane(const scene::Camera& camera) {
  const glm::dmat4 eyeFromClip = glm::inverse(camera.clipFromEye);
  const double first = camera.firstNdcDepth();
  const auto at = [&](double x, double y) {
    const glm::dvec4 p = eyeFromClip * glm::dvec4(x, y, first, 1);
    return glm::dvec3(p) / p.w;
  };
  middle = at(0, 0), right = at(1, 0) - at(-1, 0), up = at(0, 1) - at(0, -1);
  const glm::dvec4 start = eyeFromClip * glm::dvec4(0, 0, first, 1), step = -first * eyeFromClip[2];
  away = (glm::dvec3(step) - middle * step.w) / start.w;
}

glm::dmat4 eyeFromWorldOf(const Snapshot& first) {
  const glm::dmat3 m(first.eyeFromWorld);
  const double volume = glm::determinant(m), side = NearPlane(first.camera).isMirrored() ? -1 : 1;
  if (volume == 0 || !std::isfinite(volume)) return glm::dmat4(1);
  if (keepsAngles(m) && volume * side > 0) return first.eyeFromWorld;
  glm::dmat4 world(std::cbrt(std::abs(volume)) * orthogonalPart(volume * side < 0 ? -m : m));
  world[3] = first.eyeFromWorld[3];
  return world;
}

std::vector<ViewBatches> sceneViewsOf(const std::vector<scene::SnapshotPtr>& batches) {
  std::vector<ViewBatches> views;
  for (const scene::SnapshotPtr& s : batches) {
    if (!s) continue;
    std::optional<glm::dmat4> matrix;
    const auto holds = [&](const ViewBatches& view) {
      matrix = viewFromEye(*view.front().snapshot, *s);
      return matrix.has_value();
    };
    const auto found = std::find_if(views.rbegin(), views.rend(), holds);
    if (found == views.rend())
      views.push_back({{s.get()}});
    else
      found->push_back({s.get(), *matrix});
  }
  std::stable_sort(views.begin(), views.end(),
                   [](const ViewBatches& a, const ViewBatches& b) { return pixelsOf(a) > pixelsOf(b); });
  return views;
}

}  // namespace gluray::saved
