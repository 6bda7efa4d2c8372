// Light transport as factors of the local look: traced first, perhaps filtered, then applied. Tracing
// threads.
#pragma once
#include "render/integrators/integrator.h"
#include "render/integrators/surface_points.h"

#include <algorithm>
#include <vector>

namespace gluray::render {

/// Lights of a frame that cast shadows, at most. Further ones, those of least strength, cast none.
constexpr int kShadowLights = 4;

/// Factors of a packet's colours. Lanes outside the group have no meaning, nor have rows that the integrator
/// does not use (FactorIntegrator::used).
struct Factors {
  alignas(64) Row occlusion;  // the share of light from the surroundings that arrives: 0 .. 1
  // The shares of shadow light r that arrive: 0 .. 1, red, green and blue. Grey (three equal rows) unless
  // translucent surfaces colour shadows.
  alignas(64) Row visibility[kShadowLights][3];
};

/// Which of the factors an integrator uses; the same for all of a frame's hits.
struct UsedFactors {
  bool occlusion = false;
  int lights = 0;        // rows of Factors::visibility
  bool colored = false;  // their channels may differ
  bool operator==(const UsedFactors&) const = default;
};

/// An integrator whose noise is in factors alone, so that these can be filtered without blurring colours.
class FactorIntegrator : public Integrator {
 public:
  virtual UsedFactors used() const noexcept = 0;
  /// Traces rays for the points' lanes.
  virtual void estimate(const AskedPoints&, Factors&) const noexcept = 0;
  /// The points of hits, for estimate().
  virtual void locate(const ColoredHits&, AskedPoints&) const noexcept = 0;
  /// Whether apply() would compute the colours anew from the surface, so that they need not be there before.
  virtual bool replaces(uint32_t instance, uint32_t lanes, const Factors&) const noexcept = 0;
  /// Applies factors to colours of the local look.
  virtual void apply(const ColoredHits&, const Factors&, ColorRows&) const noexcept = 0;
  /// Numbers that stay the same, up to rounding, while nothing but the camera moves and factors mean the
  /// same: places and directions of lights in the world.
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
