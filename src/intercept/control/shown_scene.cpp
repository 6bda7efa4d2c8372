#include "intercept/control/shown_scene.h"

#include "frame/questions/pick.h"
#include "gl/batch/same_camera.h"

#include <algorithm>
#include <stdexcept>

namespace gluray::intercept {
namespace {

std::optional<glm::dmat4> eyeFromEye(const scene::Snapshot& to, const scene::Snapshot& from) {
  const double distance =
      std::max(glm::length(glm::dvec3(to.eyeFromWorld[3])), glm::length(glm::dvec3(from.eyeFromWorld[3])));
  return gl::eyeFromEye(to.camera.clipFromEye, from.camera.clipFromEye, distance);
}

bool shows(const ShownView& view, const gl::ShownBatch& batch) {
  const gl::ShownBatch& first = *view.batches.front();
  const glm::ivec4 &a = first.snapshot->camera.viewport, &b = batch.snapshot->camera.viewport;
  const bool alike = first.framebuffer == batch.framebuffer ? a == b : a.z == b.z && a.w == b.w;
  return alike && eyeFromEye(*first.snapshot, *batch.snapshot);
}

bool isIn(const glm::ivec4& viewport, const glm::dvec2& at) {
  return at.x >= viewport.x && at.y >= viewport.y && at.x < viewport.x + viewport.z &&
         at.y < viewport.y + viewport.w;
}

/// Framebuffer objects are shown somewhere; where, is known only if they are as large as the window.
bool isPlaced(const std::vector<ShownView>& views, const gl::ShownBatch& batch, const glm::ivec2& size) {
  if (batch.framebuffer == 0 || size == glm::ivec2(0)) return true;
  glm::ivec2 extent(0);
  for (const ShownView& view : views)
    for (const gl::ShownBatch* other : view.batches) {
      if (other->framebuffer != batch.framebuffer) continue;
      const glm::ivec4& v = other->snapshot->camera.viewport;
      extent = glm::max(extent, glm::ivec2(v.x + v.z, v.y + v.w));
    }
  return extent == size;
}

}  // namespace

glm::dmat4 ShownView::viewFromWorld(const scene::Snapshot& batch) const {
  const auto eye = eyeFromEye(first(), batch);
  return glm::inverse(first().eyeFromWorld) * eye.value_or(glm::dmat4(1)) * batch.eyeFromWorld;
}

std::vector<ShownView> viewsOf(const gl::ShownFrame& frame) {
  std::vector<ShownView> views;
  for (const gl::ShownBatch& batch : frame.batches) {
    if (batch.snapshot->instances.empty()) continue;
    const auto found =
        std::find_if(views.begin(), views.end(), [&](const ShownView& view) { return shows(view, batch); });
    (found == views.end() ? views.emplace_back() : *found).batches.push_back(&batch);
  }
  return views;
}

glm::ivec2 extentOf(const std::vector<ShownView>& views) {
  glm::ivec2 extent(0);
  for (const ShownView& view : views) {
    const glm::ivec4& v = view.first().camera.viewport;
    extent = glm::max(extent, glm::ivec2(v.x + v.z, v.y + v.w));
  }
  return extent;
}

std::optional<ShownPoint> pointAt(const std::vector<ShownView>& views, const glm::dvec2& at,
                                  const glm::ivec2& size) {
  bool placed = views.empty();
  for (size_t v = views.size(); v-- > 0;) {
    std::optional<ShownPoint> nearest;
    float depth = 2;
    for (const gl::ShownBatch* batch : views[v].batches) {
      if (!isPlaced(views, *batch, size)) continue;
      placed = true;
      const scene::Snapshot& s = *batch->snapshot;
      if (!isIn(s.camera.viewport, at)) continue;
      const auto picked = frame::pick(frame::Renderer::shared(), s, at);
      if (!picked || picked->depth >= depth) continue;
      depth = picked->depth;
      nearest = {v, &s, &s.instances[picked->instance], picked->point, picked->normal};
    }
    if (nearest) return nearest;
  }
  if (!placed)
    throw std::runtime_error(
        "the program draws its view aside, and GLuRay does not know where its window shows it");
  return std::nullopt;
}

}  // namespace gluray::intercept
