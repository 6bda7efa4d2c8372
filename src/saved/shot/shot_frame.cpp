#include "saved/shot/shot_frame.h"

#include <algorithm>
#include <cmath>

namespace gluray::saved {
namespace {

using scene::Region;

Region rounded(const glm::dvec2& low, const glm::dvec2& high) {
  const glm::ivec2 from(glm::round(low)), to(glm::round(high)), size = glm::max(to - from, glm::ivec2(1));
  return {from.x, from.y, size.x, size.y};
}

/// Sizes in normalised device coordinates and pixels follow a change of the projection and of the scale.
void resize(scene::Impostors& i, const glm::vec2& share, double scale) {
  i.size *= share;
  i.lowpass *= glm::vec3(share.x * share.x, share.x * share.y, share.y * share.y);
  i.longer *= static_cast<float>(scale);
}

}  // namespace

Region common(const Region& a, const Region& b) {
  const int left = std::max(a.x, b.x), bottom = std::max(a.y, b.y);
  const int right = std::min(a.x + a.width, b.x + b.width), top = std::min(a.y + a.height, b.y + b.height);
  return {left, bottom, std::max(0, right - left), std::max(0, top - bottom)};
}

ShotFrame::ShotFrame(glm::ivec2 window, glm::ivec2 size, Fit fit)
    : window_(window), size_(size), scale_(glm::dvec2(size) / glm::dvec2(window)) {
  if (fit == Fit::all) scale_ = glm::dvec2(std::min(scale_.x, scale_.y));
  if (fit == Fit::crop) scale_ = glm::dvec2(std::max(scale_.x, scale_.y));
  corner_ = (glm::dvec2(size) - scale_ * glm::dvec2(window)) / 2.0;
}

scene::Snapshot ShotFrame::placed(const SavedBatch& batch) const {
  scene::Snapshot s = *batch.snapshot;
  s.lightSampling = {};
  const glm::ivec4 v = s.camera.viewport;
  const glm::ivec2 low = glm::ivec2(v.x, v.y) + batch.place, high = low + glm::ivec2(v.z, v.w);
  if (isWindow()) {
    s.camera.viewport = {low, v.z, v.w};
    s.region.x += batch.place.x, s.region.y += batch.place.y;
    return s;
  }
  const bool fills = low == glm::ivec2(0) && high == window_;
  const glm::dvec2 from = pictureOf(glm::dvec2(low)), to = pictureOf(glm::dvec2(high));
  const Region viewport = fills ? Region{0, 0, size_.x, size_.y} : rounded(from, to);
  const glm::dvec2 share = fills ? (to - from) / glm::dvec2(size_) : glm::dvec2(1);
  s.camera.clipFromEye =
      glm::dmat4(share.x, 0, 0, 0, 0, share.y, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * s.camera.clipFromEye;
  s.camera.viewport = {viewport.x, viewport.y, viewport.width, viewport.height};
  if (s.camera.rowsFromTop != 0) s.camera.rowsFromTop = viewport.y + viewport.height;
  // A region that fills its viewport still does.
  const Region& r = s.region;
  const bool whole = r.x == v.x && r.y == v.y && r.width == v.z && r.height == v.w;
  const glm::ivec2 corner = glm::ivec2(r.x, r.y) + batch.place;
  const Region region =
      rounded(pictureOf(glm::dvec2(corner)), pictureOf(glm::dvec2(corner + glm::ivec2(r.width, r.height))));
  s.region = whole ? viewport : common(region, viewport);
  s.settings.spp = std::max(s.settings.spp, s.samples);
  s.samples = 1, s.samplePositions.clear();
  for (scene::Instance& instance : s.instances) resize(instance.impostors, glm::vec2(share), scale_.y);
  for (scene::Shading& shading : s.shadings)
    if (shading.fragment.edges) shading.fragment.edgeWidth *= static_cast<float>(scale_.y);
  return s;
}

}  // namespace gluray::saved
