#include "saved/shot/shot.h"

#include "frame/images/traced_images.h"
#include "saved/shot/turned_view.h"
#include "scene/effects.h"
#include "scene/premultiplied.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gluray::saved {
namespace {

using Of = scene::Layers::Of;

constexpr int kRowUnit = 32;      // rows of tiles
constexpr int kFilterReach = 32;  // pixels around a band that change its filtered light

bool isEmpty(const scene::Region& r) { return r.width <= 0 || r.height <= 0; }

bool isFiltered(const scene::Snapshot& s) {
  return scene::wantsLight(s.settings) && s.settings.denoise != Denoise::off;
}

}  // namespace

/// A batch as the picture shows it.
struct Shot::Placed {
  scene::Snapshot snapshot;
  DepthTest test;
  std::vector<scene::Region> cleared;  // pixels of the picture
  // Of layers: depths of opaque surfaces that the real OpenGL drew in the window, one per pixel of
  // `window`, the region there; negative: none.
  std::vector<float> rasterised;
  scene::Region window;
};

Shot::Shot(SavedScene scene, const ShotOptions& options, frame::Renderer& renderer)
    : scene_(std::move(scene)), options_(options), renderer_(renderer) {
  if (scene_.window.x <= 0 || scene_.window.y <= 0)
    throw std::runtime_error("the size of the window is not known");
  if (options_.size == glm::ivec2(0)) options_.size = scene_.window;
  const glm::ivec2 size = options_.size;
  if (size.x < 1 || size.y < 1 || std::max(size.x, size.y) > ShotOptions::kLargestSide)
    throw std::runtime_error("a picture has 1 to 32768 pixels a side");
  frame_ = std::make_unique<ShotFrame>(scene_.window, size, options_.fit);
  const int rows = std::clamp(options_.bandPixels / size.x / kRowUnit * kRowUnit, kRowUnit, 1 << 15);
  bandRows_ = std::min(rows, size.y);
  look();
}

Shot::~Shot() = default;

void Shot::note(const std::string& text) {
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
}

void Shot::look() {
  std::erase_if(scene_.batches, [&](const SavedBatch& batch) {
    const scene::Snapshot& s = *batch.snapshot;
    if (s.catches)
      note("light on surfaces that the real OpenGL drew is as in the window");
    else if (!s.colorWrites.all())
      note("a pass that writes some colour channels only is left out");
    return s.catches || !s.colorWrites.all() || s.instances.empty();
  });
  if (scene_.batches.empty()) throw std::runtime_error("it shows no traced surface");
  const std::vector<scene::SnapshotPtr> snapshots = views();
  for (size_t i = 0; i < snapshots.size(); ++i) {
    SavedBatch batch = scene_.batches[i];
    batch.snapshot = snapshots[i];
    place(batch);
  }
  lookAtWindow();
}

/// The batches as the picture's camera sees them.
std::vector<scene::SnapshotPtr> Shot::views() const {
  std::vector<scene::SnapshotPtr> saved;
  for (const SavedBatch& batch : scene_.batches) saved.push_back(batch.snapshot);
  if (!options_.movesCamera()) return saved;
  return options_.camera ? seenFrom(saved, *options_.known, *options_.camera) : turned(saved, options_.turn);
}

/// The batch as a picture of this frame shows it.
Shot::Placed Shot::placedIn(const ShotFrame& frame, const SavedBatch& batch) {
  Placed placed;
  placed.snapshot = frame.placed(batch);
  placed.snapshot.viewFrame = 1;  // so that one exposure holds for all bands, and all turns
  placed.snapshot.settings.refine.progress = false;
  placed.test = {.strict = batch.strict, .largestWins = placed.snapshot.camera.largestWins};
  for (const scene::Region& box : batch.cleared) {
    const glm::dvec2 low = glm::dvec2(box.x, box.y) + glm::dvec2(batch.place),
                     high = low + glm::dvec2(box.width, box.height);
    const glm::ivec2 from(glm::floor(frame.pictureOf(low))), to(glm::ceil(frame.pictureOf(high)));
    placed.cleared.push_back({from.x, from.y, to.x - from.x, to.y - from.y});
  }
  return placed;
}

void Shot::place(const SavedBatch& batch) {
  const Placed& placed = placed_.emplace_back(placedIn(*frame_, batch));
  samples_ = std::max(samples_, placed.snapshot.samples);
  if (isFiltered(placed.snapshot)) margin_ = kFilterReach;
}

/// Traces what the window showed: finds the background, what was drawn over surfaces, and the exposures.
void Shot::lookAtWindow() {
  const bool knowsWindow = scene_.shown.width == scene_.window.x && scene_.shown.height == scene_.window.y;
  const bool wantsPlate = knowsWindow && !options_.transparent;
  if (frame_->isWindow() && !wantsPlate && bands() == 1 && !options_.movesCamera()) return;
  const ShotFrame window(scene_.window, scene_.window, Fit::all);
  const scene::Region all{0, 0, scene_.window.x, scene_.window.y};
  Canvas canvas(all, samples_);
  for (size_t i = 0; i < placed_.size(); ++i) {
    Placed placed = placedIn(window, scene_.batches[i]);
    const auto& layers = placed.snapshot.layers;
    if (layers && layers->of != Of::drawn && !options_.movesCamera()) {
      placed_[i].window = placed.snapshot.region;
      placed_[i].rasterised = layers->opaqueDepth;
      const std::vector<float> traced = canvas.opaqueDepths(placed.snapshot.region);
      for (size_t p = 0; p < traced.size() && p < placed_[i].rasterised.size(); ++p)
        if (traced[p] >= 0 && traced[p] <= placed_[i].rasterised[p] + 1e-6f) placed_[i].rasterised[p] = -1;
    }
    draw(placed, all, canvas);
  }
  if (!wantsPlate) return;
  plate_ = Plate(scene_.shown, canvas.colors());
  if (!options_.overlays || options_.movesCamera())
    plate_.clearBackground();
  else if (!frame_->isWindow())
    note("text, axes and widgets of the program are enlarged from the window's pixels");
}

/// The part of a batch's snapshot that lies in `part`, over what the canvas has.
scene::Snapshot Shot::partOf(const Placed& placed, const scene::Region& part, const Canvas& canvas) const {
  scene::Snapshot s = placed.snapshot;
  s.region = part;
  if (!s.layers) return s;
  const bool whole = part == placed.snapshot.region && frame_->isWindow() && !options_.movesCamera();
  if (whole) return s;
  auto layers = std::make_shared<scene::Layers>(*s.layers);
  layers->opaqueDepth = canvas.opaqueDepths(part);
  if (layers->of == Of::drawn) {
    layers->floatColors.clear(), s.wideColors = false;
    layers->colors = canvas.colors(part);
    for (float& depth : layers->opaqueDepth)
      if (depth < 0) depth = 1;
  }
  for (int y = 0; y < part.height && !placed.rasterised.empty(); ++y)
    for (int x = 0; x < part.width; ++x) {
      const glm::dvec2 at = frame_->windowOf(glm::dvec2(part.x + x + 0.5, part.y + y + 0.5));
      const int u = static_cast<int>(std::floor(at.x)) - placed.window.x,
                v = static_cast<int>(std::floor(at.y)) - placed.window.y;
      if (u < 0 || v < 0 || u >= placed.window.width || v >= placed.window.height) continue;
      const float depth = placed.rasterised[static_cast<size_t>(v * placed.window.width + u)];
      float& opaque = layers->opaqueDepth[static_cast<size_t>(y * part.width + x)];
      if (depth >= 0 && (opaque < 0 || depth < opaque)) opaque = depth;
    }
  s.layers = std::move(layers);
  return s;
}

void Shot::draw(Placed& placed, const scene::Region& band, Canvas& canvas) const {
  for (const scene::Region& box : placed.cleared) canvas.clearDepth(box);
  const scene::Region part = common(placed.snapshot.region, band);
  if (isEmpty(part)) return;
  const scene::Snapshot s = partOf(placed, part, canvas);
  frame::TracedImages images(frame::Tracer{
      .trace = [this](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                      std::string& error) { return renderer_.render(snapshot, image, cost, error); }});
  const auto traced = images.imageOf(s, {.mayRepeat = false, .finished = true});
  if (!traced.cached) throw std::runtime_error("it cannot be traced: " + traced.why);
  const Image& image = traced.cached->image;
  if (!s.layers) return canvas.add(image, placed.test, s.encodes);
  if (s.layers->of == Of::sums) return canvas.addSums(image);
  if (s.layers->of == Of::order) return canvas.addBlended(image, s.encodes);
  DepthTest always = placed.test;
  always.strict = false, always.writesDepth = s.layers->blending.writesDepth;
  canvas.add(image, always, s.encodes);
}

/// What stands behind the surfaces of a band; empty: nothing.
std::vector<uint32_t> Shot::behind(const scene::Region& band) const {
  std::vector<uint32_t> colors;
  if (plate_.empty()) return colors;
  colors.reserve(static_cast<size_t>(band.width) * static_cast<size_t>(band.height));
  for (int y = 0; y < band.height; ++y)
    for (int x = 0; x < band.width; ++x)
      colors.push_back(plate_.backgroundAt(frame_->windowOf({band.x + x + 0.5, band.y + y + 0.5})));
  return colors;
}

std::vector<uint32_t> Shot::band(int number) {
  const glm::ivec2 all = size();
  const int top = all.y - number * bandRows_, bottom = std::max(0, top - bandRows_);
  const scene::Region band =
      common({0, bottom - margin_, all.x, top - bottom + 2 * margin_}, {0, 0, all.x, all.y});
  Canvas canvas(band, samples_, behind(band));
  for (Placed& placed : placed_) draw(placed, band, canvas);
  const std::vector<uint32_t> colors = canvas.colors();
  std::vector<uint32_t> rows;
  rows.reserve(static_cast<size_t>(all.x) * static_cast<size_t>(top - bottom));
  for (int y = top - 1; y >= bottom; --y)
    for (int x = 0; x < all.x; ++x) {
      const uint32_t color =
          colors[static_cast<size_t>(y - band.y) * static_cast<size_t>(all.x) + static_cast<size_t>(x)];
      const uint32_t over = plate_.hasOverlays() ? plate_.overlayAt(frame_->windowOf({x + 0.5, y + 0.5})) : 0;
      rows.push_back(over ? scene::blended(over, color) : color);
    }
  return rows;
}

}  // namespace gluray::saved
