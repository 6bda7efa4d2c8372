// TracingPresenter: images of multisampled framebuffers, resolved without the real OpenGL.
#include "base/clock.h"
#include "intercept/present/layer_passes.h"
#include "intercept/present/tracing_presenter.h"

#include <exception>

namespace gluray::present {

using gl::PresentResult;

PresentResult TracingPresenter::resolve(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                        const gl::ResolveTarget& target) noexcept {
  try {
    return resolved(real, snapshot, target);
  } catch (const std::exception&) { return {}; }
}

PresentResult TracingPresenter::resolved(const gl::RealGl& real, const scene::SnapshotPtr& shared,
                                         const gl::ResolveTarget& target) {
  const scene::Snapshot& snapshot = *shared;
  PresentResult result;
  if (!shared_.tracer.resolve || !shared_.supported(real, result.why)) return result;
  const frame::ImageCache::CachedImage* traced =
      shared_.imageOf(snapshot, target.wish, {}, result, result.why);
  const Planes averages = Image::kColorDepth | Plane::centerDepth;  // through an open lens
  if (!traced || (traced->image.planes != Image::kColorDepth && !(traced->image.planes == averages)))
    return result;
  const double start = nowSeconds();
  scene::Resolve known = pixels_.how;
  if (!target.colors) known.gamma = target.how.gamma;  // gamma does not affect depths
  if (pixels_.of != traced->id || !(known == target.how)) {
    pixels_.of = 0;
    if (!shared_.tracer.resolve(snapshot.settings, target.how, traced->image, pixels_.image)) return result;
    pixels_.of = traced->id, pixels_.how = target.how;
  }
  PendingErrors pending = takeErrors(real);
  bool done = true;
  if (target.colors && target.texture)
    done = writeTexture(real, shared_.features(real), target.texture, target.how.size,
                        pixels_.image.color.data());
  const WriteBackTarget to{
      .depthFunc = GL_ALWAYS, .colors = target.colors && !target.texture, .depths = target.depths};
  PendingErrors more;
  if (done && (to.colors || to.depths))
    done = shared_.writeBack(real, WriteBack::Colors::bytes).write(pixels_.image, to, more);
  takeErrors(real);
  pending.insert(pending.end(), more.begin(), more.end());
  if (!pending.empty()) result.pendingError = pending.front();
  if (done) result.outcome = PresentResult::traced;
  if (done && target.colors) shared_.images.frame().wrote(shared, *traced, pixels_.image, &target.how);
  result.presentSeconds = nowSeconds() - start;
  if (done && target.colors && shared_.written) shared_.written(real, pixels_.image);
  return result;
}

}  // namespace gluray::present
