// The look of catchers: nothing but the light that surfaces take from them. Tracing threads.
#pragma once
#include "render/integrators/factors.h"
#include "render/integrators/integrator.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace gluray::render {

/// Colours become black with the share of light that does not arrive as opacity, 1 - L / L0: `rows` with and
/// `open` without all other surfaces, both as luminance. Nothing falls on what no light reaches anyway.
void showTaken(const ColorRows& open, ColorRows& rows);

/// Another integrator, but for hits on the catcher, of which it shows what is taken.
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

/// All surfaces are catchers (scene::Snapshot::catches). The factors are those of `light`.
class AllCaught final : public FactorIntegrator {
 public:
  explicit AllCaught(std::unique_ptr<const FactorIntegrator> light) : light_(std::move(light)) {}
  UsedFactors used() const noexcept override { return light_->used(); }
  void estimate(const AskedPoints& points, Factors& factors) const noexcept override {
    light_->estimate(points, factors);
  }
  void locate(const ColoredHits& hits, AskedPoints& points) const noexcept override {
    light_->locate(hits, points);
  }
  bool replaces(uint32_t, uint32_t, const Factors&) const noexcept override { return false; }
  void apply(const ColoredHits&, const Factors&, ColorRows&) const noexcept override;
  std::vector<float> meaning() const override { return light_->meaning(); }

 private:
  std::unique_ptr<const FactorIntegrator> light_;
};

/// All surfaces are catchers, and nothing takes light from them.
class NothingCaught final : public Integrator {
 public:
  void light(const ColoredHits&, ColorRows& rows) const noexcept override {
    const ColorRows open = rows;
    showTaken(open, rows);
  }
};

}  // namespace gluray::render
