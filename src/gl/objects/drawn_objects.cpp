#include "gl/objects/drawn_objects.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::gl {
namespace {

/// Whether a clear of `box` removes most of `drawn`: window sizes change between frames.
bool coversMost(const scene::Region& box, const scene::Region& drawn) {
  const int width = std::min(box.x + box.width, drawn.x + drawn.width) - std::max(box.x, drawn.x),
            height = std::min(box.y + box.height, drawn.y + drawn.height) - std::max(box.y, drawn.y);
  return width > 0 && height > 0 && int64_t{width} * height * 4 >= int64_t{drawn.width} * drawn.height * 3;
}

}  // namespace

DrawnObjects::~DrawnObjects() { forget(); }

bool DrawnObjects::checkAsked() noexcept {
  const bool asked = shownFrames().wanted();
  if (asked == asked_) return false;
  if (!asked) forget();
  asked_ = asked;
  return true;
}

void DrawnObjects::forget() noexcept {
  batches_.clear();
  if (asked_) shownFrames().forget(this);
}

void DrawnObjects::number(const BatchKey& key, scene::Snapshot& batch) noexcept {
  if (!numbers_ && !asked_ && batch.settings.material.objects.empty()) return;
  try {
    if (!numbers_) numbers_ = std::make_unique<ObjectNumbers>();
    const bool begins = frame_ != batch.frame || ended_;
    if (begins && asked_) {
      shownFrames().whole(this);
      batches_.clear();  // framebuffers may have other names in each frame
    }
    if (begins && !numbers_->fresh()) numbers_->beginFrame();
    if (numbers_->fresh()) firstFramebuffer_ = key.framebuffer, firstRegion_ = batch.region;
    frame_ = batch.frame, ended_ = false;
    numbers_->number(key, batch);
  } catch (const std::exception&) { numbers_.reset(); }  // out of memory: numbering starts over
}

void DrawnObjects::traced(const BatchKey& key, const scene::SnapshotPtr& snapshot) noexcept {
  if (!asked_) return;
  try {
    if (batches_.size() >= kMaxBatches) batches_.erase(batches_.begin());
    batches_.push_back({snapshot, key.framebuffer, key.depthFunc == GL_LESS || key.depthFunc == GL_GREATER,
                        std::move(clears_)});
    clears_.clear();
  } catch (const std::exception&) { batches_.clear(); }
  if (!swaps_) publish(0);
}

void DrawnObjects::colorCleared(uint32_t framebuffer, const scene::Region& box) noexcept {
  std::erase_if(batches_, [&](const ShownBatch& batch) {
    return batch.framebuffer == framebuffer && coversMost(box, batch.snapshot->region);
  });
  ended_ |= framebuffer == firstFramebuffer_ && coversMost(box, firstRegion_);
}

void DrawnObjects::depthCleared(uint32_t framebuffer, const scene::Region& box) noexcept {
  if (!asked_ || clears_.size() >= kMaxBatches) return;
  try {
    clears_.push_back({framebuffer, box});
  } catch (const std::exception&) {}  // out of memory
}

void DrawnObjects::placed(const std::vector<glm::ivec4>& places) {
  if (asked_ && places_.size() < kMaxPlaces) places_.insert(places_.end(), places.begin(), places.end());
}

ShownFramePtr DrawnObjects::now() const {
  return std::make_shared<const ShownFrame>(ShownFrame{0, batches_, places_});
}

void DrawnObjects::publish(uint64_t frame) noexcept {
  try {
    shownFrames().show(this, std::make_shared<const ShownFrame>(ShownFrame{frame, batches_, places_}));
  } catch (const std::exception&) {}  // the next frame is shown
}

void DrawnObjects::shown(uint64_t frame) noexcept {
  swaps_ = true;
  if (!asked_) return;
  publish(frame);
  places_.clear();
  std::erase_if(batches_, [](const ShownBatch& batch) { return batch.framebuffer == 0; });
}

}  // namespace gluray::gl
