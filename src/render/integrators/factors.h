// Light transport as factors of the local look: traced first, perhaps filtered, then applied. Tracing
// threads.
#pragma once
#include "render/integrators/integrator.h"

namespace gluray::render {

/// Factors of a packet's colours. Lanes outside the group have no meaning.
struct Factors {
  alignas(64) Row occlusion;  // the share of light from the surroundings that arrives: 0 .. 1
};

/// An integrator whose noise is in factors alone, so that these can be filtered without blurring colours.
class FactorIntegrator : public Integrator {
 public:
  /// Traces rays for the group's lanes.
  virtual void estimate(const ColoredHits&, Factors&) const noexcept = 0;
  /// Applies factors to colours of the local look.
  virtual void apply(const ColoredHits&, const Factors&, ColorRows&) const noexcept = 0;
  void light(const ColoredHits& hits, ColorRows& rows) const noexcept final {
    Factors factors;
    estimate(hits, factors);
    apply(hits, factors, rows);
  }
};

}  // namespace gluray::render
