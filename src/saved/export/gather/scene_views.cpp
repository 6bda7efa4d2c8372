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

int64_t pixelsOf(const ViewBatches& view) {
  const glm::ivec4& viewport = view.front().snapshot->camera.viewport;
  return int64_t{viewport.z} * viewport.w;
}

}  // namespace

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
