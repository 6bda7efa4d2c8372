#include "frame/idle/idle_image.h"

#include "frame/idle/compared_pixels.h"
#include "frame/idle/edge_pixels.h"
#include "settings/samples.h"

#include <algorithm>
#include <utility>

namespace gluray::frame {
namespace {

constexpr double kMinShare = 0.5;  // of an image's hits that the window must show to the bit
constexpr uint32_t kBetter = 2;    // as many passes as the last shown image had, and then it is shown

}  // namespace

IdleFrame::IdleFrame(std::vector<IdleImage> images, std::shared_ptr<IdleWindow> window,
                     std::vector<IdleFxaa> passes)
    : window_(std::move(window)), passes_(std::move(passes)), parts_(images.size()) {
  for (size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[parts_.size() - 1 - i];
    part.written = std::move(images[i]);
    part.refinement = std::move(part.written.refinement);
    if (part.refinement) part.shownPasses = part.refinement->passes();
    if (!part.refinement) part.refinement = std::make_unique<Refinement>();
    part.refiner = std::make_unique<Refiner>(*part.written.snapshot, *part.refinement);
  }
}

namespace {

/// Copies rows of the region from or to the window.
template <class Copy>
void eachRow(const scene::Region& region, WindowPixels& window, const Copy& copy) {
  for (int y = 0; y < region.height; ++y)
    copy(window.colors.begin() + static_cast<ptrdiff_t>(region.y + y) * window.width + region.x,
         static_cast<ptrdiff_t>(y) * region.width);
}

bool isInside(const scene::Region& r, const WindowPixels& window) {
  return r.x >= 0 && r.y >= 0 && r.width > 0 && r.height > 0 && r.width <= window.width - r.x &&
         r.height <= window.height - r.y;
}

bool antialias(const Tracer& tracer, const IdleFxaa& pass, const std::vector<uint32_t>& in,
               std::vector<uint32_t>& out) {
  out.resize(in.size());
  return tracer.antialias && tracer.antialias(pass.settings, pass.how, in.data(), pass.region.width,
                                              pass.region.height, out.data());
}

/// Finds the pixels where the window shows the pass's result. False: too few.
bool findSeen(IdleFxaa& pass, const std::vector<uint32_t>& after, const WindowPixels& shown) {
  const scene::Region& r = pass.region;
  Compared compared{shown, {r.x, r.y}, {r.width, r.height}, std::vector<bool>(after.size())};
  size_t same = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    compared.equal[i] = ((*compared.shownAt(compared.placeOf(i)) ^ after[i]) & kColors) == 0;
    same += compared.equal[i];
  }
  if (static_cast<double>(same) < kMinShare * static_cast<double>(after.size())) return false;
  pass.seen.assign(after.size(), false);
  for (size_t i = 0; i < after.size(); ++i)
    pass.seen[i] = compared.equal[i] && isVisible(compared, compared.placeOf(i));
  return true;
}

}  // namespace

/// Puts what passes read in place of what they wrote. Those that the window does not show are forgotten.
void IdleFrame::undoPasses(const Tracer& tracer) {
  undone_ = true;
  under_ = shown_;
  std::vector<uint32_t> after;
  std::erase_if(passes_, [&](IdleFxaa& pass) {
    const scene::Region& r = pass.region;
    const size_t pixels =
        static_cast<size_t>(std::max(r.width, 0)) * static_cast<size_t>(std::max(r.height, 0));
    if (!isInside(r, shown_) || pass.before.size() != pixels) return true;
    if (!antialias(tracer, pass, pass.before, after) || !findSeen(pass, after, shown_)) return true;
    eachRow(r, under_,
            [&](auto to, ptrdiff_t from) { std::copy_n(pass.before.begin() + from, r.width, to); });
    return false;
  });
}

/// The window with a part's refined pixels. False: the passes cannot be made.
bool IdleFrame::composeNext(const Part& part, const Image& image, const Tracer& tracer) {
  nextUnder_ = under_;
  const bool smooths = image.isAverages() && !part.written.averages;
  for (size_t i = 0; i < part.visible.size(); ++i) {
    const uint32_t color = image.color[part.at[i]];
    const auto behind = i < part.behind.size() ? part.behind[i] : std::nullopt;
    const std::optional<uint32_t> shown = smooths ? shownColor(color, behind) : color;
    if (shown) nextUnder_.colors[part.visible[i]] = *shown;
  }
  next_ = shown_;
  for (const uint32_t pixel : part.visible) next_.colors[pixel] = nextUnder_.colors[pixel];
  std::vector<uint32_t> before, after;
  for (const IdleFxaa& pass : passes_) {
    const scene::Region& r = pass.region;
    before.resize(pass.before.size());
    eachRow(r, nextUnder_, [&](auto from, ptrdiff_t to) { std::copy_n(from, r.width, before.begin() + to); });
    if (!antialias(tracer, pass, before, after)) return false;
    for (size_t i = 0; i < after.size(); ++i) {
      const glm::ivec2 at(r.x + static_cast<int>(i) % r.width, r.y + static_cast<int>(i) / r.width);
      const auto pixel =
          static_cast<size_t>(at.y) * static_cast<size_t>(next_.width) + static_cast<size_t>(at.x);
      next_.colors[pixel] = pass.seen[i] ? after[i] : shown_.colors[pixel];
    }
  }
  return true;
}

/// Pixels where the window shows exactly what the image wrote: nothing was drawn or blended over it. False:
/// too few, so that the window need not show this image at all.
bool IdleFrame::findVisible(Part& part) {
  const IdleImage& p = part.written;
  if (taken_.empty()) taken_.resize(under_.colors.size());
  Compared compared{under_, p.corner, p.size, std::vector<bool>(p.colors.size())};
  size_t hits = 0, same = 0;
  for (size_t i = 0; i < p.colors.size(); ++i) {
    if (!p.hits.empty() && !p.hits[i]) continue;
    ++hits;
    const uint32_t* const shown = compared.shownAt(compared.placeOf(i));
    if (!shown || taken_[static_cast<size_t>(shown - under_.colors.data())]) continue;
    compared.equal[i] = ((*shown ^ p.colors[i]) & kColors) == 0;
    same += compared.equal[i];
  }
  if (static_cast<double>(same) < kMinShare * static_cast<double>(hits)) return false;
  for (size_t i = 0; i < p.colors.size(); ++i) {
    const glm::ivec2 at = compared.placeOf(i);
    if (!compared.equal[i] || (!p.mixed.empty() && p.mixed[i]) || !isVisible(compared, at)) continue;
    const auto pixel = static_cast<uint32_t>(compared.shownAt(at) - under_.colors.data());
    taken_[pixel] = true;
    part.visible.push_back(pixel), part.at.push_back(static_cast<uint32_t>(i));
  }
  return true;
}

/// Finds out which parts the window shows, and where.
void IdleFrame::look() {
  for (Part& part : parts_)
    if (!part.finished && part.refiner) part.refused = part.finished = !findVisible(part);
  for (Part& part : parts_)
    if (!part.refused && part.refiner) findEdges(part);
}

/// What lies behind the edges of an image of one sample per pixel, where it is refined with several. Adds the
/// pixels beside the edges to those that show the image.
void IdleFrame::findEdges(Part& part) {
  const IdleImage& p = part.written;
  if (p.averages || p.hits.empty() || !averagesSamples(p.snapshot->settings, p.snapshot->samples)) return;
  Compared compared{under_, p.corner, p.size, std::vector<bool>(p.colors.size())};
  for (const uint32_t pixel : part.at) compared.equal[pixel] = true;
  const auto placeIn = [&](const uint32_t* shown) {
    return static_cast<size_t>(shown - under_.colors.data());
  };
  const EdgeSurroundings around{compared, p.hits,
                                [&](glm::ivec2 at) { return bool{taken_[placeIn(compared.shownAt(at))]}; }};
  for (const uint32_t pixel : part.at) part.behind.push_back(colorBehind(around, compared.placeOf(pixel)));
  for (size_t i = 0; i < p.hits.size(); ++i) {
    if (p.hits[i]) continue;
    const glm::ivec2 at = compared.placeOf(i);
    const std::optional<uint32_t> behind = colorBehind(around, at);
    if (!behind) continue;
    part.visible.push_back(static_cast<uint32_t>(placeIn(compared.shownAt(at))));
    part.at.push_back(static_cast<uint32_t>(i)), part.behind.push_back(behind);
  }
}

/// The part's refined pixels as the program would have written them; null: they cannot be made.
const Image* IdleFrame::imageOf(Part& part, const Tracer& tracer) {
  part.refiner->show(part.image);
  const std::optional<scene::Resolve>& how = part.written.resolve;
  if (!how) return part.image.has(Plane::color) ? &part.image : nullptr;
  const Settings& settings = part.written.snapshot->settings;
  return tracer.resolve && tracer.resolve(settings, *how, part.image, part.pixels) ? &part.pixels : nullptr;
}

std::vector<scene::Region> IdleFrame::regions() const {
  std::vector<scene::Region> regions;
  for (const Part& part : parts_) regions.push_back(part.written.region());
  return regions;
}

bool IdleFrame::has(uint64_t id) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& p) { return p.written.id == id; });
}

bool IdleFrame::readWindow() noexcept {
  if (!looked_) return window_->read(shown_);
  // `next_` is free between steps.
  return window_->read(next_) && next_.width == shown_.width && next_.height == shown_.height &&
         std::equal(next_.colors.begin(), next_.colors.end(), shown_.colors.begin(),
                    [](uint32_t a, uint32_t b) { return ((a ^ b) & kColors) == 0; });
}

std::unique_ptr<IdleFrame> IdleFrame::lend(std::shared_ptr<IdleWindow> window) {
  auto lent = std::make_unique<IdleFrame>(std::vector<IdleImage>{}, std::move(window), passes_);
  lent->parts_.resize(parts_.size());
  for (size_t i = 0; i < parts_.size(); ++i) lent->parts_[i].written = parts_[i].written.copy();
  for (size_t i = 0; i < parts_.size(); ++i) {  // nothing throws from here on
    lent->parts_[i].refinement = std::move(parts_[i].refinement);
    lent->parts_[i].refiner = std::move(parts_[i].refiner);
    lent->parts_[i].finished = lent->parts_[i].refused = !lent->parts_[i].refiner;
  }
  return lent;
}

void IdleFrame::takeBack(IdleFrame& lent) noexcept {
  for (size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].refinement = std::move(lent.parts_[i].refinement);
    parts_[i].refiner = std::move(lent.parts_[i].refiner);
  }
}

IdleFrame::Step IdleFrame::step(const Tracer& tracer, const Trace& trace, Done& done) {
  done.traced = done.shown = false;
  const auto rank = [](const Part& p) {
    return std::pair(p.finished, p.finished ? 0 : p.refinement->passes());
  };
  const auto part = std::min_element(parts_.begin(), parts_.end(),
                                     [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  if (part == parts_.end() || part->finished) return Step::done;
  if (!undone_) undoPasses(tracer);
  if (!std::exchange(looked_, true)) {
    look();
    if (part->finished) return Step::more;
  }
  if (!part->refiner->hasPass() || !part->refiner->finished()) {
    if (!part->refiner->pass(trace, 0, done.cost, done.why)) return Step::failed;
    done.traced = true;
  }
  part->finished = part->refiner->finished();
  const uint32_t passes = part->refinement->passes();
  const bool better = passes >= kMinPasses && passes >= kBetter * part->shownPasses;
  if (!better && !part->finished) return Step::more;
  const Image* const image = imageOf(*part, tracer);
  if (!image || image->width != part->written.size.x || image->height != part->written.size.y)
    return Step::failed;
  if (!composeNext(*part, *image, tracer)) return Step::failed;
  if (!window_->replace(shown_, next_)) return Step::failed;
  std::swap(shown_, next_), std::swap(under_, nextUnder_);
  part->shownPasses = passes;
  done.shown = true;
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

std::unique_ptr<Refinement> IdleFrame::takePasses(uint64_t id) noexcept {
  for (Part& part : parts_)
    if (part.written.id == id && part.refinement && part.refinement->passes() > 0) {
      part.refiner.reset();
      part.finished = true;
      return std::move(part.refinement);
    }
  return nullptr;
}

}  // namespace gluray::frame
