// TracingPresenter: images whose view turned out to hold other surfaces than they were lit with.
#include "base/clock.h"
#include "gl/real/buffer_bits.h"
#include "gl/real/state_queries.h"
#include "intercept/present/result_of.h"
#include "intercept/present/tracing_presenter.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace gluray::present {

using gl::PresentResult;

PresentResult TracingPresenter::relight(const gl::RealGl& real, const scene::SnapshotPtr& before,
                                        const scene::SnapshotPtr& now,
                                        const gl::RelightTarget& target) noexcept {
  return resultOf([&] { return relit(real, before, now, target); });
}

/// Reads what the bound draw framebuffer shows where the image was written. No error may be pending.
bool TracingPresenter::readShown(const gl::RealGl& real, const Image& written, bool layers,
                                 scene::ShownPixels& shown) {
  const scene::Region region{written.x, written.y, written.width, written.height};
  // Of several samples the depth test compares each with its own.
  if (written.samples > 1) return reader_.readResolved(real, region, shown.colors);
  if (layers) return reader_.readColors(real, region, shown.colors);  // they need not write depths
  const int bits = std::clamp(gl::depthBits(real, shared_.features(real).compatibility), 1, 24);
  shown.depthStep = std::ldexp(2.0f, -bits);
  return reader_.readColors(real, region, shown.colors) && reader_.readDepth(real, region, shown.depths);
}

PresentResult TracingPresenter::relit(const gl::RealGl& real, const scene::SnapshotPtr& before,
                                      const scene::SnapshotPtr& now, const gl::RelightTarget& target) {
  PresentResult result;
  // Other processes wait for this image once.
  const bool alone = !shared_.tracer.standsAlone || shared_.tracer.standsAlone(*now);
  if (!alone || !shared_.supported(real, result.why)) return result;
  const PendingErrors pending = takeErrors(real);
  if (!pending.empty()) result.pendingError = pending.front();
  scene::ShownPixels shown;
  if (!readShown(real, target.written, now->layers != nullptr, shown)) return takeErrors(real), result;
  const frame::ImageCache::CachedImage* const traced =
      shared_.imageOf(*now, target.wish, {}, result, result.why);
  if (!traced) return result;
  const double start = nowSeconds();
  auto written = std::make_shared<const Image>(scene::writtenPart(traced->image));
  const scene::LaterImages later{target.later, now->camera.largestWins};
  if (scene::findReplaced(target.written, *written, shown, replaced_, later) > 0) {
    WriteBackTarget into{.depthFunc = GL_EQUAL,
                         .depths = target.written.samples > 1,
                         .colorWrites = now->colorWrites,
                         .encodes = now->encodes};
    PendingErrors none;
    if (!shared_.writeBack(real, WriteBack::Colors::bytes).write(replaced_, into, none)) return result;
    if (shared_.written) shared_.written(real, replaced_);
  }
  shared_.images.frame().replaces(*before);
  shared_.images.frame().wrote(now, *traced, traced->image);
  result.outcome = PresentResult::traced;
  result.written = std::move(written);
  result.presentSeconds = nowSeconds() - start;
  return result;
}

}  // namespace gluray::present
