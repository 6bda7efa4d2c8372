#include "render/frame_data/backdrop_look.h"

#include "render/lights/make_environment.h"
#include "scene/srgb.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::render {
namespace {

/// A colour as people choose it on screens, as the framebuffer takes it.
glm::vec3 asWritten(const glm::vec3& color, bool encodes) {
  return encodes ? glm::vec3(scene::decodedSrgb(color.r), scene::decodedSrgb(color.g),
                             scene::decodedSrgb(color.b))
                 : color;
}

}  // namespace

BackdropLook::BackdropLook(const scene::Snapshot& s, const RaySetup& eyeRays)
    : isClear_(s.backdrop->isClear), width_(static_cast<size_t>(s.region.width)), rays_(eyeRays) {
  const size_t pixels = width_ * static_cast<size_t>(s.region.height);
  if (!isClear_.empty() && isClear_.size() != pixels)
    throw std::runtime_error("a backdrop needs to know of each pixel");
  const auto& background = s.settings.background;
  if (background.kind == BackgroundKind::environment) {
    environment_ = makeEnvironment(s.settings, s.eyeFromWorld);
    tone_ = makeToneMap(s);
    return;
  }
  top_ = bottom_ = asWritten(background.color, s.encodes);
  if (background.kind == BackgroundKind::gradient) bottom_ = asWritten(background.bottom, s.encodes);
  base_ = static_cast<float>(s.camera.viewport.y);
  height_ = static_cast<float>(std::max(s.camera.viewport.w, 1));
}

void BackdropLook::expose(const scene::Snapshot& s, float factor) {
  if (environment_) tone_ = makeToneMap(s, factor);
}

glm::vec3 BackdropLook::at(float x, float y) const noexcept {
  if (environment_) return environmentAt(x, y);
  return glm::mix(bottom_, top_, std::clamp((y - base_) / height_, 0.0f, 1.0f));
}

glm::vec3 BackdropLook::environmentAt(float x, float y) const noexcept {
  const glm::dvec4 start = rays_.start + double{x} * rays_.startX + double{y} * rays_.startY;
  const glm::dvec3 way = (glm::dvec3(rays_.step) - glm::dvec3(start) / start.w * rays_.step.w) / start.w;
  const double size = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
  if (!(size > 0) || !std::isfinite(size)) return glm::vec3(0);
  glm::vec3 color = environment_->radiance(glm::vec3(glm::normalize(way / size)));
  if (!tone_) return color;
  ColorRows rows{};
  for (int c = 0; c < 3; ++c) rows.value[c][0] = color[c];
  tone_->apply(rows);
  return {rows.value[0][0], rows.value[1][0], rows.value[2][0]};
}

}  // namespace gluray::render
