#include "frame/images/frame_images.h"

#include "base/log.h"
#include "frame/refinement/refiner.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

constexpr size_t kMax = 4;  // views of one window

/// Pixels of a multisampled image whose samples differ.
std::vector<uint8_t> mixedPixels(const Image& image) {
  if (image.samples == 1) return {};
  const size_t pixels = image.color.size() / static_cast<size_t>(image.samples);
  std::vector<uint8_t> mixed(pixels);
  for (size_t i = pixels; i < image.color.size(); ++i)
    if (image.color[i] != image.color[i % pixels]) mixed[i % pixels] = 1;
  return mixed;
}

/// Pixels of an image whose first sample hit something; empty: not known.
std::vector<uint8_t> hitPixels(const Image& image) {
  const size_t pixels = image.color.size() / static_cast<size_t>(image.samples);
  if (image.depth.size() < pixels) return {};
  std::vector<uint8_t> hits(pixels);
  for (size_t i = 0; i < pixels; ++i) hits[i] = image.depth[i] != Image::kMiss;
  return hits;
}

void logUnfinished(const std::string& why) noexcept {
  try {
    log::once(log::Level::warning, "finishing",
              "cannot finish an image that the program reads: " + why + "; it keeps its noise");
  } catch (const std::exception&) {}
}

}  // namespace

void FrameImages::wrote(const scene::SnapshotPtr& snapshot, const ImageCache::CachedImage& cached,
                        const Image& pixels, const scene::Resolve* how) noexcept {
  const bool refines = tracer_.behind && snapshot->lightSampling.mode == scene::LightSampling::Mode::moving &&
                       !cached.refined && pixels.has(Plane::color) && isRefinable(*snapshot);
  if (!written_.empty() && written_.front().snapshot->frame != snapshot->frame) forget();
  if (!refines || (shown_ && idle_->frame() && idle_->frame()->has(cached.id))) return;
  const auto known = std::find_if(written_.begin(), written_.end(),
                                  [&](const IdleImage& one) { return one.id == cached.id; });
  if (known != written_.end()) return;
  if (written_.size() == kMax) return void(tooMany_ = true);
  try {
    IdleImage one{snapshot, cached.id, {pixels.x, pixels.y}, {pixels.width, pixels.height}, pixels.color};
    if (how) one.resolve = *how;
    takeBackPasses();
    one.mixed = mixedPixels(pixels), one.hits = hitPixels(pixels), one.averages = pixels.isAverages();
    one.colors.resize(static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
    written_.push_back(std::move(one));
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void FrameImages::replaces(const scene::Snapshot& before) noexcept {
  takeBackPasses();
  std::erase_if(written_, [&](const IdleImage& one) { return one.snapshot.get() == &before; });
}

void FrameImages::antialiased(const scene::Fxaa& how, const scene::Region& region, const uint32_t* before,
                              const Settings& settings) noexcept {
  if (written_.empty()) return;
  if (antialiased_.size() == kMax) return void(tooMany_ = true);
  try {
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    takeBackPasses();
    antialiased_.push_back({how, region, settings, {before, before + pixels}});
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void FrameImages::refineWhileIdle(const std::function<std::shared_ptr<IdleWindow>()>& open) noexcept {
  using namespace std::chrono_literals;
  constexpr auto kQuiet = 100ms;  // frames that follow each other come sooner
  const bool refines = !written_.empty() && !tooMany_;
  shown_ = rests_ = false;
  if (!open) {
    forget(), inWindow_ = false;
    return idle_ ? idle_->start(nullptr) : void();
  }
  try {
    std::unique_ptr<IdleFrame> frame;
    if (refines) {
      std::shared_ptr<IdleWindow> window = open();
      inWindow_ = window != nullptr;
      frame = read_ ? read_->lend(std::move(window))
                    : std::make_unique<IdleFrame>(takePasses(std::move(written_)), std::move(window),
                                                  std::move(antialiased_));
    }
    forget();
    if (refines && !idle_) idle_ = std::make_unique<IdleRefiner>(tracer_, kQuiet);
    if (idle_) idle_->start(std::move(frame));
    shown_ = rests_ = refines;
  } catch (const std::exception&) {}  // out of memory: the frame keeps its noise
}

void FrameImages::stop() noexcept {
  rests_ = false;
  if (idle_) idle_->stop();
}

std::unique_ptr<Refinement> FrameImages::takePasses(uint64_t id) noexcept {
  std::unique_ptr<Refinement> passes;
  if (read_) passes = read_->takePasses(id);
  if (!passes && idle_) passes = idle_->takePasses(id);
  return passes;
}

/// The images with the passes that were made when they were drawn.
std::vector<IdleImage> FrameImages::takePasses(std::vector<IdleImage> images) noexcept {
  for (IdleImage& one : images)
    if (auto* const cached = last_.withId(one.id)) one.refinement = std::move(cached->refinement);
  return images;
}

/// Passes that a read made go on with the images that may be repeated.
void FrameImages::takeBackPasses() noexcept {
  for (const IdleImage& one : written_)
    if (auto* const cached = read_ ? last_.withId(one.id) : nullptr)
      cached->refinement = read_->takePasses(one.id);
  read_.reset();
}

std::vector<scene::Region> FrameImages::regions() const {
  if (tooMany_) return {};
  if (written_.empty())
    return shown_ && idle_->frame() ? idle_->frame()->regions() : std::vector<scene::Region>();
  std::vector<scene::Region> regions;
  for (const IdleImage& one : written_) regions.push_back(one.region());
  return regions;
}

/// The frame that the program reads; null: none. Throws std::bad_alloc.
IdleFrame* FrameImages::remembered() {
  if (tooMany_) return nullptr;
  if (written_.empty()) return shown_ ? idle_->frame() : nullptr;
  if (read_) return read_.get();
  std::vector<IdleImage> copies;
  for (const IdleImage& one : written_) copies.push_back(one.copy());
  read_ = std::make_unique<IdleFrame>(takePasses(std::move(copies)), nullptr, antialiased_);
  return read_.get();
}

FrameImages::Finished FrameImages::finishIn(const std::shared_ptr<IdleWindow>& window) noexcept {
  Finished result;
  if (idle_) idle_->stop();
  try {
    IdleFrame* const frame = remembered();
    if (!frame) return result;
    const std::unique_ptr<IdleFrame> lent = frame->lend(window);
    IdleFrame::Done done;
    try {
      auto step = lent->readWindow() ? IdleFrame::Step::more : IdleFrame::Step::failed;
      while (step == IdleFrame::Step::more) {
        step = lent->step(tracer_, tracer_.trace, done);
        result.passes += done.traced;
        result.any = result.any || done.shown;
      }
    } catch (const std::exception&) { done.why = "out of memory"; }
    if (!done.why.empty()) logUnfinished(done.why);
    result.noise = lent->noise(), result.cost = done.cost;
    frame->takeBack(*lent);
  } catch (const std::exception& e) { logUnfinished(e.what()); }
  if (rests_ && idle_) idle_->resume();
  return result;
}

}  // namespace gluray::frame
