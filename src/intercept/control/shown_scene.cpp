#include "intercept/control/shown_scene.h"

#include "frame/questions/pick.h"
#include "intercept/tracing/shared_renderer.h"
#include "scene/same_camera.h"

#include <algorithm>
#include <stdexcept>

namespace gluray::intercept {
namespace {

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

}  // namespace

glm::ivec2 extentOf(const std::vector<ShownView>& views, uint32_t framebuffer) {
  glm::ivec2 extent(0);
  for (const ShownView& view : views)
    for (const gl::ShownBatch* batch : view.batches) {
      const glm::ivec4& v = batch->snapshot->camera.viewport;
      if (batch->framebuffer == framebuffer) extent = glm::max(extent, glm::ivec2(v.x + v.z, v.y + v.w));
    }
  return extent;
}

std::optional<glm::ivec2> placeOf(const std::vector<ShownView>& views, uint32_t framebuffer,
                                  const ShownWindowPlaces& window) {
  if (framebuffer == 0 || window.size == glm::ivec2(0)) return glm::ivec2(0);
  const glm::ivec2 extent = extentOf(views, framebuffer);
  if (extent == window.size) return glm::ivec2(0);
  std::optional<glm::ivec2> found;
  for (const glm::ivec4& place : window.places) {
    if (glm::ivec2(place.z, place.w) != extent) continue;
    if (found && *found != glm::ivec2(place.x, place.y)) return std::nullopt;
    found = glm::ivec2(place.x, place.y);
  }
  return found;
}

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

std::optional<ShownPoint> pointAt(const std::vector<ShownView>& views, const glm::dvec2& position,
                                  const ShownWindowPlaces& window) {
  bool placed = views.empty();
  for (size_t v = views.size(); v-- > 0;) {
    std::optional<ShownPoint> nearest;
    float depth = 2;
    for (const gl::ShownBatch* batch : views[v].batches) {
      const auto place = placeOf(views, batch->framebuffer, window);
      if (!place) continue;
      placed = true;
      const glm::dvec2 at = position - glm::dvec2(*place);
      const scene::Snapshot& s = *batch->snapshot;
      if (!isIn(s.camera.viewport, at)) continue;
      const auto picked = frame::pick(sharedRenderer(), s, at);
      if (!picked || picked->depth >= depth) continue;
      depth = picked->depth;
      const glm::ivec4& viewport = s.camera.viewport;
      const glm::dvec2 share = (at - glm::dvec2(viewport.x, viewport.y)) / glm::dvec2(viewport.z, viewport.w);
      nearest = {v, &s, &s.instances[picked->instance], picked->point, picked->normal, share};
    }
    if (nearest) return nearest;
  }
  if (!placed)
    throw std::runtime_error(
        "the program draws its view aside, and GLuRay does not know where its window shows it");
  return std::nullopt;
}

}  // namespace gluray::intercept
