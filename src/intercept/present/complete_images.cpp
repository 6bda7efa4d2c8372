#include "intercept/present/complete_images.h"

#include "intercept/present/layer_passes.h"
#include "intercept/present/result_of.h"
#include "intercept/present/state/state_guard.h"

#include <exception>

namespace gluray::present {
namespace {

constexpr int kMaxUnshown = 4;   // from then on the program is taken not to draw composed images here ...
constexpr int kTrialEvery = 16;  // ... but for a trial every so many images

/// Of complete images: nobody hears of them, and each shows what is left out elsewhere.
frame::Tracer completeTracer(const frame::Tracer& tracer) {
  frame::Tracer complete;
  complete.trace = tracer.scenery.trace;
  complete.improves = tracer.improves;
  complete.standsAlone = tracer.standsAlone;
  return complete;
}

}  // namespace

CompleteImages::CompleteImages(const frame::Tracer& tracer, PresentedImages& shared)
    : tracer_(tracer), images_(completeTracer(tracer)), shared_(shared) {}

frame::Tracer CompleteImages::tracer() {
  frame::Tracer tracer = tracer_;
  if (tracer_.scenery.trace && tracer_.shown)
    tracer.shown = [this](const scene::Snapshot& snapshot, const Image& image, bool finished) {
      make(snapshot, image, finished);
      tracer_.shown(snapshot, image, finished);
    };
  return tracer;
}

bool CompleteImages::mayMake(const scene::Snapshot& snapshot) const noexcept {
  return snapshot.settings.gather && tracer_.scenery.trace;
}

std::shared_ptr<const Image> CompleteImages::traced(const scene::Snapshot& snapshot, bool finished) {
  if (unshown_ >= kMaxUnshown && unshown_ % kTrialEvery != 0) return nullptr;
  const frame::TracedImages::Result result =
      images_.imageOf(snapshot, {.mayRepeat = false, .missColor = 0, .finished = finished});
  return result.cached ? std::make_shared<const Image>(result.cached->image) : nullptr;
}

void CompleteImages::make(const scene::Snapshot& snapshot, const Image& shown, bool finished) noexcept {
  try {
    if (!mayMake(snapshot) || !tracer_.scenery.isGathered(snapshot)) return;
    if (!isExpected_) return leaveOut(snapshot);
    made_ = scene::hasScenery(snapshot) ? traced(snapshot, finished) : std::make_shared<const Image>(shown);
    if (!made_) leaveOut(snapshot);
  } catch (const std::exception&) {  // no memory
    leaveOut(snapshot);
  }
}

bool CompleteImages::keep(const gl::RealGl& real, const scene::Region& region, Copy copy) noexcept {
  try {
    return (copy == Copy::beforeDraw ? before_ : after_).keep(real, shared_, region);
  } catch (const std::exception&) { return false; }
}

void CompleteImages::putBack(const gl::RealGl& real, Copy copy) noexcept {
  try {
    (copy == Copy::beforeDraw ? before_ : after_).putBack(real, shared_);
  } catch (const std::exception&) {}  // no memory for the state guard's list
}

bool CompleteImages::write(const gl::RealGl& real, const Image& image, const scene::Snapshot& snapshot,
                           GLenum depthFunc) noexcept {
  try {
    PendingErrors pending;
    const WriteBackTarget into{
        .depthFunc = depthFunc, .colorWrites = snapshot.colorWrites, .encodes = snapshot.encodes};
    const bool written = shared_.writeBack(real, WriteBack::colorsOf(image)).write(image, into, pending);
    takeErrors(real);
    if (written && scene::showsScenery(snapshot)) unshown_ = 0;
    return written;
  } catch (const std::exception&) { return false; }
}

void CompleteImages::leaveOut(const scene::Snapshot& snapshot) noexcept {
  if (!scene::showsScenery(snapshot)) return;
  ++unshown_;
  if (tracer_.scenery.leaveOut) tracer_.scenery.leaveOut();
}

}  // namespace gluray::present
