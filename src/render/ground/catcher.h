// The look of a catcher: nothing but the light that surfaces take from it. Tracing threads.
#pragma once
#include "render/integrators/integrator.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace gluray::render {

/// Another integrator, but for hits on the catcher. Their colours become black with the share of light that
/// does not arrive as opacity, 1 - L / L0: L with and L0 without all other surfaces, both as luminance.
/// Nothing falls on what no light reaches anyway.
class CatcherLook final : public Integrator {
 public:
  /// `light` must not be null; `catcher`: the instance.
  CatcherLook(std::unique_ptr<const Integrator> light, uint32_t catcher)
      : light_(std::move(light)), catcher_(catcher) {}
  void light(const ColoredHits&, ColorRows&) const noexcept override;

 private:
  std::unique_ptr<const Integrator> light_;
  uint32_t catcher_;
};

}  // namespace gluray::render
