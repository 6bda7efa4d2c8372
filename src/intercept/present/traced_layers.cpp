#include "intercept/present/traced_layers.h"

#include "base/clock.h"
#include "gl/layers/peel_limits.h"
#include "intercept/present/layer_passes.h"
#include "intercept/present/result_of.h"

namespace gluray::present {

using gl::PresentResult;

namespace {

/// Whether an image has the shape of the target's textures.
bool fills(const Image& image, const gl::LayersTarget& target) {
  return image.x == 0 && image.y == 0 && image.width == target.size.x && image.height == target.size.y;
}

}  // namespace

PresentResult TracedLayers::present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                    const gl::LayersTarget& target, bool rasterise) noexcept {
  return resultOf([&] { return tracedOrRasterised(real, rasterise ? nullptr : snapshot.get(), target); });
}

PresentResult TracedLayers::trace(const scene::SnapshotPtr& snapshot,
                                  const gl::LayersTarget& target) noexcept {
  return resultOf([&] {
    PresentResult result;
    const frame::ImageCache::CachedImage* traced =
        shared_.imageOf(*snapshot, target.wish, 0u, result, result.why);
    if (!traced || !fills(traced->image, target)) return result;
    result.image = traced->image.color;
    result.outcome = PresentResult::traced;
    return result;
  });
}

bool TracedLayers::countPixels(const gl::RealGl& real, const gl::HeldPass& pass, GLuint texture,
                               glm::ivec2 size, uint64_t pixels) noexcept {
  try {
    return present::countPixels(real, shared_.features(real), pass, texture, size, pixels);
  } catch (const std::exception&) { return false; }
}

PresentResult TracedLayers::tracedOrRasterised(const gl::RealGl& real, const scene::Snapshot* snapshot,
                                               const gl::LayersTarget& target) {
  PresentResult result;
  const PendingErrors pending = takeErrors(real);
  const frame::ImageCache::CachedImage* traced =
      snapshot ? shared_.imageOf(*snapshot, target.wish, 0u, result, result.why) : nullptr;
  const double start = nowSeconds();
  const bool whole = traced && fills(traced->image, target);
  if (whole && !gl::showsAll(1, traced->image.layers, target.opaqueDepths.size()))
    result.layers = traced->image.layers;
  const bool waits = result.layers && target.mayAsk && gl::surelyWritten(*result.layers, 1) &&
                     (!target.written || clearResult(real, shared_.features(real), target));
  if (waits) result.image = traced->image.color;
  if (waits || (!target.image.empty() && showImage(real, shared_.features(real), target)))
    result.outcome = PresentResult::traced;
  else if (whole && !result.layers &&
           writeTexture(real, shared_.features(real), target.result, target.size, traced->image.color.data()))
    result.outcome = PresentResult::traced;
  else if (drawLayers(real, shared_.features(real), target))
    result.outcome = PresentResult::rasterised;
  takeErrors(real);
  if (!pending.empty()) result.pendingError = pending.front();
  result.presentSeconds = nowSeconds() - start;
  return result;
}

bool TracedLayers::readDepths(const gl::RealGl& real, GLint unit, glm::ivec2 size,
                              std::vector<glm::vec2>& out) noexcept {
  try {
    return present::readDepths(real, shared_.features(real), unit, size, out);
  } catch (const std::exception&) { return false; }
}

}  // namespace gluray::present
