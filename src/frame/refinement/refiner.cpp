#include "frame/refinement/refiner.h"

#include "base/clock.h"
#include "frame/refinement/denoiser.h"
#include "frame/refinement/noise_image.h"
#include "scene/effects.h"
#include "settings/samples.h"

#include <algorithm>
#include <exception>
#include <limits>

namespace gluray::frame {
namespace {

constexpr size_t kMaxBytes = size_t{1} << 30;  // of sums
constexpr double kQuiet = 0.5;  // of the noise that an image may have: tiles with less take no more passes

size_t valuesOf(const scene::Snapshot& s) {
  return static_cast<size_t>(s.region.width) * static_cast<size_t>(s.region.height) *
         static_cast<size_t>(std::max(s.samples, 1));
}

/// Whether passes have wide colours where the image has bytes. Blending in the order of drawing is blending
/// of bytes.
bool usesWideColors(const scene::Snapshot& s) {
  return !s.wideColors && (!s.layers || s.layers->of == scene::Layers::Of::order);
}

/// Whether pixels mix several samples or surfaces, as far as is known before an image is traced.
bool mayMix(const scene::Snapshot& s) {
  return s.layers || s.catches || scene::showsScenery(s) || samplesPerPixel(s.settings) > 1;
}

void addCost(const scene::TraceCost& more, scene::TraceCost& cost) {
  const double build = cost.buildSeconds, trace = cost.traceSeconds;
  const uint64_t blas = cost.blasBuilds, tlas = cost.tlasBuilds, refinements = cost.blasRefinements;
  cost = more;
  cost.buildSeconds += build, cost.traceSeconds += trace;
  cost.blasBuilds += blas, cost.tlasBuilds += tlas, cost.blasRefinements += refinements;
}

/// Whether each pixel is one sample of one surface. Averages and layers are traced as a whole: what the rest
/// of the image has decides how.
bool isSimple(const scene::Snapshot& s) { return !s.layers && !averagesSamples(s.settings, s.samples); }

/// Passes whose features are averaged: those of a lens vary with its random points.
constexpr uint32_t kLensFeatures = 4;

/// The snapshot for passes of features whose pixels have the samples of `pass`. Averages are given up where
/// alpha is no opacity.
scene::Snapshot featuresOf(const scene::Snapshot& s, const Image& pass) {
  scene::Snapshot features = s;
  features.wideColors = true, features.byteSamples = false;
  if (pass.isAverages()) return features;
  features.backdrop = nullptr;
  if (features.ground == scene::GroundUse::drawn) features.ground = scene::GroundUse::around;
  takeOneSample(features.settings);
  return features;
}

bool hasCatcher(const scene::Snapshot& s) {
  return s.ground == scene::GroundUse::drawn && scene::wantsCatcher(s.settings);
}

/// Whether light without noise is told from the rest. It must be equal in all passes.
bool wantsNoiseless(const scene::Snapshot& s) {
  return scene::wantsPaths(s.settings) && !s.layers && !s.catches && !hasCatcher(s) &&
         !hasOpenLens(s.settings);
}

Refinement::Judged judgedOf(const scene::Snapshot& s) {
  if (s.catches) return Refinement::Judged::alpha;
  return hasCatcher(s) && !s.backdrop ? Refinement::Judged::onWhite : Refinement::Judged::colors;
}

}  // namespace

bool isRefinable(const scene::Snapshot& snapshot) {
  return scene::wantsLight(snapshot.settings) && snapshot.settings.noise > 0 &&
         snapshot.settings.renderer == gluray::Renderer::embree &&
         Refinement::bytesFor(valuesOf(snapshot)) <= kMaxBytes;
}

bool isFilterable(const scene::Snapshot& snapshot) {
  const size_t bytes = (mayMix(snapshot) ? AuxiliaryFeatures::kMixedBytes : AuxiliaryFeatures::kBytes) +
                       (wantsNoiseless(snapshot) ? AuxiliaryFeatures::kNoiselessBytes : 0);
  return Refinement::bytesFor(valuesOf(snapshot), bytes) <= kMaxBytes;
}

bool isFinished(const Refinement& refinement, const Settings& settings) {
  const uint32_t passes = refinement.passes();
  if (passes >= static_cast<uint32_t>(settings.refine.passes)) return true;
  const double limit = settings.refine.seconds, mean = refinement.seconds() / std::max(passes, 1u);
  if (limit > 0 && passes > 0 && refinement.seconds() + mean > limit) return true;
  return passes >= kMinPasses && refinement.noise() <= double{settings.noise};
}

void divideIntoPasses(Settings& settings) {
  int most = 1;
  if (scene::wantsOcclusion(settings)) most = std::max(most, settings.ao.samples);
  if (scene::wantsShadows(settings)) most = std::max(most, settings.shadows.samples);
  if (scene::wantsPaths(settings)) most = std::max(most, settings.path.samples);
  const int parts = (most + kMaxPassSamples - 1) / kMaxPassSamples;
  for (int* samples : {&settings.ao.samples, &settings.shadows.samples, &settings.path.samples})
    *samples = (*samples + parts - 1) / parts;
  const int64_t passes = int64_t{settings.refine.passes} * parts;
  settings.refine.passes = static_cast<int>(std::min<int64_t>(passes, std::numeric_limits<int>::max()));
}

Refiner::Refiner(const scene::Snapshot& snapshot, Refinement& refinement)
    : snapshot_(snapshot),
      wide_(snapshot.wideColors || (snapshot.layers && snapshot.layers->of == scene::Layers::Of::sums)),
      refinement_(refinement),
      filters_(isDenoised(snapshot)) {
  snapshot_.lightSampling.mode = scene::LightSampling::Mode::full;
  divideIntoPasses(snapshot_.settings);
  if (usesWideColors(snapshot)) {
    snapshot_.wideColors = true;
    snapshot_.byteSamples = averagesSamples(snapshot.settings, snapshot.samples);
  }
  refinement.judge(judgedOf(snapshot)), refinement.setByteSamples(snapshot_.byteSamples);
  if (filters_ || snapshot.settings.look == Look::noise) refinement.keepNoise();
}

bool Refiner::wantsFeatures() const {
  const bool varies = hasOpenLens(snapshot_.settings) && image_.isAverages();
  const uint32_t wanted = varies ? std::min(refinement_.passes() + 1, kLensFeatures) : 1;
  return filters_ && refinement_.features.passes < wanted;
}

/// False with a line in `error`: there are none; without one: tracing was interrupted.
bool Refiner::traceFeatures(const Trace& trace, scene::TraceCost& cost, std::string& error) {
  using Mode = scene::LightSampling::Mode;
  const scene::Snapshot planes = featuresOf(snapshot_, image_);
  AuxiliaryFeatures found = refinement_.features;
  const bool mixed = image_.isAverages() || snapshot_.layers;
  Image image;
  for (const Mode mode : {Mode::reflectance, Mode::geometry, Mode::noiseless}) {
    if (mode == Mode::noiseless && !wantsNoiseless(snapshot_)) continue;
    // Light without noise is a part of the image, with its tone.
    scene::Snapshot features = mode == Mode::noiseless ? snapshot_ : planes;
    features.lightSampling = {.mode = mode, .pass = snapshot_.lightSampling.pass};
    try {
      if (snapshot_.catches && mode == Mode::reflectance) {
        keepCatcher(image_.depth.size(), found);
        continue;
      }
      scene::TraceCost own;
      if (!trace(features, image, own, error)) return cost.loss = own.loss, false;
      addCost(own, cost);
      keepFeatures(mode, image, mixed, found);
    } catch (const std::bad_alloc&) {
      cost.loss = scene::Loss::frames;
      return error = "out of memory", false;
    }
  }
  ++found.passes;
  found.backdrop = image_.isAverages() && snapshot_.backdrop;
  found.catcher = snapshot_.catches || (hasCatcher(snapshot_) && !snapshot_.backdrop);
  refinement_.features = std::move(found);
  return true;
}

bool Refiner::pass(const Trace& trace, uint32_t missColor, scene::TraceCost& cost, std::string& error) {
  try {
    snapshot_.lightSampling.pass = refinement_.passes();
    if (snapshot_.settings.refine.adaptive && isSimple(snapshot_))
      refinement_.leaveOut(kQuiet * double{snapshot_.settings.noise});
    snapshot_.lightSampling.tiles = whole_ ? refinement_.tiles() : nullptr;
    image_.missColor = missColor;
    scene::TraceCost own;
    const double start = nowSeconds();
    if (!trace(snapshot_, image_, own, error)) return cost.loss = own.loss, whole_ = false;
    refinement_.addTime(nowSeconds() - start);
    addCost(own, cost);
    elsewhere_ = own.elsewhere, finishedElsewhere_ = own.refined;
    if (elsewhere_) return true;
    whole_ = true;
    if (wantsFeatures() && !traceFeatures(trace, cost, error)) {
      if (error.empty()) return whole_ = false;
      logNoFilter(error);
      filters_ = false, error.clear();
    }
    refinement_.add(image_);
    return true;
  } catch (const std::exception& e) {
    cost.loss = scene::lossOf(e);
    error = "out of memory while refining an image";
    return false;
  }
}

void Refiner::show(Image& out) const {
  const uint32_t missColor = out.missColor;
  if (snapshot_.layers) out.missColor = 0;  // as layers without fragments
  refinement_.show(image_, wide_, out);
  out.missColor = missColor;
  if (snapshot_.settings.look == Look::noise && !snapshot_.layers)
    return paintNoise(refinement_.pixelNoise(), snapshot_.settings.noise, out);
  if (filters_ && !denoise(refinement_, snapshot_.settings, out)) refinement_.show(image_, wide_, out);
}

}  // namespace gluray::frame
