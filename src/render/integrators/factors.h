// Light transport as factors of the local look: traced first, perhaps filtered, then applied. Tracing
// threads.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/surface_points.h"

#include <algorithm>
#include <vector>

namespace gluray::render {

/// Maximum number of lights with shadows in a frame; the weakest lights beyond it cast none.
constexpr int kShadowLights = 4;

/// Factors of a packet's colours. Lanes outside the group are undefined, as are rows that the integrator does
/// not use (FactorIntegrator::used).
struct Factors {
  alignas(64) Row occlusion;  // unoccluded fraction of ambient light: 0 .. 1
  // Visibility of shadow light r: 0 .. 1, red, green and blue. The three rows are equal unless translucent
  // surfaces tint shadows.
  alignas(64) Row visibility[kShadowLights][3];
};

/// Which of the factors an integrator uses; the same for all of a frame's hits.
struct UsedFactors {
  bool occlusion = false;
  int lights = 0;        // rows of Factors::visibility
  bool colored = false;  // their channels may differ
  bool operator==(const UsedFactors&) const = default;
};

/// An integrator whose noise is confined to factors, so that a filter does not blur colours.
class FactorIntegrator : public Integrator {
 public:
  virtual UsedFactors used() const noexcept = 0;
  /// Traces rays for the points in `lanes`.
  virtual void estimate(const AskedPoints&, Factors&) const noexcept = 0;
  /// The points of hits, for estimate().
  virtual void locate(const ColoredHits&, AskedPoints&) const noexcept = 0;
  /// Whether apply() would compute the colours anew from the surface, so that they need not be there before.
  virtual bool replaces(uint32_t instance, uint32_t lanes, const Factors&) const noexcept = 0;
  /// Applies factors to colours of the local look.
  virtual void apply(const ColoredHits&, const Factors&, ColorRows&) const noexcept = 0;
  /// World-space positions and directions of lights. Earlier factors are reusable while these numbers stay
  /// equal, up to rounding.
  virtual std::vector<float> meaning() const { return {}; }
  void light(const ColoredHits& hits, ColorRows& rows) const noexcept final {
    if (hits.factors) return apply(hits, *hits.factors, rows);
    AskedPoints points;
    locate(hits, points);
    Factors factors;
    estimate(points, factors);
    apply(hits, factors, rows);
  }
  void lightAlone(const ColoredHits& hits, ColorRows& rows) const noexcept final {
    Factors all;
    std::fill_n(all.occlusion, kLanes, 1.0f);
    std::fill_n(&all.visibility[0][0][0], kShadowLights * 3 * kLanes, 1.0f);
    apply(hits, all, rows);
  }
};

}  // namespace gluray::render
