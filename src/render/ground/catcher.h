// The look of catchers: nothing but the light that surfaces take from them. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace gluray::render {

/// Another integrator, but for hits on catchers. Their colours become black with the share of light that
/// does not arrive as opacity, 1 - L / L0: L with and L0 without all other surfaces, both as luminance.
/// Nothing falls on what no light reaches anyway.
class CatcherLook final : public Integrator {
 public:
  /// Surfaces that catch.
  struct Catchers {
    bool all = false;
    uint32_t instance = accel::kNoHit;  // unless all do
  };
  /// `light`: null where surfaces take no light from each other.
  CatcherLook(std::unique_ptr<const Integrator> light, const Catchers& catchers)
      : light_(std::move(light)), catchers_(catchers) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

 private:
  std::unique_ptr<const Integrator> light_;
  Catchers catchers_;
};

}  // namespace gluray::render
