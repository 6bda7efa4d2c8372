#include "saved/shot/shot.h"

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

/// Whether it blends with the colours below, of bytes.
bool isDrawn(const scene::Snapshot& s) { return s.layers && s.layers->of == Of::drawn; }

bool isFiltered(const scene::Snapshot& s) {
  return scene::wantsLight(s.settings) && s.settings.denoise != Denoise::off;
}

/// Whether frames of a moving window may show other colours.
bool isNoisy(const scene::Snapshot& s) { return scene::wantsLight(s.settings) || s.settings.spp > 1; }

}  // namespace

Shot::Shot(SavedScene scene, const ShotOptions& options, frame::Renderer& renderer)
    : scene_(std::move(scene)),
      options_(options),
      renderer_(renderer),
      plate_(std::make_shared<const Plate>()) {
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
  if (scene_.batches.empty() && (!knowsWindow() || options_.transparent))
    throw std::runtime_error("it shows no traced surface");
  if (scene_.batches.empty()) note("no surface is traced: the picture is made from the window's pixels");
  batches_ = scene_.batches;
  for (SavedBatch& batch : batches_) {
    if (!options_.settings) break;
    auto changed = std::make_shared<scene::Snapshot>(*batch.snapshot);
    changed->settings = options_.settings(changed->settings);
    batch.snapshot = std::move(changed);
  }
  const std::vector<scene::SnapshotPtr> snapshots = views();
  for (size_t i = 0; i < snapshots.size(); ++i) {
    SavedBatch batch = batches_[i];
    batch.snapshot = snapshots[i];
    place(batch);
    placed_.back().saved = scene_.batches[i].snapshot;
  }
  lookAtWindow();
}

/// The batches as the picture's camera sees them.
std::vector<scene::SnapshotPtr> Shot::views() const {
  std::vector<scene::SnapshotPtr> saved;
  for (const SavedBatch& batch : batches_) saved.push_back(batch.snapshot);
  if (!options_.movesCamera()) return saved;
  return options_.camera ? seenFrom(saved, *options_.known, *options_.camera) : turned(saved, options_.turn);
}

/// The batch as a picture of this frame shows it.
Shot::Placed Shot::placedIn(const ShotFrame& frame, const SavedBatch& batch) const {
  Placed placed;
  placed.snapshot = frame.placed(batch);
  int& samples = placed.snapshot.settings.spp;
  if (!frame.isWindow()) samples = std::max(samples, options_.edgeSamples);
  placed.snapshot.viewFrame = options_.look;
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

/// What the window shows of these batches, which may have the settings of the program or of the picture.
Canvas Shot::windowOf(const std::vector<SavedBatch>& batches, WindowLook look) {
  const ShotFrame window(scene_.window, scene_.window, Fit::all);
  const scene::Region all{0, 0, scene_.window.x, scene_.window.y};
  int samples = 1;
  for (const SavedBatch& batch : batches) samples = std::max(samples, batch.snapshot->samples);
  Canvas canvas(all, samples);
  for (size_t i = 0; i < batches.size(); ++i) {
    Placed placed = placedIn(window, batches[i]);
    if (look == WindowLook::program) placed.snapshot.view |= kProgramView;
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
  return canvas;
}

/// Traces what the window showed: finds the background, what was drawn over surfaces, and the exposures.
void Shot::lookAtWindow() {
  const bool wantsPlate = knowsWindow() && !options_.transparent;
  if (frame_->isWindow() && !wantsPlate && bands() == 1 && !options_.movesCamera()) return;
  WindowMemory own;
  WindowMemory& memory = options_.window ? *options_.window : own;
  const bool moves = options_.movesCamera(), isSame = !options_.settings;
  if (moves && memory.exposed && (memory.moved || !wantsPlate)) {
    if (wantsPlate) plate_ = memory.moved;
    return;
  }
  const bool exposes = std::any_of(batches_.begin(), batches_.end(), [](const SavedBatch& batch) {
    return batch.snapshot->settings.autoExposure;
  });
  if (!wantsPlate || (!isSame && exposes)) windowOf(batches_, WindowLook::picture);
  memory.exposed = true;
  if (!wantsPlate) return;
  const Canvas shown = windowOf(scene_.batches, isSame ? WindowLook::picture : WindowLook::program);
  const bool noisy = std::any_of(scene_.batches.begin(), scene_.batches.end(),
                                 [](const SavedBatch& batch) { return isNoisy(*batch.snapshot); });
  const auto plate = std::make_shared<Plate>(scene_.shown, shown.colors(), showsWindow() && isSame && !noisy);
  if (!options_.overlays || moves)
    plate->clearBackground();
  else if (!frame_->isWindow())
    note("text, axes and widgets of the program are enlarged from the window's pixels");
  plate_ = plate;
  if (moves) memory.moved = plate;
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

/// The finished image; valid as long as `images`.
const Image& Shot::traced(const scene::Snapshot& s, std::optional<frame::TracedImages>& images) const {
  images.emplace(frame::Tracer{
      .trace = [this](const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                      std::string& error) { return renderer_.render(snapshot, image, cost, error); }});
  const auto made = images->imageOf(s, {.mayRepeat = false, .finished = true});
  if (!made.cached) throw std::runtime_error("it cannot be traced: " + made.why);
  return made.cached->image;
}

void Shot::draw(Placed& placed, const scene::Region& band, Canvas& canvas) const {
  for (const scene::Region& box : placed.cleared) canvas.clearDepth(box);
  const scene::Region part = common(placed.snapshot.region, band);
  if (isEmpty(part)) return;
  scene::Snapshot s = partOf(placed, part, canvas);
  if (canvas.isWide() && !isDrawn(s)) s.wideColors = true, s.limitedSamples = canvas.limits();
  std::optional<frame::TracedImages> own;
  const Image& image = options_.images ? options_.images(s) : traced(s, own);
  if (!s.layers) return canvas.add(image, placed.test, s.encodes);
  if (s.layers->of == Of::sums) return canvas.addSums(image);
  if (s.layers->of == Of::order) return canvas.addBlended(image, s.encodes);
  DepthTest always = placed.test;
  always.strict = false, always.writesDepth = s.layers->blending.writesDepth;
  canvas.add(image, always, s.encodes);
}

scene::Region Shot::regionOf(int band) const {
  const int top = size().y - band * bandRows_, bottom = std::max(0, top - bandRows_);
  return {0, bottom, size().x, top - bottom};
}

template <class Color, class Background, class Start>
Canvas Shot::drawn(const scene::Region& band, const Background& background, const Start& start) {
  const scene::Region around =
      common({0, band.y - margin_, band.width, band.height + 2 * margin_}, {0, 0, size().x, size().y});
  std::vector<Color> under;
  if (!plate_->empty()) {
    under.reserve(static_cast<size_t>(around.width) * static_cast<size_t>(around.height));
    for (int y = 0; y < around.height; ++y)
      for (int x = 0; x < around.width; ++x)
        under.push_back(background(frame_->windowOf({around.x + x + 0.5, around.y + y + 0.5})));
  }
  Canvas canvas = start(around, under);
  for (Placed& placed : placed_) draw(placed, around, canvas);
  return canvas;
}

/// The rows of a band from its top, under what stands over surfaces.
template <class Color, class Overlay>
std::vector<Color> Shot::rowsOf(const scene::Region& band, const Canvas& canvas,
                                const std::vector<Color>& colors, const Overlay& overlay) const {
  const bool changes = plate_->hasOverlays() || showsWindow();
  std::vector<Color> rows;
  rows.reserve(static_cast<size_t>(band.width) * static_cast<size_t>(band.height));
  for (int y = band.y + band.height - 1; y >= band.y; --y)
    for (int x = 0; x < band.width; ++x) {
      const Color& color =
          colors[static_cast<size_t>(y - canvas.region().y) * static_cast<size_t>(band.width) +
                 static_cast<size_t>(x)];
      rows.push_back(changes ? overlay(frame_->windowOf({x + 0.5, y + 0.5}), color) : color);
    }
  return rows;
}

std::vector<uint32_t> Shot::band(int number) {
  const scene::Region band = regionOf(number);
  const Canvas canvas = drawn<uint32_t>(
      band,
      [&](const glm::dvec2& place) {
        return showsWindow() ? plate_->windowBackgroundAt(glm::ivec2(place)) : plate_->backgroundAt(place);
      },
      [&](const scene::Region& region, const auto& under) { return Canvas(region, samples_, under); });
  return rowsOf(band, canvas, canvas.colors(), [&](const glm::dvec2& place, uint32_t color) {
    const uint32_t over = plate_->overlayAt(place), pixel = over ? scene::blended(over, color) : color;
    return showsWindow() ? plate_->roundedAsShown(glm::ivec2(place), pixel) : pixel;
  });
}

std::vector<glm::vec4> Shot::wideBand(int number, Range range) {
  const scene::Region band = regionOf(number);
  const Canvas canvas = drawn<glm::vec4>(
      band,
      [&](const glm::dvec2& place) {
        return showsWindow() ? scene::wideOf(plate_->windowBackgroundAt(glm::ivec2(place)))
                             : plate_->wideBackgroundAt(place);
      },
      [&](const scene::Region& region, const auto& under) {
        return Canvas(region, samples_, under, range == Range::limited);
      });
  return rowsOf(band, canvas, canvas.wideColors(), [&](const glm::dvec2& place, const glm::vec4& color) {
    const glm::vec4 over = plate_->wideOverlayAt(place);
    return over.a > 0 ? scene::blended(over, color) : color;
  });
}

}  // namespace gluray::saved
