#include "intercept/present/tracing_presenter.h"

#include "base/clock.h"
#include "base/log.h"
#include "gl/real/state_queries.h"
#include "gl/textures/texture_image.h"
#include "intercept/present/layer_passes.h"
#include "intercept/present/raster/depth_redraw.h"
#include "intercept/present/raster/raster_fallback.h"
#include "intercept/present/result_of.h"
#include "intercept/present/write_back/seen_catchers.h"
#include "scene/catcher_offset.h"
#include "scene/secondary_scene.h"

#include <exception>

namespace gluray::present {

using gl::PresentResult;

namespace {

/// Null: out of memory; then the image keeps its light.
std::shared_ptr<const Image> keepWritten(const Image& image) noexcept {
  try {
    auto part = std::make_shared<const Image>(scene::writtenPart(image));
    return part->color.empty() ? nullptr : std::move(part);
  } catch (const std::exception&) { return nullptr; }
}

}  // namespace

PresentResult TracingPresenter::present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                        const gl::PresentTarget& target) noexcept {
  return resultOf([&] { return tracedOrRasterised(real, snapshot, target); });
}

PresentResult TracingPresenter::tracedOrRasterised(const gl::RealGl& real, const scene::SnapshotPtr& shared,
                                                   const gl::PresentTarget& target) {
  PresentResult result;
  std::string why;
  PendingErrors pending;
  const scene::SnapshotPtr known =
      shared->catches && !target.rasterise ? withDepths(real, shared, pending) : shared;
  const scene::Snapshot& snapshot = *known;
  if (target.depthAgain) {
    pending = takeErrors(real);
    const bool drawn = target.byMatrix.mesh
                           ? drawDepthAgain(real, shared_.features(real), snapshot, target.byMatrix)
                           : drawDepthAgain(real, shared_.features(real), snapshot);
    if (drawn) result.outcome = PresentResult::rasterised;
    takeErrors(real);
    if (!pending.empty()) result.pendingError = pending.front();
    return result;
  }
  const frame::ImageCache::CachedImage* traced = nullptr;
  if (!target.rasterise && shared_.supported(real, why)) {
    const std::optional<uint32_t> under =
        target.cleared ? clearedObject_.bits(real, shared_.features(real), *target.cleared, pending)
                       : std::nullopt;
    traced = shared_.imageOf(snapshot, target.wish, under, result, why);
  }
  const double start = nowSeconds();
  const Way way = traced ? write(real, *traced, snapshot, target, pending, why) : Way::none;
  if (way != Way::none) {
    result.outcome = PresentResult::traced;
    result.uploaded = way == Way::uploaded;
    result.averages = traced->image.isAverages();
    if (!snapshot.catches) shared_.images.frame().wrote(shared, *traced, traced->image);
    if (target.keepsPixels) result.written = keepWritten(traced->image);
  } else {
    result.why = why.empty() ? "the image could not be written back" : std::move(why);
    const PendingErrors more = takeErrors(real);
    pending.insert(pending.end(), more.begin(), more.end());
    // What takes only light stands in the framebuffer already.
    if (snapshot.catches || drawByRealGl(real, shared_.features(real), snapshot, target))
      result.outcome = PresentResult::rasterised;
    takeErrors(real);
  }
  if (!pending.empty()) result.pendingError = pending.front();
  result.presentSeconds = nowSeconds() - start;
  if (result.outcome == PresentResult::traced && !snapshot.catches && shared_.written)
    shared_.written(real, traced->image);
  return result;
}

/// The snapshot with the framebuffer's depths, or itself where they cannot be read.
scene::SnapshotPtr TracingPresenter::withDepths(const gl::RealGl& real, const scene::SnapshotPtr& catchers,
                                                PendingErrors& pending) {
  const scene::Snapshot& s = *catchers;
  pending = takeErrors(real);
  const std::shared_ptr<scene::FramebufferCapture> capture = depths_.takeCapture();
  if (!reader_.readDepth(real, s.region, capture->depths)) return catchers;
  capture->viewport = s.camera.viewport, capture->region = s.region;
  capture->depthNear = s.camera.depthNear, capture->depthFar = s.camera.depthFar;
  capture->offset.factor = s.polygonOffset.factor - scene::kCatcherSlope;  // the program's own
  capture->offset.units = s.polygonOffset.units - scene::kCatcherUnits;
  auto known = std::make_shared<scene::Snapshot>(s);
  auto around = s.secondaryScene ? std::make_shared<scene::SecondaryScene>(*s.secondaryScene)
                                 : std::make_shared<scene::SecondaryScene>();
  around->framebuffer = capture;
  known->secondaryScene = std::move(around);
  return known;
}

TracingPresenter::Way TracingPresenter::write(const gl::RealGl& real,
                                              const frame::ImageCache::CachedImage& cached,
                                              const scene::Snapshot& snapshot,
                                              const gl::PresentTarget& target, PendingErrors& pending,
                                              std::string& why) noexcept {
  try {
    PendingErrors more;
    const bool sent = target.cleared &&
                      put_.put(real, shared_.features(real), cached.image, snapshot.settings.threads, more);
    pending.insert(pending.end(), more.begin(), more.end());
    if (sent) return noteUse(Quirk::softwarePut), Way::uploaded;
    WriteBackTarget into{.depthFunc = target.depthFunc,
                         .imageId = cached.id,
                         .keepsDepth = snapshot.catches,
                         .colorWrites = snapshot.colorWrites,
                         .encodes = snapshot.encodes};
    if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::drawn) {  // depth was tested in tracing
      into.depthFunc = GL_ALWAYS;
      into.depths = snapshot.layers->blending.writesDepth;
    }
    const bool hides = snapshot.catches && snapshot.secondaryScene && snapshot.secondaryScene->framebuffer;
    const bool drawn =
        hides ? writeSeen(real, cached.image, snapshot, into, more)
              : shared_.writeBack(real, WriteBack::colorsOf(cached.image)).write(cached.image, into, more);
    pending.insert(pending.end(), more.begin(), more.end());
    return drawn ? Way::drawn : Way::none;
  } catch (const std::exception& e) {  // nothing was drawn yet, and the guard restores the state
    why = e.what();
    return Way::none;
  }
}

/// Blends light fractions over the pixels whose depths are known to be theirs.
bool TracingPresenter::writeSeen(const gl::RealGl& real, const Image& image, const scene::Snapshot& snapshot,
                                 WriteBackTarget into, PendingErrors& pending) {
  const std::vector<float>& depths = snapshot.secondaryScene->framebuffer->depths;
  into.imageId = 0;
  if (image.has(Plane::color) && image.samples == 1 && into.depthFunc == GL_LEQUAL) {
    findTakenLight(image, snapshot, depths, taken_);
    WriteBack& blend = shared_.writeBack(real, WriteBack::Colors::taken);
    if (blend.writeTaken(taken_, into, pending)) return true;
  }
  PendingErrors more;
  findSeenCatchers(image, snapshot, depths, seen_);
  const bool drawn = shared_.writeBack(real, WriteBack::colorsOf(seen_)).write(seen_, into, more);
  pending.insert(pending.end(), more.begin(), more.end());
  return drawn;
}

bool TracingPresenter::antialias(const gl::RealGl& real, const scene::Fxaa& fxaa, GLint unit, GLuint target,
                                 const scene::Region& region, const Settings& settings) noexcept {
  if (!shared_.tracer.antialias) return false;
  try {
    const auto pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    if (before_.size() < pixels) before_.resize(pixels), after_.resize(pixels);
    StateGuard guard(real, shared_.features(real));
    guard.plainPack();
    guard.plainUnpack();
    guard.activeTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    real.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, before_.data());
    if (!takeErrors(real).empty()) return false;
    if (!shared_.tracer.antialias(settings, fxaa, before_.data(), region.width, region.height, after_.data()))
      return false;
    guard.texture2D(unit, target);
    if (!takeErrors(real).empty() ||
        !gl::holdsRgba8(real, {region.x + region.width, region.y + region.height}) ||
        makesMipmaps(real, shared_.features(real)))
      return false;
    real.TexSubImage2D(GL_TEXTURE_2D, 0, region.x, region.y, region.width, region.height, GL_RGBA,
                       GL_UNSIGNED_BYTE, after_.data());
    if (!takeErrors(real).empty()) return false;
    shared_.images.frame().antialiased(fxaa, region, before_.data(), settings);
    return true;
  } catch (const std::exception&) { return false; }
}

}  // namespace gluray::present
