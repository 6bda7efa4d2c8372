#include "intercept/present/tracing_presenter.h"

#include "base/clock.h"
#include "base/log.h"
#include "gl/state_queries.h"
#include "gl/texture_image.h"
#include "intercept/present/depth_again.h"
#include "intercept/present/layers.h"
#include "intercept/present/present_result.h"
#include "intercept/present/raster_fallback.h"

#include <exception>

namespace gluray::present {

using gl::PresentResult;

WriteBack& TracingPresenter::writeBack(const gl::RealGl& real, Image::Content content) {
  std::unique_ptr<WriteBack>& one = writeBacks_.at(static_cast<size_t>(content));
  if (!one) one = std::make_unique<WriteBack>(real, content);
  return *one;
}

gl::SharedNames TracingPresenter::takeNames() {
  gl::SharedNames all;
  for (const std::unique_ptr<WriteBack>& one : writeBacks_) {
    if (!one) continue;
    const gl::SharedNames names = one->takeNames();
    all.textures.insert(all.textures.end(), names.textures.begin(), names.textures.end());
    all.programs.insert(all.programs.end(), names.programs.begin(), names.programs.end());
  }
  return all;
}

bool TracingPresenter::supports(const gl::RealGl& real, bool, std::string& why) noexcept {
  try {
    return writeBack(real, Image::Content::color).ready(why);
  } catch (const std::exception& e) {
    why = e.what();
    return false;
  }
}

namespace {

void takeCost(const TraceCost& cost, PresentResult& result) {
  result.buildSeconds = cost.buildSeconds, result.traceSeconds = cost.traceSeconds;
  result.blasBuilds = cost.blasBuilds, result.blasRefinements = cost.blasRefinements;
  result.bvhBytes = cost.bvhBytes;
  result.blasRefining = cost.blasRefining;
}

}  // namespace

PresentResult TracingPresenter::present(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                        const gl::PresentTarget& target) noexcept {
  return resultOf([&] { return tracedOrRasterised(real, *snapshot, target); });
}

const LastPictures::Picture* TracingPresenter::pictureOf(const scene::Snapshot& snapshot, bool mayRepeat,
                                                         std::optional<uint32_t> missColor,
                                                         PresentResult& result, std::string& why) {
  const bool ahead = ahead_ && ahead_->has(snapshot);
  // What was built better takes twice the memory until something is traced.
  const bool repeats = mayRepeat && !ahead && !(tracer_.improves && tracer_.improves());
  if (const auto* known = repeats ? pictures_.of(snapshot, missColor) : nullptr) {
    result.repeated = true;
    return known;
  }
  LastPictures::Picture& fresh = pictures_.next();
  fresh.image.missColor = missColor.value_or(0);
  TraceCost cost;
  const bool done =
      ahead ? ahead_->take(fresh.image, cost, why) : tracer_.trace(snapshot, fresh.image, cost, why);
  takeCost(cost, result);
  if (!done) return nullptr;
  pictures_.keep(snapshot);
  return &fresh;
}

bool TracingPresenter::readPixels(const gl::RealGl& real, const scene::Region& region, GLenum format,
                                  GLenum type, void* out) noexcept {
  try {
    const Features& has = features(real);
    if (!has.readFramebuffers) return false;
    StateGuard guard(real, has);
    guard.plainPack();
    guard.readFrom(static_cast<GLuint>(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING)),
                   static_cast<GLenum>(gl::integer(real, GL_DRAW_BUFFER0)));
    real.ReadPixels(region.x, region.y, region.width, region.height, format, type, out);
    return takeErrors(real).empty();
  } catch (const std::exception&) { return false; }
}

namespace {

/// Makes room for a value a pixel. False where there is no memory.
template <class T>
bool makeRoom(const scene::Region& region, std::vector<T>& out) noexcept {
  try {
    out.resize(static_cast<size_t>(region.width) * static_cast<size_t>(region.height));
    return true;
  } catch (const std::exception&) { return false; }
}

}  // namespace

bool TracingPresenter::readDepth(const gl::RealGl& real, const scene::Region& region,
                                 std::vector<float>& out) noexcept {
  return makeRoom(region, out) && readPixels(real, region, GL_DEPTH_COMPONENT, GL_FLOAT, out.data());
}

bool TracingPresenter::readColors(const gl::RealGl& real, const scene::Region& region,
                                  std::vector<uint32_t>& out) noexcept {
  return makeRoom(region, out) && readPixels(real, region, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
}

PresentResult TracingPresenter::tracedOrRasterised(const gl::RealGl& real, const scene::Snapshot& snapshot,
                                                   const gl::PresentTarget& target) {
  PresentResult result;
  std::string why;
  PendingErrors pending;
  if (target.depthAgain) {
    pending = takeErrors(real);
    const bool drawn = target.byMatrix.mesh ? drawDepthAgain(real, features(real), snapshot, target.byMatrix)
                                            : drawDepthAgain(real, features(real), snapshot);
    if (drawn) result.outcome = PresentResult::rasterised;
    takeErrors(real);
    if (!pending.empty()) result.pendingError = pending.front();
    return result;
  }
  const LastPictures::Picture* traced = nullptr;
  if (!target.rasterise && supports(real, target.core, why)) {
    const std::optional<uint32_t> under =
        target.cleared ? clearedObject_.bits(real, features(real), *target.cleared, pending) : std::nullopt;
    traced = pictureOf(snapshot, target.mayRepeat, under, result, why);
  }
  const double start = nowSeconds();
  if (traced && written(real, *traced, snapshot, target, pending, why)) {
    result.outcome = PresentResult::traced;
    result.averages = !traced->image.center.empty();
  } else {
    result.why = why.empty() ? "the picture could not be written back" : std::move(why);
    const PendingErrors more = takeErrors(real);
    pending.insert(pending.end(), more.begin(), more.end());
    if (drawByRealGl(real, features(real), snapshot, target)) result.outcome = PresentResult::rasterised;
    takeErrors(real);
  }
  if (!pending.empty()) result.pendingError = pending.front();
  result.presentSeconds = nowSeconds() - start;
  if (result.outcome == PresentResult::traced && onWritten_) onWritten_(real, traced->image);
  return result;
}

PresentResult TracingPresenter::show(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                     const gl::ShowTarget& target) noexcept {
  return resultOf([&] {
    PresentResult result;
    PendingErrors pending;
    const std::optional<uint32_t> background =
        clearedWindow_.bits(real, features(real), target.cleared, pending);
    if (!pending.empty()) result.pendingError = pending.front();
    if (!background) return result;
    const LastPictures::Picture* traced =
        pictureOf(*snapshot, target.mayRepeat, background, result, result.why);
    if (!traced || traced->image.content != Image::Content::color || !traced->image.center.empty() ||
        traced->image.missColor != *background)
      return result;
    const double start = nowSeconds();
    if (target.show({traced->image, target.farthest, traced->id, snapshot->settings.threads}))
      result.outcome = PresentResult::traced;
    result.presentSeconds = nowSeconds() - start;
    return result;
  });
}

const Features& TracingPresenter::features(const gl::RealGl& real) {
  if (!features_) features_ = readFeatures(real);
  return *features_;
}

bool TracingPresenter::written(const gl::RealGl& real, const LastPictures::Picture& picture,
                               const scene::Snapshot& snapshot, const gl::PresentTarget& target,
                               PendingErrors& pending, std::string& why) noexcept {
  try {
    PendingErrors more;
    const bool sent =
        target.cleared && put_.put(real, features(real), picture.image, snapshot.settings.threads, more);
    pending.insert(pending.end(), more.begin(), more.end());
    if (sent) return noteUse(Quirk::softwarePut), true;
    WriteBackTarget into{.depthFunc = target.depthFunc,
                         .picture = picture.id,
                         .colorWrites = snapshot.colorWrites,
                         .encodes = snapshot.encodes};
    if (snapshot.layers && snapshot.layers->of == scene::Layers::Of::drawn) {  // the test is behind them
      into.depthFunc = GL_ALWAYS;
      into.depths = snapshot.layers->blending.writesDepth;
    }
    const bool drawn = writeBack(real, picture.image.content).write(picture.image, into, more);
    pending.insert(pending.end(), more.begin(), more.end());
    return drawn;
  } catch (const std::exception& e) {  // before anything is drawn: the guard puts the state back
    why = e.what();
    return false;
  }
}

bool TracingPresenter::antialias(const gl::RealGl& real, const scene::Fxaa& fxaa, GLint unit, GLuint target,
                                 const scene::Region& region, const Settings& settings) noexcept {
  if (!tracer_.antialias) return false;
  try {
    const auto pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    if (before_.size() < pixels) before_.resize(pixels), after_.resize(pixels);
    StateGuard guard(real, features(real));
    guard.plainPack();
    guard.plainUnpack();
    guard.activeTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    real.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, before_.data());
    if (!takeErrors(real).empty()) return false;
    if (!tracer_.antialias(settings, fxaa, before_.data(), region.width, region.height, after_.data()))
      return false;
    guard.texture2D(unit, target);
    if (!takeErrors(real).empty() ||
        !gl::holdsRgba8(real, {region.x + region.width, region.y + region.height}))
      return false;
    real.TexSubImage2D(GL_TEXTURE_2D, 0, region.x, region.y, region.width, region.height, GL_RGBA,
                       GL_UNSIGNED_BYTE, after_.data());
    return takeErrors(real).empty();
  } catch (const std::exception&) { return false; }
}

void TracingPresenter::forget(const gl::RealGl&) noexcept {
  // Names live in the share group; other contexts of the group may still be there, this one may not be
  // current.
  for (std::unique_ptr<WriteBack>& one : writeBacks_) one.reset();
  features_.reset();
}

}  // namespace gluray::present
