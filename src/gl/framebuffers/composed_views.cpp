#include "gl/framebuffers/composed_views.h"

#include "gl/batch/presenter.h"
#include "gl/framebuffers/composed_pixels.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"
#include "settings/samples.h"

#include <algorithm>
#include <exception>

namespace gluray::gl {
namespace {

using Copy = CompletePresenter::Copy;

constexpr int kMaxDraws = 16;     // draws compared for one image
constexpr size_t kMaxImages = 8;  // batches of a view

/// With the setting `background`, the program's own background must have one colour.
bool needsEvenBackground(const scene::Snapshot& s) { return s.backdrop != nullptr; }

bool isEven(const std::vector<uint32_t>& colors) {
  return std::ranges::all_of(colors, [&](uint32_t color) { return color == colors.front(); });
}

}  // namespace

/// Runs `body`. If memory runs out, drops the waiting images.
template <class Body>
void ComposedViews::withMemory(const Body& body) noexcept {
  try {
    body();
  } catch (const std::exception&) { watches_ = false, drop(); }
}

/// Reads the colours of region_ in the bound draw framebuffer.
bool ComposedViews::read(std::vector<uint32_t>& colors) {
  p_.shadow.errors.keepPending();
  return presenter_.reader().readColors(p_.shadow.real, region_, colors) && !colors.empty();
}

/// Whether the batch belongs to the view of the waiting images.
bool ComposedViews::follows(const BatchKey& key) const {
  return waits() && images_.front().key.framebuffer == key.framebuffer &&
         images_.front().key.viewport == key.viewport;
}

void ComposedViews::presenting(const BatchKey& key, const scene::Snapshot& snapshot) noexcept {
  watches_ = false;
  if (!presenter_.complete().mayMake(snapshot) || key.layers != BatchKey::Layers::none ||
      snapshot.samples != 1)
    return;
  const bool begins = scene::hasScenery(snapshot) || (!waits() && samplesPerPixel(snapshot.settings) > 1);
  if (begins || follows(key)) withMemory([&] { watch(key, snapshot); });
}

/// Determines whether the framebuffer contains only one colour, or only the waiting images.
void ComposedViews::watch(const BatchKey& key, const scene::Snapshot& snapshot) {
  const bool sameRegion = region_ == snapshot.region;
  region_ = snapshot.region;
  if (!read(colors_)) return drop();
  const bool continues = follows(key) && sameRegion && images_.size() < kMaxImages && colors_ == shown_;
  if (!continues) drop();
  watches_ = continues || isEven(colors_);
  if (watches_ && !continues) empty_ = colors_.front();
  if (watches_) presenter_.complete().expect();
}

void ComposedViews::presented(const BatchKey& key, const scene::SnapshotPtr& snapshot, bool traced) noexcept {
  if (!watches_) return;
  withMemory([&] {
    std::shared_ptr<const Image> image = presenter_.complete().takeImage();
    if (!traced || !image || !read(shown_)) return drop();
    images_.push_back({key, snapshot, std::move(image)});
    draws_ = 0;
  });
}

void ComposedViews::drop() noexcept {
  for (const Complete& one : images_) presenter_.complete().leaveOut(*one.snapshot);
  images_.clear(), drawn_ = false;
}

/// Whether the next draw may compose images over the whole view.
bool ComposedViews::isCandidate() {
  if (p_.failsafe.aside() || p_.shadow.activeQueries > 0 || draws_ >= kMaxDraws) return false;
  p_.shadow.refresh(kRaster | kTarget | kViewport);
  return p_.shadow.viewport().box == images_.front().key.viewport && p_.shadow.target().samples == 1 &&
         p_.shadow.raster().colorWrites.all() && !isOn(p_.shadow.real, GL_DEPTH_TEST);
}

void ComposedViews::drawing() noexcept {
  withMemory([&] {
    if (!isCandidate()) return;
    ++draws_;
    framebuffer_ = p_.shadow.target().framebuffer, drawBuffer_ = p_.shadow.target().drawBuffer;
    drawn_ = read(before_) && presenter_.complete().keep(p_.shadow.real, region_, Copy::beforeDraw);
  });
}

void ComposedViews::finishDraw() noexcept {
  drawn_ = false;
  withMemory([&] {
    if (drawFramebuffer(p_.shadow.real) != framebuffer_ || !read(colors_)) return;
    const bool needsEven =
        std::ranges::any_of(images_, [](const Complete& c) { return needsEvenBackground(*c.snapshot); });
    if (needsEven && !isEven(before_)) return;
    if (isComposed(before_, shown_, empty_, colors_)) show();
  });
}

void ComposedViews::show() {
  CompletePresenter& complete = presenter_.complete();
  const RealGl& real = p_.shadow.real;
  p_.shadow.current.shelve(real);
  if (!complete.keep(real, region_, Copy::afterDraw)) return p_.shadow.latch.restore(real);
  complete.putBack(real, Copy::beforeDraw);
  const bool written = std::ranges::all_of(images_, [&](const Complete& one) {
    return complete.write(real, *one.image, *one.snapshot, one.key.depthFunc);
  });
  p_.shadow.latch.restore(real);
  if (!written) return complete.putBack(real, Copy::afterDraw), drop();
  p_.cleared.forget();
  const bool averages =
      std::ranges::all_of(images_, [](const Complete& one) { return one.image->isAverages(); });
  if (averages && isEven(before_)) p_.cleared.holdsAntialiased(framebuffer_, drawBuffer_, region_);
  images_.clear();
}

}  // namespace gluray::gl
