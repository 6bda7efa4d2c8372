#include "gl/layers/drawn_layers.h"

#include "gl/basics/affine.h"
#include "gl/real/errors.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace gluray::gl {
namespace {

/// The pixels of the snapshot's region that the bounds of the instance's mesh may cover.
scene::Region reachedBy(const scene::Snapshot& s, const scene::Instance& instance) {
  if (instance.mesh->shape != scene::Shape::triangles) return s.region;  // bounds are those of the centres
  glm::dvec2 lower(INFINITY), upper(-INFINITY);
  for (const glm::dvec4& clip : boundsInClip(*instance.mesh, s.camera.clipFromEye * instance.eyeFromObject)) {
    if (!(clip.w > 0)) return s.region;  // behind the viewer
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    lower = glm::min(lower, ndc), upper = glm::max(upper, ndc);
  }
  const glm::dvec2 origin(s.camera.viewport.x, s.camera.viewport.y),
      size(s.camera.viewport.z, s.camera.viewport.w);
  const auto window = [&](const glm::dvec2& ndc) { return origin + (ndc * 0.5 + 0.5) * size; };
  constexpr double kRounding = 1;  // pixels
  const glm::dvec2 first(s.region.x, s.region.y), last = first + glm::dvec2(s.region.width, s.region.height);
  const glm::dvec2 from = glm::clamp(glm::floor(window(lower)) - kRounding, first, last),
                   to = glm::clamp(glm::ceil(window(upper)) + kRounding, first, last);
  if (!(from.x < to.x && from.y < to.y)) return {};
  return {static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(to.x - from.x),
          static_cast<int>(to.y - from.y)};
}

}  // namespace

bool DrawnLayers::mayBeDrawn() const {
  return p_.shadow.raster().layers.has_value() && p_.shadow.target().blendable;
}

void DrawnLayers::describe(BatchKey& key, BatchKey::DrawnBy drawnBy) const {
  key.layers = BatchKey::Layers::drawn;
  key.drawnBy = drawnBy;
  key.blending = *p_.shadow.raster().layers;
  key.blending.hasAlpha = p_.shadow.target().alpha;
  key.depthSteps = p_.shadow.target().depthSteps;
}

bool DrawnLayers::leaves(uint64_t triangles) {
  if (frame_ != p_.clock.frame) {
    frame_ = p_.clock.frame;
    lastDrawn_ = std::exchange(drawn_, {});
  }
  drawn_.triangles += triangles;
  const uint64_t number = p_.counts.statistics.drawsTraced + p_.counts.statistics.drawsRasterised;
  const scene::Blending& blending = *p_.shadow.raster().layers;
  if (drawn_.runs == 0 || number != drawnLast_ + 1 || !(blending == drawnBy_)) ++drawn_.runs;
  drawnLast_ = number, drawnBy_ = blending;
  return p_.clock.leavesLayers(
      std::max(triangles, lastDrawn_.triangles / std::max<uint64_t>(lastDrawn_.runs, 1)),
      p_.shadow.viewportPixels());
}

bool DrawnLayers::readUnder() {
  p_.shadow.errors.keepPending();
  const scene::Snapshot& waiting = p_.pending.batch.waiting();
  scene::Region region;
  for (const scene::Instance& instance : waiting.instances)
    region = scene::united(region, reachedBy(waiting, instance));
  if (region.width <= 0) region = {waiting.region.x, waiting.region.y, 1, 1};  // none of them is visible
  auto layers = std::make_shared<scene::Layers>(*waiting.layers);
  FramebufferReader& reader = p_.pending.presenter.reader();
  if (!reader.readDepth(p_.shadow.real, region, layers->opaqueDepth) ||
      !(waiting.wideColors ? reader.readFloatColors(p_.shadow.real, region, layers->floatColors)
                           : reader.readColors(p_.shadow.real, region, layers->colors)))
    return false;
  p_.pending.batch.seeThrough(std::move(layers), region);
  return true;
}

}  // namespace gluray::gl
