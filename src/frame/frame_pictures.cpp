#include "frame/frame_pictures.h"

#include "frame/refiner.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

constexpr size_t kMost = 4;  // views of one window

/// Pixels of a multisampled picture whose samples differ.
std::vector<bool> mixedPixels(const Image& image) {
  if (image.samples == 1) return {};
  const size_t pixels = image.color.size() / static_cast<size_t>(image.samples);
  std::vector<bool> mixed(pixels);
  for (size_t i = pixels; i < image.color.size(); ++i)
    if (image.color[i] != image.color[i % pixels]) mixed[i % pixels] = true;
  return mixed;
}

}  // namespace

void FramePictures::wrote(const scene::SnapshotPtr& snapshot, const LastPictures::Picture& picture,
                          const Image& pixels, const scene::Resolve* how) noexcept {
  const bool refines = tracer_.behind && snapshot->lightSampling.mode == scene::LightSampling::Mode::moving &&
                       !picture.refined && pixels.has(Plane::color) && isRefinable(*snapshot);
  if (!written_.empty() && written_.front().snapshot->frame != snapshot->frame) forget();
  if (!refines) return;
  const auto known = std::find_if(written_.begin(), written_.end(),
                                  [&](const IdlePicture& one) { return one.id == picture.id; });
  if (known != written_.end()) return;
  if (written_.size() == kMost) return void(tooMany_ = true);
  try {
    IdlePicture one{snapshot, picture.id, {pixels.x, pixels.y}, {pixels.width, pixels.height}, pixels.color};
    if (how) one.resolve = *how;
    takeBackPasses();
    one.mixed = mixedPixels(pixels);
    one.colors.resize(static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
    written_.push_back(std::move(one));
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void FramePictures::antialiased(const scene::Fxaa& how, const scene::Region& region, const uint32_t* before,
                                const Settings& settings) noexcept {
  if (written_.empty()) return;
  if (antialiased_.size() == kMost) return void(tooMany_ = true);
  try {
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    antialiased_.push_back({how, region, settings, {before, before + pixels}});
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void FramePictures::refineWhileIdle(const std::function<std::shared_ptr<IdleWindow>()>& open) noexcept {
  using namespace std::chrono_literals;
  constexpr auto kQuiet = 100ms;  // frames that follow each other come sooner
  const bool refines = !written_.empty() && !tooMany_;
  shown_ = false;
  try {
    std::unique_ptr<IdleFrame> frame;
    if (refines && read_) frame = read_->lend(open());
    if (refines && !read_)
      frame = std::make_unique<IdleFrame>(takePasses(std::move(written_)), open(), std::move(antialiased_));
    forget();
    if (refines && !idle_) idle_ = std::make_unique<IdleRefiner>(tracer_, kQuiet);
    if (idle_) idle_->start(std::move(frame));
    shown_ = refines;
  } catch (const std::exception&) {}  // out of memory: the frame keeps its noise
}

void FramePictures::stop() noexcept {
  if (idle_) idle_->stop();
}

std::unique_ptr<Refinement> FramePictures::take(uint64_t id) noexcept {
  std::unique_ptr<Refinement> passes;
  if (read_) passes = read_->take(id);
  if (!passes && idle_) passes = idle_->take(id);
  return passes;
}

/// The pictures with the passes that were made when they were drawn.
std::vector<IdlePicture> FramePictures::takePasses(std::vector<IdlePicture> pictures) noexcept {
  for (IdlePicture& one : pictures)
    if (auto* const picture = last_.withId(one.id)) one.refinement = std::move(picture->refinement);
  return pictures;
}

/// Passes that a read made go on with the pictures that may be repeated.
void FramePictures::takeBackPasses() noexcept {
  for (const IdlePicture& one : written_)
    if (auto* const picture = read_ ? last_.withId(one.id) : nullptr)
      picture->refinement = read_->take(one.id);
  read_.reset();
}

glm::ivec2 FramePictures::size() const noexcept {
  glm::ivec2 size(0);
  if (tooMany_) return size;
  if (written_.empty()) return shown_ && idle_->frame() ? idle_->frame()->size() : size;
  for (const IdlePicture& one : written_) size = glm::max(size, one.corner + one.size);
  return size;
}

/// The frame that the program reads; null: none. Throws std::bad_alloc.
IdleFrame* FramePictures::remembered() {
  if (tooMany_) return nullptr;
  if (written_.empty()) return shown_ ? idle_->frame() : nullptr;
  if (read_) return read_.get();
  std::vector<IdlePicture> copies;
  for (const IdlePicture& one : written_) copies.push_back(one.copy());
  read_ = std::make_unique<IdleFrame>(takePasses(std::move(copies)), nullptr, antialiased_);
  return read_.get();
}

FramePictures::Finished FramePictures::finishIn(const std::shared_ptr<IdleWindow>& window) noexcept {
  Finished result;
  stop();
  try {
    IdleFrame* const frame = remembered();
    if (!frame) return result;
    const std::unique_ptr<IdleFrame> lent = frame->lend(window);
    auto step = lent->look() ? IdleFrame::Step::more : IdleFrame::Step::failed;
    try {
      while (step == IdleFrame::Step::more) {
        bool shown = false;
        step = lent->step(tracer_, tracer_.trace, shown);
        result.passes += step == IdleFrame::Step::more;
        result.any = result.any || shown;
      }
    } catch (const std::exception&) {}  // out of memory: the rest keeps its noise
    result.noise = lent->noise();
    frame->takeBack(*lent);
  } catch (const std::exception&) {}
  if (shown_ && idle_) idle_->resume();
  return result;
}

}  // namespace gluray::frame
