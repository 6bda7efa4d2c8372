#include "frame/idle_picture.h"

#include <algorithm>
#include <utility>

namespace gluray::frame {
namespace {

constexpr uint32_t kColors = 0xffffff;  // without alpha
constexpr double kLeastShare = 0.5;     // of a picture's hits that the window must show to the bit
constexpr uint32_t kBetter = 2;         // as many passes as the last shown picture had, and then it is shown

}  // namespace

IdleFrame::IdleFrame(std::vector<IdlePicture> pictures, std::shared_ptr<IdleWindow> window)
    : window_(std::move(window)), parts_(pictures.size()) {
  for (size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[parts_.size() - 1 - i];
    part.picture = std::move(pictures[i]);
    part.refinement = std::move(part.picture.refinement);
    if (part.refinement) part.shownPasses = part.refinement->passes();
    if (!part.refinement) part.refinement = std::make_unique<Refinement>();
    part.refiner = std::make_unique<Refiner>(*part.picture.snapshot, *part.refinement);
  }
}

/// The window's colour where the picture's pixel is; null: outside.
const uint32_t* IdleFrame::shownAt(const IdlePicture& picture, glm::ivec2 at) const {
  const glm::ivec2 place = picture.corner + at;
  if (place.x < 0 || place.y < 0 || place.x >= shown_.width || place.y >= shown_.height) return nullptr;
  return &shown_.colors[static_cast<size_t>(place.y) * static_cast<size_t>(shown_.width) +
                        static_cast<size_t>(place.x)];
}

/// Whether a pixel that is equal shows the picture: no pixel close by that does not show it has its colour.
/// Noise may equal a flat overlay here and there, but not all around.
bool IdleFrame::isVisible(const IdlePicture& picture, glm::ivec2 at, const std::vector<bool>& equal) const {
  constexpr int kReach = 3;
  const uint32_t color = *shownAt(picture, at) & kColors;
  for (int y = at.y - kReach; y <= at.y + kReach; ++y) {
    for (int x = at.x - kReach; x <= at.x + kReach; ++x) {
      const bool inside = x >= 0 && y >= 0 && x < picture.size.x && y < picture.size.y;
      if (!inside || equal[static_cast<size_t>(y * picture.size.x + x)]) continue;
      const uint32_t* const shown = shownAt(picture, {x, y});
      if (shown && (*shown & kColors) == color) return false;
    }
  }
  return true;
}

/// Pixels where the window shows exactly what the picture wrote: nothing was drawn or blended over it. False:
/// too few, so that the window need not show this picture at all.
bool IdleFrame::findVisible(Part& part, const Image& image) {
  const IdlePicture& p = part.picture;
  if (image.width != p.size.x || image.height != p.size.y) return false;
  if (taken_.empty()) taken_.resize(shown_.colors.size());
  std::vector<bool> equal(p.colors.size());
  size_t hits = 0, same = 0;
  for (size_t i = 0; i < equal.size(); ++i) {
    if (image.depth[i] == Image::kMiss) continue;
    ++hits;
    const int at = static_cast<int>(i);
    const uint32_t* const shown = shownAt(p, {at % p.size.x, at / p.size.x});
    if (!shown || taken_[static_cast<size_t>(shown - shown_.colors.data())]) continue;
    equal[i] = ((*shown ^ p.colors[i]) & kColors) == 0;
    same += equal[i];
  }
  if (static_cast<double>(same) < kLeastShare * static_cast<double>(hits)) return false;
  for (size_t i = 0; i < equal.size(); ++i) {
    const glm::ivec2 at(static_cast<int>(i) % p.size.x, static_cast<int>(i) / p.size.x);
    if (!equal[i] || (!p.mixed.empty() && p.mixed[i]) || !isVisible(p, at, equal)) continue;
    const auto pixel = static_cast<uint32_t>(shownAt(p, at) - shown_.colors.data());
    taken_[pixel] = true;
    part.visible.push_back(pixel), part.at.push_back(static_cast<uint32_t>(i));
  }
  return true;
}

/// The part's refined pixels as the program would have written them; null: they cannot be made.
const Image* IdleFrame::imageOf(Part& part, const Tracer& tracer) {
  part.refiner->show(part.image);
  const std::optional<scene::Resolve>& how = part.picture.resolve;
  if (!how) return part.image.has(Plane::color) ? &part.image : nullptr;
  const Settings& settings = part.picture.snapshot->settings;
  return tracer.resolve && tracer.resolve(settings, *how, part.image, part.pixels) ? &part.pixels : nullptr;
}

IdleFrame::Step IdleFrame::step(const Tracer& tracer, const Trace& trace, bool& shown) {
  const auto part = std::min_element(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
    return std::pair(a.finished, a.refinement->passes()) < std::pair(b.finished, b.refinement->passes());
  });
  if (part == parts_.end() || part->finished) return Step::done;
  scene::TraceCost cost;
  std::string error;
  if (!part->refiner->pass(trace, 0, cost, error)) return Step::failed;
  if (!std::exchange(part->looked, true)) {
    const Image* const image = imageOf(*part, tracer);
    part->refused = !image || !findVisible(*part, *image);
    if (part->refused) return part->finished = true, Step::more;
  }
  part->finished = part->refiner->finished();
  const uint32_t passes = part->refinement->passes();
  const bool better = passes >= kLeastPasses && passes >= kBetter * part->shownPasses;
  if (!better && !part->finished) return Step::more;
  const Image* const image = imageOf(*part, tracer);
  if (!image) return Step::failed;
  next_ = shown_;
  for (size_t i = 0; i < part->visible.size(); ++i)
    next_.colors[part->visible[i]] = image->color[part->at[i]];
  if (!window_->replace(shown_, next_)) return Step::failed;
  std::swap(shown_, next_);
  part->shownPasses = passes;
  shown = true;
  return Step::more;
}

bool IdleFrame::refused() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.refused; });
}

double IdleFrame::noise() const {
  double most = 0;
  for (const Part& part : parts_)
    if (!part.refused && part.refinement) most = std::max(most, part.refinement->noise());
  return most;
}

std::unique_ptr<Refinement> IdleFrame::take(uint64_t id) noexcept {
  for (Part& part : parts_)
    if (part.picture.id == id && part.refinement && part.refinement->passes() > 0) {
      part.refiner.reset();
      return std::move(part.refinement);
    }
  return nullptr;
}

}  // namespace gluray::frame
