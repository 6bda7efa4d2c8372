#include "frame/refiner.h"

#include "render/integrators/integrator.h"

#include <algorithm>
#include <exception>

namespace gluray::frame {
namespace {

constexpr size_t kMostBytes = size_t{1} << 30;  // of sums

size_t valuesOf(const scene::Snapshot& s) {
  return static_cast<size_t>(s.region.width) * static_cast<size_t>(s.region.height) *
         static_cast<size_t>(std::max(s.samples, 1));
}

/// Whether passes have wide colours where the picture has bytes. Layers and averages are made of bytes: wide
/// colours would change the local look.
bool usesWideColors(const scene::Snapshot& s) {
  return !s.wideColors && !s.layers && (s.samples > 1 || s.settings.spp <= 1);
}

void addCost(const scene::TraceCost& more, scene::TraceCost& cost) {
  const double build = cost.buildSeconds, trace = cost.traceSeconds;
  const uint64_t blas = cost.blasBuilds, tlas = cost.tlasBuilds, refinements = cost.blasRefinements;
  cost = more;
  cost.buildSeconds += build, cost.traceSeconds += trace;
  cost.blasBuilds += blas, cost.tlasBuilds += tlas, cost.blasRefinements += refinements;
}

}  // namespace

bool isRefinable(const scene::Snapshot& snapshot) {
  return render::areLit(snapshot.settings) && snapshot.settings.noise > 0 &&
         snapshot.settings.renderer == Renderer::embree &&
         Refinement::bytesFor(valuesOf(snapshot)) <= kMostBytes;
}

bool isFinished(const Refinement& refinement, const Settings& settings) {
  const uint32_t passes = refinement.passes();
  if (passes >= static_cast<uint32_t>(settings.refine.passes)) return true;
  return passes >= kLeastPasses && refinement.noise() <= double{settings.noise};
}

Refiner::Refiner(const scene::Snapshot& snapshot, Refinement& refinement)
    : snapshot_(snapshot),
      wide_(snapshot.wideColors || (snapshot.layers && snapshot.layers->of == scene::Layers::Of::sums)),
      refinement_(refinement) {
  snapshot_.lightSampling.mode = scene::LightSampling::Mode::full;
  if (usesWideColors(snapshot)) snapshot_.wideColors = true;
}

bool Refiner::pass(const Trace& trace, uint32_t missColor, scene::TraceCost& cost, std::string& error) {
  snapshot_.lightSampling.pass = refinement_.passes();
  image_.missColor = missColor;
  scene::TraceCost own;
  if (!trace(snapshot_, image_, own, error)) return false;
  addCost(own, cost);
  try {
    refinement_.add(image_);
    return true;
  } catch (const std::exception&) {
    error = "out of memory while refining a picture";
    return false;
  }
}

}  // namespace gluray::frame
