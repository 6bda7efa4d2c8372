#include "gl/views/shown_views.h"

#include "gl/batch/clears.h"
#include "scene/effects.h"

#include <algorithm>

namespace gluray::gl {
namespace {

bool contains(const glm::ivec4& outer, const glm::ivec4& inner) {
  return inner.x >= outer.x && inner.y >= outer.y &&
         int64_t{inner.x} + inner.z <= int64_t{outer.x} + outer.z &&
         int64_t{inner.y} + inner.w <= int64_t{outer.y} + outer.w;
}

}  // namespace

bool ShownViews::mayStand(const BatchKey& key, uint64_t frame) const {
  return std::none_of(views_.begin(), views_.end(), [&](const View& v) {
    const bool same = v.frame == frame && v.framebuffer == key.framebuffer && v.drawBuffer == key.drawBuffer;
    return same && contains(v.viewport, key.viewport) && (v.hasGround || v.viewport != key.viewport);
  });
}

bool ShownViews::isInset(const BatchKey& key, uint64_t frame) const {
  const auto area = [](const glm::ivec4& v) { return int64_t{v.z} * v.w; };
  return std::any_of(views_.begin(), views_.end(), [&](const View& v) {
    const bool same = v.frame == frame && v.framebuffer == key.framebuffer && v.drawBuffer == key.drawBuffer;
    return same && contains(v.viewport, key.viewport) && 4 * area(key.viewport) <= area(v.viewport);
  });
}

std::optional<ShownViews::Clear> ShownViews::mayPaint(const BatchKey& key, const scene::Region& region,
                                                      uint64_t frame) const {
  const bool painted = std::any_of(views_.begin(), views_.end(), [&](const View& v) {
    const bool same = v.frame == frame && v.framebuffer == key.framebuffer && v.drawBuffer == key.drawBuffer;
    return same && contains(v.viewport, key.viewport) && v.hasBackdrop;
  });
  if (painted) return std::nullopt;
  for (auto c = clears_.rbegin(); c != clears_.rend(); ++c)
    if (c->framebuffer == key.framebuffer && gl::contains(c->box, region)) return *c;
  return std::nullopt;
}

void ShownViews::traced(const BatchKey& key, const scene::Snapshot& s) {
  if (key.layers == BatchKey::Layers::peeled || key.layers == BatchKey::Layers::summed) return;
  std::erase_if(views_, [&](const View& v) { return v.frame != s.frame; });
  const bool ground = s.ground == scene::GroundUse::drawn, backdrop = s.backdrop != nullptr;
  for (View& v : views_) {
    if (v.framebuffer != key.framebuffer || v.drawBuffer != key.drawBuffer || v.viewport != key.viewport)
      continue;
    v.hasGround |= ground, v.hasBackdrop |= backdrop;
    return;
  }
  views_.push_back({key.framebuffer, key.drawBuffer, key.viewport, s.frame, ground, backdrop});
}

void ShownViews::colorCleared(const Clear& clear) {
  const scene::Region& box = clear.box;
  constexpr size_t kMaxClears = 64;  // of framebuffers and views that come and go
  std::erase_if(views_, [&](const View& v) {
    return v.framebuffer == clear.framebuffer && contains({box.x, box.y, box.width, box.height}, v.viewport);
  });
  std::erase_if(clears_, [&](const Clear& c) {
    return c.framebuffer == clear.framebuffer && gl::contains(box, c.box);
  });
  if (clears_.size() >= kMaxClears) clears_.erase(clears_.begin());
  clears_.push_back(clear);
}

bool wantsShownViews(const Settings& settings) {
  return scene::wantsGround(settings) || scene::wantsBackdrop(settings) ||
         (scene::changesLight(settings) && !settings.lights.insets);
}

bool holdsLitSurface(const scene::Snapshot& s) {
  return std::any_of(s.instances.begin(), s.instances.end(), [&](const scene::Instance& i) {
    return i.shading < s.shadings.size() && isLit(s.shadings[i.shading]);
  });
}

}  // namespace gluray::gl
