#include "gl/batch/shown_views.h"

#include "gl/window/clears.h"

#include <algorithm>

namespace gluray::gl {
namespace {

bool contains(const glm::ivec4& outer, const glm::ivec4& inner) {
  return inner.x >= outer.x && inner.y >= outer.y &&
         int64_t{inner.x} + inner.z <= int64_t{outer.x} + outer.z &&
         int64_t{inner.y} + inner.w <= int64_t{outer.y} + outer.w;
}

bool isLit(const scene::Shading& s) {
  using Model = scene::FragmentShading::Model;
  return s.fragment.model == Model::off ? s.lighting : s.fragment.model != Model::unlit;
}

}  // namespace

bool ShownViews::mayStand(const BatchKey& key, uint64_t frame) const {
  return std::none_of(views_.begin(), views_.end(), [&](const View& v) {
    const bool same = v.frame == frame && v.framebuffer == key.framebuffer && v.drawBuffer == key.drawBuffer;
    return same && contains(v.viewport, key.viewport) && (v.hasGround || v.viewport != key.viewport);
  });
}

void ShownViews::traced(const BatchKey& key, const scene::Snapshot& s) {
  if (key.layers == BatchKey::Layers::peeled || key.layers == BatchKey::Layers::summed) return;
  std::erase_if(views_, [&](const View& v) { return v.frame != s.frame; });
  const bool ground = s.ground == scene::GroundUse::drawn;
  for (View& v : views_) {
    if (v.framebuffer != key.framebuffer || v.drawBuffer != key.drawBuffer || v.viewport != key.viewport)
      continue;
    v.hasGround |= ground;
    return;
  }
  views_.push_back({key.framebuffer, key.drawBuffer, key.viewport, s.frame, ground});
}

void ShownViews::colorCleared(GLuint framebuffer, const scene::Region& box) noexcept {
  std::erase_if(views_, [&](const View& v) {
    return v.framebuffer == framebuffer && contains({box.x, box.y, box.width, box.height}, v.viewport);
  });
}

bool holdsLitSurface(const scene::Snapshot& s) {
  return std::any_of(s.instances.begin(), s.instances.end(), [&](const scene::Instance& i) {
    return i.shading < s.shadings.size() && isLit(s.shadings[i.shading]);
  });
}

}  // namespace gluray::gl
